#include "batch/fixture.h"

#include "flight/body_state.h"

namespace flyrock {

template <int D>
Fixture fixture_of(const World<D>& world, const Body<D>& body) {
  Fixture fixture{body.group, state_of(body, world.time), quaternion_of(body.attitude)};
  fixture.start.position.template head<D>() += world.origin;
  if (body.kind == BodyKind::driven) fixture.acceleration.template head<D>() = body.push;
  return fixture;
}

namespace {

/// A fixture after the time dt [s] of its motion.
Fixture after(const Fixture& from, double dt) {
  Fixture moved = from;
  moved.start.time += dt;
  moved.start.position += dt * from.start.velocity + 0.5 * dt * dt * from.acceleration;
  moved.start.velocity += dt * from.acceleration;
  moved.start.angle += dt * from.start.spin.z();
  const auto& [w, x, y, z] = from.turn;
  const Rotation3 turned =
      Rotation3::from_vector(dt * from.start.spin) * Rotation3(Eigen::Quaterniond(w, x, y, z));
  moved.turn = quaternion_of(Attitude<3>(turned));
  return moved;
}

}  // namespace

std::vector<Fixture> pieces_of(Fixture first, const OverTime* velocity) {
  std::vector<Fixture> pieces{std::move(first)};
  while (velocity) {
    Fixture& piece = pieces.back();
    const double time = piece.start.time, end = velocity->next_row(time);
    piece.start.velocity = velocity->at(time);
    piece.acceleration.setZero();
    if (end == infinite) break;
    piece.acceleration = (velocity->at(end) - piece.start.velocity) / (end - time);
    pieces.push_back(after(piece, end - time));
    pieces.back().start.time = end;
  }
  return pieces;
}

template Fixture fixture_of(const World<2>&, const Body<2>&);
template Fixture fixture_of(const World<3>&, const Body<3>&);

}  // namespace flyrock
