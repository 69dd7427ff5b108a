#include "collision/motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flyrock {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// Narrows the window to run from the first to the last moment at which x + v t + a t^2 / 2 <= limit.
void keep_below(double x, double v, double a, double limit, TimeWindow& window) {
  const double c = x - limit;
  auto value = [&](double t) { return c + t * (v + 0.5 * t * a); };
  const bool at_start = value(window.a) <= 0, at_end = value(window.b) <= 0;
  if (at_start && at_end) return;
  double first = never, last = -never;  // roots
  if (a == 0) {
    if (v != 0) first = last = -c / v;
  } else if (const double discriminant = v * v - 2 * a * c; discriminant >= 0) {
    const double s = -(v + std::copysign(std::sqrt(discriminant), v));  // free of cancellation
    const double t1 = s / a, t2 = s != 0 ? 2 * c / s : t1;
    first = std::min(t1, t2);
    last = std::max(t1, t2);
  }
  if (!at_start) window.a = first >= window.a ? first : last >= window.a ? last : never;
  if (!at_end && !window.empty()) window.b = last <= window.b ? last : first <= window.b ? first : -never;
}

}  // namespace

TimeWindow meeting_window(const Motion2& motion, double r, const Box2& box, double t_max) {
  TimeWindow window{0, t_max};
  for (int k = 0; k < 2; ++k) {
    if (!window.empty()) keep_below(motion.x[k], motion.v[k], motion.a[k], box.high[k] + r, window);
    if (!window.empty()) keep_below(-motion.x[k], -motion.v[k], -motion.a[k], r - box.low[k], window);
  }
  return window;
}

Box2 swept_box(const Motion2& motion, double r, double t) {
  const Vec2 end = motion.position(t);
  Box2 box{motion.x.cwiseMin(end), motion.x.cwiseMax(end)};
  for (int k = 0; k < 2; ++k) {
    const double turn = motion.a[k] != 0 ? -motion.v[k] / motion.a[k] : -1;
    if (turn <= 0 || turn >= t) continue;
    const double extreme = motion.position(turn)[k];
    box.low[k] = std::min(box.low[k], extreme);
    box.high[k] = std::max(box.high[k], extreme);
  }
  box.low.array() -= r;
  box.high.array() += r;
  return box;
}

/// With u = v . a / |a| + |a| t and p the speed across a, the speed is sqrt(p^2 + u^2).
double path_length(const Motion2& motion, double t) {
  const double a = motion.a.norm();
  if (a == 0) return t * motion.v.norm();
  const double along = motion.v.dot(motion.a) / a, across = std::abs(cross(motion.v, motion.a)) / a;
  const auto antiderivative = [&](double u) {
    return 0.5 * (u * std::hypot(across, u) + (across > 0 ? across * across * std::asinh(u / across) : 0));
  };
  return (antiderivative(along + a * t) - antiderivative(along)) / a;
}

}  // namespace flyrock
