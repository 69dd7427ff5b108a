#include "flight/series_recorder.h"

#include <limits>

#include "elastic/elastic_block.h"
#include "elastic/stress_share.h"
#include "flight/body_state.h"
#include "flight/region_means.h"
#include "world/manifold.h"

namespace flyrock {

template <int D>
SeriesRecorder<D>::SeriesRecorder(const World<D>& world, const SeriesRequest& request)
    : world_(world),
      request_(request),
      rows_(*request.rows),
      next_(world.time + request.every),
      last_row_(world.bodies.size(), -1),
      meshes_(world.bodies.size()) {
  put_bodies();
}

/// Whether the world has come to the time of the next row.
template <int D>
bool SeriesRecorder<D>::due() {
  if (request_.every <= 0) return true;
  if (world_.time < next_) return false;
  while (next_ <= world_.time) next_ += request_.every;
  return true;
}

template <int D>
void SeriesRecorder<D>::flew(std::span<const typename Geometry<D>::Motion> motions, double start, double dt) {
  for (; request_.every > 0 && next_ < start + dt; next_ += request_.every)
    for (int i = 0; i < static_cast<int>(motions.size()); ++i) {
      const Turned<D> turned = turn_at(motions[i], next_ - start);
      put(i,
          state_of(world_.bodies[i], next_, motions[i].position(next_ - start),
                   motions[i].velocity(next_ - start), turned),
          turned.attitude);
    }
  put_bodies();
}

template <int D>
void SeriesRecorder<D>::stepped(double step) {
  if (step <= 0 || !due()) return;
  put_bodies();
  put_contacts(step);
  put_links(step);
  put_regions(step);
  put_solve(step);
}

template <int D>
void SeriesRecorder<D>::before_impact() {
  put_bodies();
}

template <int D>
void SeriesRecorder<D>::after_impact() {
  put_bodies();
  put_contacts(0);
  put_links(0);
  put_solve(0);
}

template <int D>
void SeriesRecorder<D>::put_bodies() {
  for (int i = 0; i < static_cast<int>(world_.bodies.size()); ++i)
    put(i, state_of(world_.bodies[i], world_.time), world_.bodies[i].attitude);
}

/// A state that the body has already at this time is not repeated. A fixed body has one row.
template <int D>
void SeriesRecorder<D>::put(int body, const BodyState& state, const Attitude<D>& attitude) {
  const Body<D>& b = world_.bodies[body];
  if (!wanted(body) || !b.present) return;
  if (const int last = last_row_[body]; last >= 0) {
    if (b.kind == BodyKind::fixed) return;
    const BodyState& before = rows_.bodies[last].state;
    if (before.time == state.time && before.velocity == state.velocity && before.spin == state.spin) return;
  }
  last_row_[body] = static_cast<int>(rows_.bodies.size());
  const Vec<D> place = state.position.template head<D>() + world_.origin;
  rows_.bodies.push_back({request_.names.bodies[body], state,
                          b.kind == BodyKind::dynamic ? -b.mass * world_.gravity().dot(place) : 0,
                          quaternion_of(attitude)});
  rows_.bodies.back().state.position.template head<D>() = place;
  if (b.deforms()) return put_stress(body, state, attitude);
  if (!b.breathes()) return;
  rows_.bodies.back().potential_energy += potential_energy_of_shape(b);
  rows_.bodies.back().radius = b.breathing.now.radius;
}

/// Energy and stress of a deformable block.
template <int D>
void SeriesRecorder<D>::put_stress(int body, const BodyState& state, const Attitude<D>& attitude) {
  const Deformation<D>& own = world_.bodies[body].deformation;
  rows_.bodies.back().potential_energy += own.strain_energy();
  const StressShare share = stress_share(own.block->model, own.u, own.strength);
  rows_.stresses.push_back({.time = state.time,
                            .body = rows_.bodies.back().body,
                            .strain = own.strain_energy(),
                            .vibration = own.vibration_energy(),
                            .damped = own.damped,
                            .touch = own.touch,
                            .settled = own.settled,
                            .tension_1pct = share.tension,
                            .compression_1pct = share.compression,
                            .above_strength = share.above_strength});
  put_mesh(body, state, attitude);
}

/// The nodes and cells of a deformable block, in place of those of an instant when it was stressed less.
template <int D>
void SeriesRecorder<D>::put_mesh(int body, const BodyState& state, const Attitude<D>& attitude) {
  const Deformation<D>& own = world_.bodies[body].deformation;
  const auto& mesh = own.block->model.mesh();
  const SeriesStress& now = rows_.stresses.back();
  std::optional<Mesh>& last = meshes_[static_cast<std::size_t>(body)];
  if (request_.meshes || !last) {
    last = Mesh{now, rows_.nodes.size(), rows_.cells.size()};
    rows_.nodes.resize(last->node + mesh.nodes.size());
    rows_.cells.resize(last->cell + mesh.cells.size());
  } else if (!is_stressed_more(now, last->at)) {
    return;
  }
  last->at = now;
  const auto in_space = [](const Vec<D>& v) {
    Vec3 place = Vec3::Zero();
    place.template head<D>() = v;
    return place;
  };
  const Vec<D> centre = state.position.template head<D>() + world_.origin;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    const int node = static_cast<int>(i);
    const Vec<D> u = own.displacement(node), rate = own.rate.template segment<D>(D * node);
    rows_.nodes[last->node + i] = {.time = now.time,
                                   .body = now.body,
                                   .node = node,
                                   .place = in_space(centre + attitude.rotation * Vec<D>(mesh.nodes[i] + u)),
                                   .displacement = in_space(attitude.rotation * u),
                                   .rate = in_space(attitude.rotation * rate)};
  }
  for (std::size_t i = 0; i < mesh.cells.size(); ++i) {
    const auto& nodes = mesh.cells[i];
    const PrincipalStress stress = principal_stress(own.block->model, static_cast<int>(i), own.u);
    rows_.cells[last->cell + i] = {.time = now.time,
                                   .body = now.body,
                                   .cell = static_cast<int>(i),
                                   .a = nodes[0],
                                   .b = nodes[1],
                                   .c = nodes[2],
                                   .d = D == 3 ? nodes[D] : -1,
                                   .tension = stress.greatest,
                                   .compression = -stress.least};
  }
}

