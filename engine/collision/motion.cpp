#include "collision/motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/parabola_length.h"

namespace flyrock {

double Swell::greatest(double t) const {
  return by + t * (std::max(0.0, rate) + 0.5 * t * std::max(0.0, growth));
}

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// Narrows the window to the times between the first and the last one at which x + v t + a t^2 / 2 <= limit.
void keep_below(double x, double v, double a, double limit, TimeWindow& window) {
  const double c = x - limit;
  auto value = [&](double t) { return c + t * (v + 0.5 * t * a); };
  const bool at_start = value(window.a) <= 0, at_end = value(window.b) <= 0;
  if (at_start && at_end) return;
  double first = never, last = -never;  // roots
  if (a == 0) {
    if (v != 0) first = last = -c / v;
  } else if (const double discriminant = v * v - 2 * a * c; discriminant >= 0) {
    const double s = -(v + std::copysign(std::sqrt(discriminant), v));  // avoids cancellation
    const double t1 = s / a, t2 = s != 0 ? 2 * c / s : t1;
    first = std::min(t1, t2);
    last = std::max(t1, t2);
  }
  if (!at_start) window.a = first >= window.a ? first : last >= window.a ? last : never;
  if (!at_end && !window.empty()) window.b = last <= window.b ? last : first <= window.b ? first : -never;
}

}  // namespace

GivenRotation GivenRotation::between(const Rotation3& start, const Vec3& w, const Rotation3& end, double h) {
  const Vec3 turned = (end * start.inverse()).vector();
  return {start, w, 2 / (h * h) * (turned - h * w)};
}

/// The spin of exp(u(t)) R is u' + (1 - cos u)/u^2 u x u' + (u - sin u)/u^3 u x (u x u'), u = |u|.
Turn GivenRotation::at(double t) const {
  const Vec3 u = t * (w + 0.5 * t * alpha), rate = w + t * alpha, across = u.cross(rate);
  const double angle = u.norm();
  // Series near 0, because the quotients cancel there.
  const double first = angle < 1e-3 ? 0.5 - angle * angle / 24 : (1 - std::cos(angle)) / (angle * angle);
  const double second =
      angle < 1e-2 ? 1.0 / 6 - angle * angle / 120 : (angle - std::sin(angle)) / std::pow(angle, 3);
  return {Rotation3::from_vector(u) * start, rate + first * across + second * u.cross(across)};
}

/// A bound, because the map from u' to the spin never increases the length.
double GivenRotation::greatest_spin(double t) const { return std::max(w.norm(), (w + t * alpha).norm()); }

/// The rate of change of that map is at most |u'|/2, and 0 if the axis is constant.
double GivenRotation::greatest_spin_rate(double t) const {
  const double spin = greatest_spin(t);
  return alpha.norm() + (w.cross(alpha).isZero(0) ? 0 : 0.5 * spin * spin);
}

Turn Motion3::turn(double t) const {
  return std::visit([t](const auto& r) { return r.at(t); }, rotation);
}

double Motion3::greatest_spin(double t) const {
  const auto* given = std::get_if<GivenRotation>(&rotation);
  return given ? given->greatest_spin(t) : std::get<FreeRotation>(rotation).greatest_spin();
}

double Motion3::greatest_spin_rate(double t) const {
  const auto* given = std::get_if<GivenRotation>(&rotation);
  return given ? given->greatest_spin_rate(t) : std::get<FreeRotation>(rotation).greatest_spin_rate();
}

template <int D>
TimeWindow meeting_window(const Path<D>& path, double r, const Box<D>& box, double t_max) {
  TimeWindow window{0, t_max};
  for (int k = 0; k < D; ++k) {
    if (!window.empty()) keep_below(path.x[k], path.v[k], path.a[k], box.high[k] + r, window);
    if (!window.empty()) keep_below(-path.x[k], -path.v[k], -path.a[k], r - box.low[k], window);
  }
  return window;
}

template <int D>
Box<D> swept_box(const Path<D>& path, double r, double t) {
  const Vec<D> end = path.position(t);
  Box<D> box{path.x.cwiseMin(end), path.x.cwiseMax(end)};
  for (int k = 0; k < D; ++k) {
    const double turn = path.a[k] != 0 ? -path.v[k] / path.a[k] : -1;
    if (turn <= 0 || turn >= t) continue;
    const double extreme = path.position(turn)[k];
    box.low[k] = std::min(box.low[k], extreme);
    box.high[k] = std::max(box.high[k], extreme);
  }
  return box.grown(r);
}

template <int D>
double path_length(const Path<D>& path, double t) {
  if (path.a.template head<D - 1>().isZero(0)) {  // upright, or none
    const double up = path.a[D - 1] < 0 ? -1 : 1;
    return parabola_length(path.v.template head<D - 1>().squaredNorm(), up * path.v[D - 1],
                           up * path.a[D - 1], t);
  }
  const double a = path.a.norm();
  const Vec<D> direction = path.a / a;
  const double along = path.v.dot(direction);
  return parabola_length((path.v - along * direction).squaredNorm(), along, a, t);
}

template TimeWindow meeting_window(const Path<2>&, double, const Box2&, double);
template TimeWindow meeting_window(const Path<3>&, double, const Box3&, double);
template Box2 swept_box(const Path<2>&, double, double);
template Box3 swept_box(const Path<3>&, double, double);
template double path_length(const Path<2>&, double);
template double path_length(const Path<3>&, double);

}  // namespace flyrock
