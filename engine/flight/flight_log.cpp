#include "flight/flight_log.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

#include "flight/over_cells.h"
#include "math/polynomial.h"

namespace flyrock {

namespace {

/// The height of the ground at a position [m]. Beyond an end of the terrain, the height at that end.
double ground_at(const Profile& ground, const Vec2& p) {
  return ground.height(std::clamp(p.x(), ground.x_min(), ground.x_max()));
}
double ground_at(const Ground3& ground, const Vec3& p) {
  const Box3& box = ground.extent();
  const Vec3 within = p.cwiseMax(box.low).cwiseMin(box.high);
  const auto top =
      ground.overhangs() ? ground.crossing({within.x(), within.y(), p.z()}, false) : std::nullopt;
  return top ? top->z : ground.height(within.x(), within.y()).value_or(p.z());
}

PathBins bins_over(const Profile& ground, double width) { return {width, ground.x_min(), ground.x_max()}; }
PathBins bins_over(const Ground3& ground, double width) {
  const Box3& box = ground.extent();
  return std::isinf(box.low.x()) ? PathBins() : PathBins(width, box.low.x(), box.high.x());
}

/// The length of the path [m].
template <int D>
double path_length(const Arc<D>& arc, double end) {
  if (arc.is_parabola) return flyrock::path_length<D>(arc.parabola(), end * arc.length);
  return boost::math::quadrature::gauss<double, 7>::integrate(
      [&](double s) { return arc.velocity(s).norm() * arc.length; }, 0.0, end);
}

/// Calls look(s) where the height of the arc above the ground may be greatest, in addition to its ends: above
/// a corner of the ground, and where the path is parallel to the ground.
template <class Look>
void visit_highest(const Arc<2>& arc, const Profile& ground, double end, Look look) {
  const Eigen::AlignedBox2d box = arc.box();
  for (int i = 0; i < ground.segments(); ++i) {
    const Vec2 &a = ground.points[i], &b = ground.points[i + 1];
    if (b.x() < box.min().x() || a.x() > box.max().x()) continue;
    for (const double side : {-1.0, 1.0})
      if (const auto s = first_arrival(arc, b.x(), side, end)) look(*s);
    if (const auto s = first_fall(arc.rate_along(perpendicular(b - a)), 0, end)) look(*s);
  }
}
template <class Look>
void visit_highest(const Arc<3>& arc, const Ground3& ground, double end, Look look) {
  std::vector<Facet> below;
  ground.triangles_under(arc.c[0].head<2>(), arc.position(end).head<2>(), below);
  for (const Facet& f : below) {
    if (const auto s = first_fall(arc.rate_along(f.normal), 0, end)) look(*s);
    for (int i = 0; i < 3 && !f.unbounded; ++i) {
      const Vec3 across(-f.along(i).y(), f.along(i).x(), 0);
      for (const double side : {-1.0, 1.0})
        if (const auto s = first_fall(arc.along(side * across, -side * across.dot(f.corner[i])), 0, end))
          look(*s);
    }
  }
}

}  // namespace

template <int D>
FlightLog<D>::FlightLog(const Body<D>& body, const Terrain& terrain, const PointRun<D>& run)
    : body_(body),
      terrain_(terrain),
      run_(run),
      spin_(Body<D>::no_spin()),
      spin_since_(run.start_time),
      attitude_(body.attitude),
      twice_spin_energy_(0),
      next_sample_(run.start_time),
      to_gates_(approaches(run.gates, in_plan(body.x))) {
  if (run.ends_at_touch) {
    spin_ = body.w;
    twice_spin_energy_ = twice_spin_energy(body, body.attitude, body.w);
  }
  history_.begin(state(run.start_time, body.x, body.v));
  history_.bounce_height = height(body.x);
  history_.path = bins_over(ground_of(terrain), run.bin_width);
}

template <int D>
template <class Curve>
void FlightLog<D>::flew(const Curve& curve, double end) {
  if (end * curve.length > 0) has_flown_ = true;
  see(curve, end, history_.landed ? TravelMode::bounce : TravelMode::flight);
}

template <int D>
void FlightLog<D>::slid(const Arc<D>& arc, double end, TravelMode mode) {
  history_.contact_time += end * arc.length;
  see(arc, end, mode);
}

template <int D>
template <class Curve>
void FlightLog<D>::see(const Curve& curve, double end, TravelMode mode) {
  mode_ = mode;
  if (run_.trajectory_every > 0) sample(curve, end);
  follow(curve, end);
  if (!to_gates_.empty()) pass_gates(curve, end);
  if (run_.trajectory_every > 0 && !run_.ends_at_touch) store(at(curve, end));
}

/// Stores the points of a trajectory along a curve.
template <int D>
template <class Curve>
void FlightLog<D>::sample(const Curve& curve, double end) {
  for (; next_sample_ < curve.time(end); next_sample_ += run_.trajectory_every)
    store(at(curve, (next_sample_ - curve.start) * (curve.end() / curve.length)));
}

/// As for bodies: in closed form, over a straight line in plan.
template <int D>
void FlightLog<D>::follow(const Parabola<D>& path, double end) {
  if (run_.keep_extremes || run_.keep_impacts) apex(path, end);
  widen(path, end);
  over_ground(path, end);
  if (run_.cells) map(path, end);
  history_.travel.add(mode_, end, path_length<D>(path, end));
}

template <int D>
void FlightLog<D>::follow(const Arc<D>& arc, double end) {
  if (!run_.ends_at_touch && arc.is_parabola) return follow(arc.parabola(), end * arc.length);
  history_.travel.add(mode_, end * arc.length, path_length(arc, end));
  turns(arc, end);
  widen(arc, end);
  highest(arc, end);
  bins(arc, end);
  if (run_.cells) map(arc, end);
}

/// The highest place of a parabola. Speed and distance are greatest at the ends of an arc.
template <int D>
void FlightLog<D>::apex(const Parabola<D>& path, double end) {
  const double apex = path.a[D - 1] < 0 ? path.v[D - 1] / -path.a[D - 1] : -1;
  if (!(apex > 0 && apex <= end)) return;
  if (run_.keep_extremes) widen(path, apex);
  if (run_.keep_impacts && history_.impact_count > 0 && mode_ == TravelMode::bounce)
    history_.apexes.push_back({path.time(apex), path.position(apex)[D - 1] - first_contact_height_});
}

template <int D>
void FlightLog<D>::turns(const Arc<D>& arc, double end) {
  const Vec<D> up = Vec<D>::Unit(D - 1);
  if (const auto apex = first_fall(arc.rate_along(up), 0, end); apex && *apex > 0) widen(arc, *apex);
  for (int k = 0; k < D - 1; ++k)  // points at which wind reverses the rock
    for (const double side : {-1.0, 1.0})
      if (const auto turn = first_fall(arc.rate_along(side * Vec<D>::Unit(k)), 0, end); turn && *turn > 0)
        widen(arc, *turn);
}

template <int D>
void FlightLog<D>::land(const Landing<D>& now) {
  history_.landed = true;
  history_.flight_range = horizontal(Vec<D>(now.position - body_.x));
}

template <int D>
void FlightLog<D>::struck(const Landing<D>& after) {
  if (history_.impact_count++ == 0) first_contact_height_ = after.position[D - 1];
  include(after.time, after.position, after.velocity);
  if (run_.trajectory_every > 0) store(state(after.time, after.position, after.velocity));
}

template <int D>
Arrival FlightLog<D>::arrival(const Approach::Arrival& at, const Landing<D>& now) const {
  return {now.time, now.velocity.norm(), energy(now.velocity.squaredNorm()),
          height(moved_to<D>(now.position, at.place)), at.along};
}

template <int D>
void FlightLog<D>::met(const BarrierHit& hit, double left) {
  slow(hit.time, left);
  history_.barriers.push_back(hit);
}

template <int D>
void FlightLog<D>::met(const TreeHit& hit, double left) {
  if (left != 1) slow(hit.time, left);
  history_.trees.push_back(hit);
}

/// The spin is scaled.
template <int D>
void FlightLog<D>::slow(double time, double left) {
  attitude_ = attitude(time);
  spin_since_ = time;
  spin_ *= left;
  twice_spin_energy_ *= left * left;
}

template <int D>
BodyHistory FlightLog<D>::finish(const Landing<D>& end, StopReason reason) {
  history_.reason = reason;
  if (!run_.keep_extremes) {
    history_.max_speed = std::max(history_.max_speed, std::sqrt(max_squared_speed_));
    history_.max.kinetic_energy = std::max(history_.max.kinetic_energy, energy(max_squared_speed_));
  }
  history_.last = state(end.time, end.position, end.velocity);
  if (run_.ends_at_touch && reason == StopReason::stopped) {
    landed(end);
    history_.landed = true;
    history_.stop_time = end.time;
  }
  if (!history_.landed && (has_flown_ || run_.ends_at_touch))
    history_.flight_range = horizontal(Vec<D>(end.position - body_.x));
  if (run_.trajectory_every > 0) store(history_.last);
  return std::move(history_);
}

template <int D>
BodyState FlightLog<D>::state(double time, const Vec<D>& position, const Vec<D>& velocity) const {
  BodyState state;
  state.time = time;
  state.position.template head<D>() = position;
  state.velocity.template head<D>() = velocity;
  if constexpr (D == 2) {
    state.spin.z() = spin_;
    state.angle = attitude_.angle + spin_ * (time - spin_since_);
  } else {
    state.spin = spin_;
  }
  state.kinetic_energy = energy(velocity.squaredNorm());
  return state;
}

template <int D>
template <class Curve>
BodyState FlightLog<D>::at(const Curve& curve, double s) const {
  return state(curve.time(s), curve.position(s), curve.velocity(s));
}

template <int D>
void FlightLog<D>::store(const BodyState& s) {
  auto& points = history_.trajectory;
  if (!run_.ends_at_touch && !points.empty() && points.back().state.time == s.time)
    points.back().state = s;  // an impact changes the velocity, but not the mode in which the point arrived
  else
    points.push_back({s, mode_, quaternion_of(attitude(s.time))});
}

template <int D>
template <class Curve>
void FlightLog<D>::widen(const Curve& curve, double s) {
  const Vec<D> position = curve.position(s);
  include(curve.time(s), position, curve.velocity(s));
  history_.max_distance = std::max(history_.max_distance, horizontal(Vec<D>(position - body_.x)));
}

template <int D>
void FlightLog<D>::include(double time, const Vec<D>& position, const Vec<D>& velocity) {
  if (run_.keep_extremes) return history_.include(state(time, position, velocity));
  max_squared_speed_ = std::max(max_squared_speed_, velocity.squaredNorm());
}

template <int D>
double FlightLog<D>::height(const Vec<D>& p) const {
  return p[D - 1] - ground_at(ground_of(terrain_), p);
}

template <int D>
template <class Curve>
void FlightLog<D>::pass_gates(const Curve& curve, double end) {
  // Slightly beyond the end, because a path that ends at a barrier may end before a gate there by rounding.
  const double until = std::min(curve.end(), end + 1e-12 * curve.end());
  for (std::size_t g = 0; g < to_gates_.size(); ++g) {
    const auto arrival = to_gates_[g].arrival(in_plan(curve), until);
    to_gates_[g].move_to(in_plan(curve.position(end)));
    if (!arrival) continue;
    to_gates_[g].arrive();
    const Vec<D> velocity = curve.velocity(arrival->time), position = curve.position(arrival->time);
    history_.passages.push_back({{curve.time(arrival->time), velocity.norm(), energy(velocity.squaredNorm()),
                                  height(moved_to<D>(position, arrival->place)), arrival->along},
                                 static_cast<int>(g)});
  }
}

template <int D>
void FlightLog<D>::highest(const Arc<D>& arc, double end) {
  const auto look = [&](double s) {
    history_.bounce_height = std::max(history_.bounce_height, height(arc.position(s)));
  };
  look(end);
  visit_highest(arc, ground_of(terrain_), end, look);
}

/// Fills the bins along x. Within a piece of an arc, x is taken as linear in time. Without wind the error is
/// k v^2 t^2 / 8, a few centimetres.
template <int D>
void FlightLog<D>::bins(const Arc<D>& arc, double end) {
  if (run_.bin_width <= 0) return;
  const int pieces = arc.is_parabola ? 1 : 4;
  for (int i = 0; i < pieces; ++i) {
    const double from = end * i / pieces, to = end * (i + 1) / pieces;
    const double x = arc.position(from).x(), rate = (arc.position(to).x() - x) / (to - from);
    history_.path.visit(x - rate * from, rate, from, to, [&](PathBin& bin, double s0, double s1) {
      double squared = 0;
      for (const double s : {s0, 0.5 * (s0 + s1), s1}) {
        bin.height = std::max(bin.height, height(arc.position(s)));
        squared = std::max(squared, arc.velocity(s).squaredNorm());
      }
      bin.speed = std::max(bin.speed, std::sqrt(squared));
      bin.energy = std::max(bin.energy, energy(squared));
    });
  }
}

/// The greatest height above the ground, and the bins along x.
template <int D>
void FlightLog<D>::over_ground(const Path<D>& path, double dt) {
  const double rate = rate_along_x(path, dt);
  const auto see = [&](double from, double to, const auto& highest) {
    history_.bounce_height = std::max(history_.bounce_height, highest(from, to));
    if (run_.bin_width <= 0) return;
    history_.path.visit(path.x.x(), rate, from, to, [&](PathBin& bin, double t0, double t1) {
      bin.height = std::max(bin.height, highest(t0, t1));
      const double squared = std::max(path.velocity(t0).squaredNorm(), path.velocity(t1).squaredNorm());
      bin.speed = std::max(bin.speed, std::sqrt(squared));
      bin.energy = std::max(bin.energy, energy(squared));
    });
  };
  visit_heights(terrain_, path, dt, see, near_);
}

/// Records a path for maps.
template <int D>
void FlightLog<D>::map(const Path<D>& path, double dt) {
  over_cells(
      terrain_, path, dt, *run_.cells, [&](double t) { return path.velocity(t).squaredNorm(); },
      [&](double squared) { return energy(squared); });
}

/// In air, a quarter of an arc is a parabola between its ends, straight in plan: an error of at most
/// |a| dt^2 / 8, some centimetres.
template <int D>
void FlightLog<D>::map(const Arc<D>& arc, double end) {
  const int pieces = arc.is_parabola ? 1 : 4;
  for (int i = 0; i < pieces; ++i) {
    const double from = end * i / pieces, dt = end * (i + 1) / pieces * arc.length - from * arc.length;
    if (!(dt > 0) && i > 0) return;
    Path<D> path{arc.position(from), arc.velocity(from)};
    const double half = 0.5 * dt * dt;
    if (half > 0) path.a = (arc.position(end * (i + 1) / pieces) - path.x - dt * path.v) / half;
    map(path, dt);
  }
}

template class FlightLog<2>;
template class FlightLog<3>;
template void FlightLog<2>::flew(const Parabola<2>&, double);
template void FlightLog<3>::flew(const Parabola<3>&, double);
template void FlightLog<2>::flew(const Arc<2>&, double);
template void FlightLog<3>::flew(const Arc<3>&, double);

}  // namespace flyrock
