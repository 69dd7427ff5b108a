// Which planes let a face fail (results/statistics/joint_survey.h).

#include <cmath>

#include "results/statistics/joint_survey.h"

namespace flyrock {

namespace {

/// The angle between two directions, from 0 to pi.
double between(double a, double b) { return std::abs(std::remainder(a - b, 2 * pi)); }

}  // namespace

Vec3 pole_of(double dip, double direction) {
  return {std::sin(dip) * std::sin(direction), std::sin(dip) * std::cos(direction), std::cos(dip)};
}

Vec3 line_of(double trend, double plunge) {
  return {std::cos(plunge) * std::sin(trend), std::cos(plunge) * std::cos(trend), -std::sin(plunge)};
}

std::pair<double, double> dip_of(const Vec3& normal) {
  const Vec3 up = normal.z() < 0 ? Vec3(-normal) : normal;
  double direction = std::atan2(up.x(), up.y());
  if (direction < 0) direction += 2 * pi;
  return {std::atan2(up.head<2>().norm(), up.z()), direction};
}

bool slides_on(const SlopeFace& face, const Vec3& pole) {
  const auto [dip, direction] = dip_of(pole);
  return between(direction, face.direction) <= face.lateral && dip > face.friction && dip < face.dip;
}

bool slides_between(const SlopeFace& face, const Vec3& first, const Vec3& second) {
  Vec3 line = first.cross(second);
  if (line.z() > 0) line = -line;
  const double level = line.head<2>().norm();
  if (level == 0) return false;
  const double plunge = std::atan2(-line.z(), level);
  const double cosine = std::cos(std::atan2(line.x(), line.y()) - face.direction);
  return plunge > face.friction && cosine > 0 && std::tan(plunge) < std::tan(face.dip) * cosine;
}

bool topples_on(const SlopeFace& face, const Vec3& pole) {
  constexpr double most_skew = 10 * pi / 180;
  const auto [dip, direction] = dip_of(pole);
  return pi / 2 - dip <= face.dip - face.friction && between(direction, face.direction + pi) <= most_skew;
}

}  // namespace flyrock
