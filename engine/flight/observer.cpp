#include "flight/observer.h"

#include <algorithm>
#include <cmath>

namespace flyrock {

Observer::Observer(const World<2>& world, double every, bool keep_impacts, double bin_width,
                   std::vector<BodyHistory>& histories)
    : world_(world),
      every_(every),
      keep_impacts_(keep_impacts),
      histories_(histories),
      next_sample_(world.bodies.size(), world.time),
      first_contact_height_(world.bodies.size(), 0.0),
      has_flown_(world.bodies.size(), false),
      has_landed_(world.bodies.size(), false),
      mode_(world.bodies.size(), TravelMode::flight) {
  histories_.resize(world.bodies.size());
  for (std::size_t i = 0; i < histories_.size(); ++i) {
    BodyHistory& history = histories_[i];
    history = {};
    if (world.bodies[i].kind == BodyKind::dynamic)
      history.path = PathBins(bin_width, world.terrain().profile().x_min(), world.terrain().profile().x_max());
    const int body = static_cast<int>(i);
    history.first = history.last = history.min = history.max = state(body, world.flight_of(body), 0, world.time);
    history.min_speed = history.max_speed = history.first.velocity.norm();
    clearance(body, world.flight_of(body), 0);
    speeds(body, world.flight_of(body), 0);
    store(body, history.first);
  }
}

BodyState Observer::state(int body, const Motion2& motion, double t, double time) const {
  const Body<2>& b = world_.bodies[body];
  BodyState state;
  state.time = time;
  state.position.head<2>() = motion.position(t);
  state.velocity.head<2>() = motion.velocity(t);
  state.spin.z() = motion.spin(t);
  state.angle = motion.angle_at(t);
  if (b.kind == BodyKind::dynamic)
    state.kinetic_energy =
        0.5 * (b.mass * state.velocity.squaredNorm() + b.inertia * state.spin.z() * state.spin.z());
  return state;
}

void Observer::extremes(int body, const BodyState& s) {
  if (!s.position.allFinite() || !s.velocity.allFinite()) return;  // NaN does not enter a history
  BodyHistory& h = histories_[body];
  const auto widen = [](auto& low, auto& high, const auto& value) {
    low = low.cwiseMin(value);
    high = high.cwiseMax(value);
  };
  widen(h.min.position, h.max.position, s.position);
  widen(h.min.velocity, h.max.velocity, s.velocity);
  widen(h.min.spin, h.max.spin, s.spin);
  h.min.angle = std::min(h.min.angle, s.angle);
  h.max.angle = std::max(h.max.angle, s.angle);
  h.min.kinetic_energy = std::min(h.min.kinetic_energy, s.kinetic_energy);
  h.max.kinetic_energy = std::max(h.max.kinetic_energy, s.kinetic_energy);
  const double speed = s.velocity.norm();
  h.min_speed = std::min(h.min_speed, speed);
  h.max_speed = std::max(h.max_speed, speed);
  h.max_distance = std::max(h.max_distance, std::abs(s.position.x() - h.first.position.x()));
  h.last = s;
}

void Observer::store(int body, const BodyState& s) {
  if (every_ <= 0) return;
  auto& points = histories_[body].trajectory;
  if (!points.empty() && points.back().state.time == s.time) {
    points.back().state = s;  // an impact changes the velocity, not how the body arrived
  } else {
    points.push_back({s, mode_[body]});
  }
}

/// The greatest height above the ground along the flight, in all and in each bin: over each segment a quadratic of time.
void Observer::clearance(int body, const Motion2& motion, double dt) {
  BodyHistory& history = histories_[body];
  const Terrain2& terrain = world_.terrain();
  const Vec2 end = motion.position(dt);
  const double low = std::min(motion.x.x(), end.x()), high = std::max(motion.x.x(), end.x());
  const auto run = terrain.segments_between(low, high);
  for (int i = run.first; i <= run.last; ++i) {
    const Vec2 &a = terrain.start(i), &b = terrain.end(i);
    if (b.x() <= a.x()) continue;  // vertical: its top belongs to a neighbour
    double from = 0, to = dt;
    if (motion.v.x() != 0) {
      const double t1 = (a.x() - motion.x.x()) / motion.v.x(), t2 = (b.x() - motion.x.x()) / motion.v.x();
      from = std::max(from, std::min(t1, t2));
      to = std::min(to, std::max(t1, t2));
      if (from > to) continue;
    }
    const double slope = (b.y() - a.y()) / (b.x() - a.x());
    const auto above = [&](double t) {
      const Vec2 p = motion.position(t);
      return p.y() - (a.y() + slope * (p.x() - a.x()));
    };
    const double top = motion.a.y() < 0 ? (motion.v.y() - slope * motion.v.x()) / -motion.a.y() : from;
    const auto highest = [&](double t0, double t1) {
      return std::max({above(t0), above(std::clamp(top, t0, t1)), above(t1)});
    };
    history.bounce_height = std::max(history.bounce_height, highest(from, to));
    history.path.visit(motion.x.x(), motion.v.x(), from, to, [&](PathBin& bin, double t0, double t1) {
      bin.height = std::max(bin.height, highest(t0, t1));
    });
  }
}

/// The greatest speed and energy in each bin: squares of speeds are convex in time, so that they are at an end.
void Observer::speeds(int body, const Motion2& motion, double dt) {
  histories_[body].path.visit(motion.x.x(), motion.v.x(), 0, dt, [&](PathBin& bin, double t0, double t1) {
    for (const double t : {t0, t1}) {
      const BodyState s = state(body, motion, t, 0);
      bin.speed = std::max(bin.speed, s.velocity.norm());
      bin.energy = std::max(bin.energy, s.kinetic_energy);
    }
  });
}

void Observer::flew(int body, const Motion2& motion, double start, double dt) {
  BodyHistory& h = histories_[body];
  if (dt > 0) has_flown_[body] = true;
  store(body, state(body, motion, 0, start));
  mode_[body] = has_landed_[body] ? TravelMode::bounce : TravelMode::flight;
  h.travel.add(mode_[body], dt, path_length(motion, dt));
  const double apex = motion.a.y() < 0 ? motion.v.y() / -motion.a.y() : -1;
  if (apex > 0 && apex <= dt) {
    const BodyState top = state(body, motion, apex, start + apex);
    extremes(body, top);
    if (keep_impacts_ && world_.bodies[body].impacts > 0) h.apexes.push_back({top.time, top.position.y() - first_contact_height_[body]});
  }
  clearance(body, motion, dt);
  speeds(body, motion, dt);
  if (every_ > 0) {
    for (; next_sample_[body] < start + dt; next_sample_[body] += every_)
      if (next_sample_[body] > start) store(body, state(body, motion, next_sample_[body] - start, next_sample_[body]));
  }
  const BodyState end = state(body, motion, dt, start + dt);
  extremes(body, end);
  store(body, end);
}

void Observer::stepped(int body, const Motion2& motion, double dt, TravelMode mode) {
  histories_[body].contact_time += dt;
  mode_[body] = mode;
  histories_[body].travel.add(mode, dt, path_length(motion, dt));
  const Motion2 now = world_.flight_of(body);
  const BodyState s = state(body, now, 0, world_.time);
  extremes(body, s);
  clearance(body, motion, dt);
  histories_[body].path.visit(motion.x.x(), motion.v.x(), 0, dt, [&](PathBin& bin, double, double) {
    bin.speed = std::max(bin.speed, s.velocity.norm());
    bin.energy = std::max(bin.energy, s.kinetic_energy);
  });
  if (every_ > 0 && world_.time >= next_sample_[body]) {
    store(body, s);
    while (next_sample_[body] <= world_.time) next_sample_[body] += every_;
  }
}

void Observer::impacts() {
  for (const Impact& impact : world_.impacts()) {
    for (const int body : {impact.body, impact.other}) {
      if (body < 0) continue;
      BodyHistory& h = histories_[body];
      if (h.impact_count++ == 0) first_contact_height_[body] = world_.bodies[body].x.y();
      if (!keep_impacts_) continue;
      h.impacts.push_back(impact);
      h.impacts.back().number = h.impact_count;
    }
  }
  for (std::size_t i = 0; i < world_.bodies.size(); ++i)
    extremes(static_cast<int>(i), state(static_cast<int>(i), world_.flight_of(static_cast<int>(i)), 0, world_.time));
}

void Observer::touched(int body) {
  if (has_landed_[body] || !has_flown_[body]) return;
  has_landed_[body] = true;
  BodyHistory& h = histories_[body];
  h.flight_range = std::abs(world_.bodies[body].x.x() - h.first.position.x());
}

void Observer::ended(int body, StopReason reason) {
  BodyHistory& h = histories_[body];
  h.reason = reason;
  if (reason != StopReason::diverged) h.last = state(body, world_.flight_of(body), 0, world_.time);
  const bool flew_away = reason == StopReason::left_domain || reason == StopReason::caught;
  if (flew_away && !has_landed_[body]) h.flight_range = h.max_distance;
  store(body, h.last);
}

}  // namespace flyrock