template <int D>
void SeriesRecorder<D>::put_contacts(double step) {
  if (!request_.contacts) return;
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  const auto tangential = [](const auto& row) {
    if constexpr (D == 2) return row[1];
    return row.template segment<D - 1>(1).norm();
  };
  const auto& contacts = world_.contacts();
  int point = 0;
  for (std::size_t a = 0; a < contacts.size(); ++a) {
    const WorldContact<D>& contact = contacts[a];
    const bool same_pair = a > 0 && contacts[a - 1].candidate == contact.candidate &&
                           contacts[a - 1].antagonist == contact.antagonist;
    point = same_pair ? point + 1 : 0;
    if (!wanted(contact.candidate) && !wanted(contact.antagonist)) continue;
    SeriesContact row;
    row.time = world_.time;
    row.a = request_.names.bodies[contact.candidate];
    row.b = antagonist_of(request_.names, world_, contact);
    row.point = point;
    row.step = step;
    row.gap = world_.gap_now(contact);
    row.place.template head<D>() = contact.at.point + world_.origin;
    row.normal.template head<D>() = contact.at.normal;
    if (step == 0) {
      row.rn = row.rt = unknown;
      row.state = SeriesState::before_impact;
      row.un = contact.before[0];
      row.ut = tangential(contact.before);
      rows_.contacts.push_back(row);
      row.state = SeriesState::after_impact;
    }
    row.pn = contact.impulse[0];
    row.pt = tangential(contact.impulse);
    if (step > 0) {
      row.rn = row.pn / step;
      row.rt = row.pt / step;
      row.force.setZero();
      row.force.template head<D>() = contact.impulse_on_candidate() / step;
      row.state = row.pn == 0        ? SeriesState::open
                  : contact.sticking ? SeriesState::sticking
                                     : SeriesState::sliding;
    }
    row.un = world_.velocities_after()[a][0];
    row.ut = tangential(world_.velocities_after()[a]);
    rows_.contacts.push_back(row);
  }
}

/// Of links that hold a body with rows.
template <int D>
void SeriesRecorder<D>::put_links(double step) {
  for (const Link<D>& link : world_.links.list()) {
    if (!wanted(link.a) && !wanted(link.b)) continue;
    const auto [end_a, end_b] = world_.links.ends(link, world_.bodies);
    SeriesLink& row = rows_.links.emplace_back();
    row.time = world_.time;
    row.link = link.name;
    row.step = step;
    row.impulse = link.tension;
    row.force = step > 0 ? link.tension / step : std::numeric_limits<double>::quiet_NaN();
    row.length = (end_a - end_b).norm();
    if (link.type == LinkType::hinge) row.angle = world_.links.angle(link, world_.bodies);
    row.energy = world_.links.energy(link, world_.bodies);
    row.end_a.template head<D>() = end_a + world_.origin;
    row.end_b.template head<D>() = end_b + world_.origin;
  }
}

template <int D>
void SeriesRecorder<D>::put_regions(double step) {
  for (const RegionBox& region : request_.regions)
    rows_.regions.push_back(region_means(world_, region, step));
}

template <int D>
void SeriesRecorder<D>::put_solve(double step) {
  const SolveResult& solve = world_.last_solve();
  rows_.solves.push_back(
      {world_.time, step, static_cast<int>(world_.contacts().size()), solve.iterations, solve.residual});
}

template class SeriesRecorder<2>;
template class SeriesRecorder<3>;

}  // namespace flyrock
