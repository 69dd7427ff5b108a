#include "math/farthest_on_ellipse.h"

#include <cmath>

namespace flyrock {

namespace {

/// The zero in [low, high] of u cos t + v sin t - 2 r sin 2t, which falls from >= 0 to <= 0. Newton's method,
/// kept inside of the bracket.
double falling_zero(double u, double v, double r, double low, double high) {
  double t = 0.5 * (low + high);
  for (int i = 0; i < 60; ++i) {
    double sine, cosine;
    ::sincos(t, &sine, &cosine);
    const double value = u * cosine + v * sine - 4 * r * sine * cosine;
    const double slope = v * cosine - u * sine - 4 * r * (cosine * cosine - sine * sine);
    (value > 0 ? low : high) = t;
    double next = t - value / slope;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - t) < 1e-15) break;
    t = next;
  }
  return t;
}

}  // namespace

boost::container::static_vector<double, 2> farthest_on_ellipse(const Vec2& c, const Vec2& a, const Vec2& b) {
  const double p = 2 * c.dot(a), q = 2 * c.dot(b);
  const double of_cosine = 0.5 * (a.squaredNorm() - b.squaredNorm()), of_sine = a.dot(b);
  const double r = std::hypot(of_cosine, of_sine), delta = r > 0 ? 0.5 * std::atan2(of_sine, of_cosine) : 0;
  double sine, cosine;
  ::sincos(delta, &sine, &cosine);
  const double along = p * cosine + q * sine, across = q * cosine - p * sine;
  const double u = std::abs(along), v = std::abs(across);
  const auto angle = [&](double from_axis, bool same_side) {
    const bool right = (along >= 0) == same_side;
    const double psi = right ? from_axis : pi - from_axis;
    return delta + (across >= 0 ? psi : -psi);
  };
  boost::container::static_vector<double, 2> angles;
  if (u + v + r == 0) return {0.0};
  angles.push_back(angle(falling_zero(v, -u, r, 0, 0.5 * pi), true));
  // The slope on the other side is least where tan^3 = v/u. The small term decides where both are 0.
  const double small = 1e-12 * r;
  const double lowest = std::atan2(std::cbrt(v + small), std::cbrt(u + small));
  const double least = v * std::cos(lowest) + u * std::sin(lowest) - 2 * r * std::sin(2 * lowest);
  if (r > 0 && least < 0) angles.push_back(angle(falling_zero(v, u, r, 0, lowest), false));
  return angles;
}

}  // namespace flyrock
