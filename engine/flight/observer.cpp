#include "flight/observer.h"

#include <algorithm>
#include <cmath>

#include "flight/body_state.h"
#include "flight/ground.h"
#include "flight/over_cells.h"

namespace flyrock {

namespace {

/// Attitude and spin as results need them: in 2D the angle alone, without the sine and cosine of a rotation.
Turned<2> turn_for_results(const Motion2& motion, double t) {
  Attitude<2> attitude;
  attitude.angle = motion.angle_at(t);
  return {attitude, motion.spin(t)};
}
Turned<3> turn_for_results(const Motion3& motion, double t) { return turn_at(motion, t); }

}  // namespace

template <int D>
Observer<D>::Observer(const World<D>& world, double every, bool keep_impacts, double bin_width,
                      std::span<PlanCells> cells, std::vector<BodyHistory>& histories)
    : world_(world),
      every_(every),
      keep_impacts_(keep_impacts),
      cells_(cells),
      histories_(histories),
      next_sample_(world.bodies.size(), world.time),
      first_contact_height_(world.bodies.size(), 0.0),
      has_flown_(world.bodies.size(), false),
      mode_(world.bodies.size(), TravelMode::flight) {
  const auto domain = domain_of(world.terrain());
  histories_.resize(world.bodies.size());
  for (std::size_t i = 0; i < histories_.size(); ++i) {
    BodyHistory& history = histories_[i];
    history = {};
    if (world.bodies[i].kind == BodyKind::dynamic && bin_width > 0)
      history.path = PathBins(bin_width, domain.low[0], domain.high[0]);
    const int body = static_cast<int>(i);
    history.begin(present(body));
    const Motion now = world.flight_of(body);
    clearance(body, now, 0);
    speeds(body, now, 0);
    map(body, now, 0, [&](double) { return now.v.squaredNorm(); });
    store(body, history.first, world.bodies[i].attitude);
  }
}

template <int D>
BodyState Observer<D>::along(int body, const Motion& motion, double t, double time) const {
  return state_of(world_.bodies[body], time, motion.position(t), motion.velocity(t),
                  turn_for_results(motion, t));
}

template <int D>
BodyState Observer<D>::present(int body) const {
  return state_of(world_.bodies[body], world_.time);
}

template <int D>
void Observer<D>::extremes(int body, const BodyState& s) {
  if (!s.position.allFinite() || !s.velocity.allFinite()) return;  // keep NaN out of the history
  BodyHistory& h = histories_[body];
  h.include(s);
  h.max_distance =
      std::max(h.max_distance, horizontal(Vec<D>((s.position - h.first.position).template head<D>())));
  h.last = s;
}

template <int D>
void Observer<D>::store(int body, const BodyState& s, const Attitude<D>& attitude) {
  if (every_ <= 0) return;
  auto& points = histories_[body].trajectory;
  if (!points.empty() && points.back().state.time == s.time) {
    points.back().state = s;  // an impact changes the velocity, but not the mode in which the body arrived
  } else {
    points.push_back({s, mode_[body], quaternion_of(attitude)});
  }
}

template <int D>
void Observer<D>::store(int body, const Motion& motion, double t, double time) {
  if (every_ <= 0) return;
  store(body, along(body, motion, t, time), turn_for_results(motion, t).attitude);
}

template <int D>
void Observer<D>::clearance(int body, const Path<D>& path, double dt) {
  BodyHistory& history = histories_[body];
  const double rate = rate_along_x(path, dt);
  visit_heights(world_.terrain(), path, dt, [&](double from, double to, const auto& highest) {
    history.bounce_height = std::max(history.bounce_height, highest(from, to));
    history.path.visit(path.x.x(), rate, from, to, [&](PathBin& bin, double t0, double t1) {
      bin.height = std::max(bin.height, highest(t0, t1));
    });
  });
}

/// Finds the greatest speed and energy in each bin. They occur at an end, because squares of speeds are
/// convex in time. Rotation keeps its energy.
template <int D>
void Observer<D>::speeds(int body, const Motion& motion, double dt) {
  const Body<D>& b = world_.bodies[body];
  const double twice_spin = twice_spin_energy(b, b.attitude, b.w);
  histories_[body].path.visit(motion.x.x(), rate_along_x<D>(motion, dt), 0, dt,
                              [&](PathBin& bin, double t0, double t1) {
                                for (const double t : {t0, t1}) {
                                  const double squared = motion.velocity(t).squaredNorm();
                                  bin.speed = std::max(bin.speed, std::sqrt(squared));
                                  bin.energy = std::max(bin.energy, 0.5 * (b.mass * squared + twice_spin));
                                }
                              });
}

/// Records a path for maps. Rotation keeps its energy in free flight.
template <int D>
template <class SquaredSpeed>
void Observer<D>::map(int body, const Path<D>& path, double dt, SquaredSpeed squared_speed) {
  if (cells_.empty()) return;
  const Body<D>& b = world_.bodies[body];
  const double twice_spin = twice_spin_energy(b, b.attitude, b.w);
  over_cells(world_.terrain(), path, dt, cells_[body], squared_speed,
             [&](double squared) { return 0.5 * (b.mass * squared + twice_spin); });
}

template <int D>
void Observer<D>::flew(int body, const Motion& motion, double start, double dt) {
  BodyHistory& h = histories_[body];
  if (dt > 0) has_flown_[body] = true;
  store(body, motion, 0, start);
  mode_[body] = h.landed ? TravelMode::bounce : TravelMode::flight;
  h.travel.add(mode_[body], dt, path_length<D>(motion, dt));
  const double apex = motion.a[up] < 0 ? motion.v[up] / -motion.a[up] : -1;
  if (apex > 0 && apex <= dt) {
    const BodyState top = along(body, motion, apex, start + apex);
    extremes(body, top);
    if (keep_impacts_ && world_.bodies[body].impacts > 0)
      h.apexes.push_back({top.time, top.position[up] - first_contact_height_[body]});
  }
  clearance(body, motion, dt);
  speeds(body, motion, dt);
  map(body, motion, dt, [&](double t) { return motion.velocity(t).squaredNorm(); });
  if (every_ > 0) {
    for (; next_sample_[body] < start + dt; next_sample_[body] += every_)
      if (next_sample_[body] > start) store(body, motion, next_sample_[body] - start, next_sample_[body]);
  }
  const BodyState end = along(body, motion, dt, start + dt);
  extremes(body, end);
  store(body, end, turn_for_results(motion, dt).attitude);
}

template <int D>
void Observer<D>::stepped(int body, const Motion& motion, double dt, TravelMode mode) {
  histories_[body].contact_time += dt;
  mode_[body] = mode;
  histories_[body].travel.add(mode, dt, path_length<D>(motion, dt));
  const BodyState s = present(body);
  clearance(body, motion, dt);
  histories_[body].path.visit(motion.x.x(), motion.v.x(), 0, dt, [&](PathBin& bin, double, double) {
    bin.speed = std::max(bin.speed, s.velocity.norm());
    bin.energy = std::max(bin.energy, s.kinetic_energy);
  });
  map(body, motion, dt, [&](double) { return s.velocity.squaredNorm(); });
  if (every_ > 0 && world_.time >= next_sample_[body]) {
    store(body, s, world_.bodies[body].attitude);
    while (next_sample_[body] <= world_.time) next_sample_[body] += every_;
  }
}

template <int D>
void Observer<D>::arrived() {
  for (const Impact& impact : world_.impacts()) {
    for (const int body : {impact.body, impact.other}) {
      if (body < 0) continue;
      BodyHistory& h = histories_[body];
      if (h.impact_count++ == 0) first_contact_height_[body] = world_.bodies[body].x[up];
      if (!keep_impacts_) continue;
      h.impacts.push_back(impact);
      h.impacts.back().number = h.impact_count;
      if (body == impact.other) h.impacts.back().other = impact.body;
    }
  }
  for (std::size_t i = 0; i < world_.bodies.size(); ++i)
    extremes(static_cast<int>(i), present(static_cast<int>(i)));
}

template <int D>
void Observer<D>::landed(int body) {
  BodyHistory& h = histories_[body];
  if (h.landed || !has_flown_[body]) return;
  h.landed = true;
  h.flight_range = horizontal(Vec<D>(world_.bodies[body].x - h.first.position.template head<D>()));
}

template <int D>
void Observer<D>::ended(int body, StopReason reason) {
  BodyHistory& h = histories_[body];
  h.reason = reason;
  if (reason != StopReason::diverged) h.last = present(body);
  if (has_flown_[body] && !h.landed)
    h.flight_range = horizontal(Vec<D>((h.last.position - h.first.position).template head<D>()));
  store(body, h.last, world_.bodies[body].attitude);
}

template class Observer<2>;
template class Observer<3>;

}  // namespace flyrock
