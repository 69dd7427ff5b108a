#include "math/space.h"

namespace flyrock {

Rotation3 Rotation3::from_vector(const Vec3& v) {
  const double angle = v.norm(), half = 0.5 * angle;
  // sin(x)/x to the last bit near 0, where the quotient would be 0/0.
  const double sine_share = half < 1e-4 ? 0.5 * (1 - half * half / 6) : std::sin(half) / angle;
  Eigen::Quaterniond q;
  q.w() = std::cos(half);
  q.vec() = sine_share * v;
  return Rotation3(q);
}

Vec3 Rotation3::vector() const {
  const double sine = q_.vec().norm();
  if (sine == 0) return Vec3::Zero();
  // q and -q are the same rotation. The half angle in [0, pi/2] gives the shorter turn.
  const double half = std::atan2(sine, std::abs(q_.w()));
  return std::copysign(2 * half / sine, q_.w()) * q_.vec();
}

/// Source: Duff and others, Building an orthonormal basis, revisited, JCGT 2017. They change sides at n_z =
/// 0.
Eigen::Matrix3d contact_frame(const Vec3& n) {
  const double side = n.z() > -0.9 ? 1 : -1;
  const double a = -1 / (side + n.z()), b = n.x() * n.y() * a;
  Eigen::Matrix3d frame;
  frame.col(0) = n;
  frame.col(1) << 1 + side * n.x() * n.x() * a, side * b, -side * n.x();
  frame.col(2) << -b, -side - n.y() * n.y() * a, n.y();
  return frame;
}

}  // namespace flyrock
