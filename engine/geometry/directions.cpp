#include "geometry/directions.h"

namespace flyrock {

Vec3 fisher_direction(const Vec3& mean, double k, RandomStream& rng) {
  const double cosine = std::max(-1.0, 1 + std::log1p(rng.uniform() * std::expm1(-2 * k)) / k);
  const double sine = std::sqrt(std::max(0.0, (1 - cosine) * (1 + cosine)));
  const double around = 2 * pi * rng.uniform();
  const Eigen::Matrix3d frame = contact_frame(mean);  // mean, and two directions across it
  return (cosine * frame.col(0) + sine * (std::cos(around) * frame.col(1) + std::sin(around) * frame.col(2)))
      .normalized();
}

Vec2 fisher_direction(const Vec2& mean, double k, RandomStream& rng) {
  const double t = 1 + std::sqrt(1 + 4 * k * k), rho = (t - std::sqrt(2 * t)) / (2 * k);
  const double r = (1 + rho * rho) / (2 * rho);
  for (;;) {
    const double z = std::cos(pi * rng.uniform()), f = (1 + r * z) / (r + z), c = k * (r - f);
    const double u = rng.uniform();
    if (c * (2 - c) <= u && std::log(c / u) + 1 < c) continue;
    const double angle = (rng.uniform() < 0.5 ? -1 : 1) * std::acos(std::clamp(f, -1.0, 1.0));
    return Rotation2::from_angle(angle) * mean;
  }
}

}  // namespace flyrock
