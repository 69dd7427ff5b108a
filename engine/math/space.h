#pragma once
// Vectors, spins and rotations of the plane and of space.

#include <Eigen/Dense>
#include <cmath>

namespace flyrock {

template <int D>
using Vec = Eigen::Matrix<double, D, 1>;
using Vec2 = Vec<2>;
using Vec3 = Vec<3>;

inline constexpr double pi = 3.14159265358979323846;

/// Twice the signed area spanned by a and b; the z component of their cross product.
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The velocity that a spin w [rad/s] about z gives to a point at lever r: w x r.
inline Vec2 cross(double w, const Vec2& r) { return {-w * r.y(), w * r.x()}; }

/// r turned by +90 degrees.
inline Vec2 perpendicular(const Vec2& r) { return {-r.y(), r.x()}; }

/// A rotation of the plane, kept as cosine and sine so that it is applied without trigonometry.
struct Rotation2 {
  double c = 1;
  double s = 0;

  static Rotation2 from_angle(double angle) { return {std::cos(angle), std::sin(angle)}; }
  Vec2 operator*(const Vec2& v) const { return {c * v.x() - s * v.y(), s * v.x() + c * v.y()}; }
  Vec2 inverse(const Vec2& v) const { return {c * v.x() + s * v.y(), -s * v.x() + c * v.y()}; }
};

/// What depends on the dimension: the type of a spin, of a moment of inertia and of a rotation, and the number of
/// velocity components of a rigid body.
template <int D>
struct Space;

template <>
struct Space<2> {
  using Spin = double;     ///< rad/s
  using Inertia = double;  ///< kg m2 about the centre of mass
  using Rotation = Rotation2;
  static constexpr int dof = 3;  ///< (v_x, v_y, omega)
};

}  // namespace flyrock
