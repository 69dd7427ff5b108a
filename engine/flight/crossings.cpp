#include "flight/crossings.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "flight/ground.h"

namespace flyrock {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

}  // namespace

/// The first root of ahead = v t + a t^2 / 2, in the form that does not subtract. Without air, a is 0.
template <int D>
double arrival(const Path<D>& path, double x, int side, int axis) {
  const double ahead = side * (x - path.x[axis]), speed = side * path.v[axis];
  if (ahead <= 0) return 0;
  if (ahead == never) return never;
  const double push = side * path.a[axis], discriminant = speed * speed + 2 * push * ahead;
  if (discriminant < 0) return never;
  const double root = std::sqrt(discriminant);
  if (speed < 0) return push > 0 ? (root - speed) / push : never;
  return speed + root > 0 ? 2 * ahead / (speed + root) : never;
}

template <int D>
Crossings<D>::Crossings(World<D>& world, std::span<const Gate> gates, std::span<const Barrier> barriers,
                        std::vector<BodyHistory>& histories)
    : world_(world), gates_(gates), barriers_(barriers), histories_(histories) {
  for (const Body<D>& body : world.bodies) {
    gate_side_.push_back(sides_of(gates, body.x.x()));
    barrier_side_.push_back(sides_of(barriers, body.x.x()));
  }
}

template <int D>
double Crossings<D>::time_to_barrier(int body, const Path<D>& path) const {
  double first = never;
  for (std::size_t b = 0; b < barriers_.size(); ++b)
    if (const int side = barrier_side_[body][b]; side != 0)
      first = std::min(first, arrival<D>(path, barriers_[b].x, side));
  return first;
}

template <int D>
bool Crossings<D>::moved(int body, const Motion& motion, double start, double dt) {
  const Body<D>& b = world_.bodies[body];
  for (std::size_t g = 0; g < gates_.size(); ++g) {
    if (gate_side_[body][g] == 0) continue;
    const double t = arrival<D>(motion, gates_[g].x, gate_side_[body][g]);
    if (t > dt) continue;
    gate_side_[body][g] = 0;
    const Turned<D> turned = turn_at(motion, t);
    const double speed = motion.velocity(t).norm();
    const double energy = 0.5 * (b.mass * speed * speed + twice_spin_energy(b, turned.attitude, turned.spin));
    histories_[body].passages.push_back(
        {static_cast<int>(g), start + t, speed, energy, height(motion.position(t), gates_[g].x)});
  }
  for (std::size_t k = 0; k < barriers_.size(); ++k) {
    if (barrier_side_[body][k] == 0 || arrival<D>(motion, barriers_[k].x, barrier_side_[body][k]) > dt)
      continue;
    barrier_side_[body][k] = 0;
    if (catches(static_cast<int>(k), body)) return true;
  }
  return false;
}

template <int D>
double Crossings<D>::height(const Vec<D>& place, double x) const {
  const auto ground = ground_height(world_.terrain(), at_x<D>(place, x));
  return ground ? place[D - 1] - *ground : never;
}

template <int D>
bool Crossings<D>::catches(int barrier, int body) {
  const Barrier& fence = barriers_[barrier];
  Body<D>& b = world_.bodies[body];
  const BarrierHit hit =
      meet(fence, barrier, {world_.time, b.v.norm(), b.kinetic_energy(), height(b.x, fence.x)});
  const double left = velocity_left(fence, hit);
  b.v *= left;
  b.w *= left;
  histories_[body].barriers.push_back(hit);
  return hit.outcome == BarrierOutcome::caught;
}

template double arrival(const Path<2>&, double, int, int);
template double arrival(const Path<3>&, double, int, int);
template class Crossings<2>;
template class Crossings<3>;

}  // namespace flyrock
