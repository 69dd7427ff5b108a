#include "flight/point_log.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>

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
  const Box2 box = arc.box();
  for (int i = 0; i < ground.segments(); ++i) {
    const Vec2 &a = ground.points[i], &b = ground.points[i + 1];
    if (b.x() < box.low.x() || a.x() > box.high.x()) continue;
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
PointLog<D>::PointLog(const Body<D>& body, const Terrain& terrain, const PointRun<D>& run,
                      BodyHistory& history)
    : body_(body),
      terrain_(terrain),
      run_(run),
      history_(history),
      log_(run, terrain, run.start_time, run.cells, history),
      spin_(Space<D>::no_spin()),
      spin_since_(run.start_time),
      attitude_(body.attitude),
      twice_spin_energy_(0) {
  if (run.ends_at_touch) {
    spin_ = body.w;
    twice_spin_energy_ = twice_spin_energy(body, body.attitude, body.w);
  }
  log_.begin(state(run.start_time, body.x, body.v), bins_over(ground_of(terrain), run.bin_width));
  history.bounce_height = height(body.x);
}

template <int D>
void PointLog<D>::slid(const Arc<D>& arc, double end, TravelMode mode) {
  history_.contact_time += end * arc.length;
  see(arc, end, mode);
}

/// A run that ends at its touch stores no ends of arcs.
template <int D>
template <class Curve>
void PointLog<D>::see(const Curve& curve, double end, TravelMode mode) {
  follow(curve, end, mode);
  if (!log_.stores()) return;
  log_.visit_due(curve.time(end),
                 [&](double time) { store(at(curve, (time - curve.start) * (curve.end() / curve.length))); });
  if (!run_.ends_at_touch) store(at(curve, end));
}

/// As for bodies: in closed form, over a straight line in plan.
template <int D>
void PointLog<D>::follow(const Parabola<D>& path, double end, TravelMode mode) {
  log_.travels(mode, end, path_length<D>(path, end));
  if (run_.keep_extremes || run_.keep_impacts) apex(path, end);
  widen(path, end);
  log_.passes(
      path, end, [&](double t) { return path.velocity(t).squaredNorm(); },
      [&](double squared) { return energy(squared); });
}

template <int D>
void PointLog<D>::follow(const Arc<D>& arc, double end, TravelMode mode) {
  if (!run_.ends_at_touch && arc.is_parabola) return follow(arc.parabola(), end * arc.length, mode);
  log_.travels(mode, end * arc.length, path_length(arc, end));
  turns(arc, end);
  widen(arc, end);
  highest(arc, end);
  bins(arc, end);
  if (run_.cells) map(arc, end);
}

/// The highest place of a parabola. Speed and distance are greatest at the ends of an arc.
template <int D>
void PointLog<D>::apex(const Parabola<D>& path, double end) {
  const double apex = path.a[D - 1] < 0 ? path.v[D - 1] / -path.a[D - 1] : -1;
  if (!(apex > 0 && apex <= end)) return;
  if (run_.keep_extremes) widen(path, apex);
  if (run_.keep_impacts && history_.impact_count > 0 && log_.mode() == TravelMode::bounce)
    log_.apex(path.time(apex), path.position(apex));
}

template <int D>
void PointLog<D>::turns(const Arc<D>& arc, double end) {
  const Vec<D> up = Vec<D>::Unit(D - 1);
  if (const auto apex = first_fall(arc.rate_along(up), 0, end); apex && *apex > 0) widen(arc, *apex);
  for (int k = 0; k < D - 1; ++k)  // points at which wind reverses the rock
    for (const double side : {-1.0, 1.0})
      if (const auto turn = first_fall(arc.rate_along(side * Vec<D>::Unit(k)), 0, end); turn && *turn > 0)
        widen(arc, *turn);
}

template <int D>
void PointLog<D>::struck(const Landing<D>& after) {
  log_.struck(after.position);
  include(after.time, after.position, after.velocity);
  if (log_.stores()) store(state(after.time, after.position, after.velocity));
}

template <int D>
void PointLog<D>::slowed(double time, double left) {
  attitude_ = attitude(time);
  spin_since_ = time;
  spin_ *= left;
  twice_spin_energy_ *= left * left;
}

template <int D>
void PointLog<D>::ended(const Landing<D>& end, StopReason reason) {
  history_.reason = reason;
  if (!run_.keep_extremes) {
    history_.max_speed = std::max(history_.max_speed, std::sqrt(max_squared_speed_));
    history_.max.kinetic_energy = std::max(history_.max.kinetic_energy, energy(max_squared_speed_));
  }
  history_.last = state(end.time, end.position, end.velocity);
  if (run_.ends_at_touch && reason == StopReason::stopped) {
    log_.lands(end.position);
    history_.stop_time = end.time;
  }
  if (!history_.landed && (log_.has_flown() || run_.ends_at_touch)) log_.ends_flight(end.position);
  if (log_.stores()) store(history_.last);
}

template <int D>
BodyState PointLog<D>::state(double time, const Vec<D>& position, const Vec<D>& velocity) const {
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
void PointLog<D>::widen(const Curve& curve, double s) {
  const Vec<D> position = curve.position(s);
  include(curve.time(s), position, curve.velocity(s));
  log_.reaches(position);
}

template <int D>
void PointLog<D>::include(double time, const Vec<D>& position, const Vec<D>& velocity) {
  if (run_.keep_extremes) return history_.include(state(time, position, velocity));
  max_squared_speed_ = std::max(max_squared_speed_, velocity.squaredNorm());
}

template <int D>
double PointLog<D>::height(const Vec<D>& p) const {
  return p[D - 1] - ground_at(ground_of(terrain_), p);
}

template <int D>
void PointLog<D>::highest(const Arc<D>& arc, double end) {
  const auto look = [&](double s) {
    history_.bounce_height = std::max(history_.bounce_height, height(arc.position(s)));
  };
  look(end);
  visit_highest(arc, ground_of(terrain_), end, look);
}

/// Fills the bins along x. Within a piece of an arc, x is taken as linear in time. Without wind the error is
/// k v^2 t^2 / 8, a few centimetres.
template <int D>
void PointLog<D>::bins(const Arc<D>& arc, double end) {
  if (!log_.has_bins()) return;
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

/// In air, a quarter of an arc is a parabola between its ends, straight in plan: an error of at most
/// |a| dt^2 / 8, some centimetres.
template <int D>
void PointLog<D>::map(const Arc<D>& arc, double end) {
  const int pieces = arc.is_parabola ? 1 : 4;
  for (int i = 0; i < pieces; ++i) {
    const double from = end * i / pieces, dt = end * (i + 1) / pieces * arc.length - from * arc.length;
    if (!(dt > 0) && i > 0) return;
    Path<D> path{arc.position(from), arc.velocity(from)};
    const double half = 0.5 * dt * dt;
    if (half > 0) path.a = (arc.position(end * (i + 1) / pieces) - path.x - dt * path.v) / half;
    log_.map(
        path, dt, [&](double t) { return path.velocity(t).squaredNorm(); },
        [&](double squared) { return energy(squared); });
  }
}

template class PointLog<2>;
template class PointLog<3>;
template void PointLog<2>::see(const Parabola<2>&, double, TravelMode);
template void PointLog<3>::see(const Parabola<3>&, double, TravelMode);
template void PointLog<2>::see(const Arc<2>&, double, TravelMode);
template void PointLog<3>::see(const Arc<3>&, double, TravelMode);

}  // namespace flyrock
