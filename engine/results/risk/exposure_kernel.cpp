#include "results/risk/exposure_kernel.h"

#include <algorithm>
#include <cmath>

namespace flyrock {

namespace {

/// How far along the line from a to b [as a share of it] the foot of `place` is; beyond its ends below 0 or
/// above 1.
double share_along(const Vec2& a, const Vec2& b, const Vec2& place) {
  const Vec2 way = b - a;
  return (place - a).dot(way) / way.squaredNorm();
}

/// The place of the line from a to b that is nearest to `place`.
Vec2 nearest_on(const Vec2& a, const Vec2& b, const Vec2& place) {
  return a + std::clamp(share_along(a, b, place), 0.0, 1.0) * (b - a);
}

/// Epanechnikov's kernel over a line [1/m] and over a plane [1/m2].
double kernel_in_line(double s, double radius) {
  const double u = s / radius;
  return 0.75 / radius * std::max(0.0, 1 - u * u);
}
double kernel_in_plan(double s, double radius) {
  const double u = s / radius;
  return 2 / (pi * radius * radius) * std::max(0.0, 1 - u * u);
}

/// The integral of the kernel over a plane about `place` along the line from a to b [1/m].
double kernel_along(const Vec2& a, const Vec2& b, const Vec2& place, double radius) {
  const double length = (b - a).norm();
  const Vec2 along = (b - a) / length;
  const double middle = along.dot(place - a), aside = std::abs(cross(along, Vec2(place - a))) / radius;
  if (aside >= 1) return 0;
  const double half = std::sqrt(1 - aside * aside);
  const auto integral = [&](double at) {  // of 1 - aside^2 - u^2 from 0
    const double u = std::clamp((at - middle) / radius, -half, half);
    return u * (half * half - u * u / 3);
  };
  return 2 / (pi * radius) * (integral(length) - integral(0));
}

/// The same along an endless line at the distance s from the place.
double kernel_across(double s, double radius) {
  const double u = s / radius, half = std::sqrt(std::max(0.0, 1 - u * u));
  return 8 / (3 * pi * radius) * half * half * half;
}

}  // namespace

double length_of(const std::vector<Vec2>& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
  return length;
}

double ExposureKernel::distance(const Vec2& place) const {
  if (dimension_ == 2) return std::abs(place.x() - plan_.at.x());
  if (plan_.line.empty()) return (place - plan_.at).norm();
  double least = infinite;
  for (std::size_t i = 1; i < plan_.line.size(); ++i)
    least = std::min(least, (nearest_on(plan_.line[i - 1], plan_.line[i], place) - place).norm());
  return least;
}

/// q over the kernel: A, on a line A over its length [m], in 2D A over the arc at the distance `way`.
double ExposureKernel::part_of_area(double way) const {
  if (dimension_ == 2) return plan_.area / (plan_.spread * way);
  if (plan_.line.empty()) return plan_.area;
  return plan_.area / (plan_.length > 0 ? plan_.length : length_of(plan_.line));
}

/// K, its integral along the line, or K1.
double ExposureKernel::kernel_at(const Vec2& landing, double radius) const {
  if (dimension_ == 2) return kernel_in_line(landing.x() - plan_.at.x(), radius);
  if (plan_.line.empty()) return kernel_in_plan((landing - plan_.at).norm(), radius);
  double along = 0;
  for (std::size_t i = 1; i < plan_.line.size(); ++i)
    along += kernel_along(plan_.line[i - 1], plan_.line[i], landing, radius);
  return along;
}

double ExposureKernel::kernel_peak(double radius) const {
  if (dimension_ == 2) return kernel_in_line(0, radius);
  return plan_.line.empty() ? kernel_in_plan(0, radius) : kernel_across(0, radius);
}

double ExposureKernel::chance(const Vec2& landing, double way, double radius) const {
  return std::min(1.0, part_of_area(way) * kernel_at(landing, radius));
}

double ExposureKernel::greatest_chance(double way, double radius) const {
  return std::min(1.0, part_of_area(way) * kernel_peak(radius));
}

std::optional<StoneOnRoad> ExposureKernel::on_road(const Vec2& landing, double radius) const {
  double before = 0, nearest = radius;  // m
  std::optional<StoneOnRoad> found;
  const std::size_t sides = plan_.line.size() - 1;
  for (std::size_t i = 0; i < sides; ++i) {
    const Vec2 &a = plan_.line[i], &b = plan_.line[i + 1];
    const double length = (b - a).norm(), share = share_along(a, b, landing);
    const double aside = (nearest_on(a, b, landing) - landing).norm();
    if (aside < nearest) {
      nearest = aside;
      found.reset();
      const bool is_beyond = (i == 0 && share < 0) || (i + 1 == sides && share > 1);
      if (!is_beyond)
        found = StoneOnRoad{before + std::clamp(share, 0.0, 1.0) * length,
                            std::min(1.0, plan_.area / plan_.length * kernel_across(aside, radius))};
    }
    before += length;
  }
  return found;
}

}  // namespace flyrock
