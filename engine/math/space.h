#pragma once
// Vectors, spins and rotations in 2D and 3D.

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace flyrock {

template <int D>
using Vec = Eigen::Matrix<double, D, 1>;
using Vec2 = Vec<2>;
using Vec3 = Vec<3>;

inline constexpr double pi = 3.14159265358979323846;
inline constexpr double infinite = std::numeric_limits<double>::infinity();

/// Twice the signed area spanned by a and b; the z component of their cross product.
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The velocity that a spin w [rad/s] about z gives to a point at lever r: w x r.
inline Vec2 cross(double w, const Vec2& r) { return {-w * r.y(), w * r.x()}; }

/// r turned by +90 degrees.
inline Vec2 perpendicular(const Vec2& r) { return {-r.y(), r.x()}; }

/// The length of the horizontal part of a position or direction. The vertical axis is y in 2D and z in 3D.
inline double horizontal(const Vec2& v) { return std::abs(v.x()); }
inline double horizontal(const Vec3& v) { return v.head<2>().norm(); }

/// The distance of a place p from the segment between a and b.
template <class Place>
double distance_to_segment(const Place& p, const Place& a, const Place& b) {
  const Place along = b - a;
  const double squared = along.squaredNorm();
  const double share = squared > 0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0;
  return (p - a - share * along).norm();
}

/// A rotation in 2D, stored as cosine and sine, so that it is applied without trigonometric functions.
struct Rotation2 {
  double c = 1;
  double s = 0;

  static Rotation2 from_angle(double angle) {
    double sine, cosine;
    ::sincos(angle, &sine, &cosine);  // computes both with one reduction of the angle
    return {cosine, sine};
  }
  Vec2 operator*(const Vec2& v) const { return {c * v.x() - s * v.y(), s * v.x() + c * v.y()}; }
  Vec2 inverse(const Vec2& v) const { return {c * v.x() + s * v.y(), -s * v.x() + c * v.y()}; }
  /// This rotation turned by `by` [rad] more, to rounding. A turn of less than half a radian is the sum of
  /// its Taylor series, which takes a fifth of the time of sincos.
  Rotation2 turned(double by) const;
};

inline Rotation2 Rotation2::turned(double by) const {
  double sine, versed;  // sin and 1 - cos
  if (std::abs(by) < 0.5) {
    const double q = by * by;
    constexpr double f3 = 6, f5 = 20 * f3, f7 = 42 * f5, f9 = 72 * f7, f11 = 110 * f9, f13 = 156 * f11;
    constexpr double f4 = 24, f6 = 30 * f4, f8 = 56 * f6, f10 = 90 * f8, f12 = 132 * f10, f14 = 182 * f12;
    sine =
        by - by * q * (1 / f3 - q * (1 / f5 - q * (1 / f7 - q * (1 / f9 - q * (1 / f11 - q * (1 / f13))))));
    versed = q * (0.5 -
                  q * (1 / f4 - q * (1 / f6 - q * (1 / f8 - q * (1 / f10 - q * (1 / f12 - q * (1 / f14)))))));
  } else {
    const Rotation2 more = from_angle(by);
    sine = more.s;
    versed = 1 - more.c;
  }
  return {c - (c * versed + s * sine), s + (c * sine - s * versed)};
}

/// A rotation in 3D: a unit quaternion and its matrix, because the matrix rotates many points cheaply.
class Rotation3 {
 public:
  Rotation3() = default;
  explicit Rotation3(const Eigen::Quaterniond& q) : q_(q.normalized()), matrix_(q_.toRotationMatrix()) {}
  explicit Rotation3(const Eigen::Matrix3d& orthonormal) : Rotation3(Eigen::Quaterniond(orthonormal)) {}

  /// The exponential map: the turn by |v| [rad] about the axis v.
  static Rotation3 from_vector(const Vec3& v);
  /// Its inverse: the v with from_vector(v) = *this and |v| <= pi.
  Vec3 vector() const;

  Vec3 operator*(const Vec3& v) const { return matrix_ * v; }
  Rotation3 operator*(const Rotation3& first) const { return Rotation3(q_ * first.q_); }
  Vec3 inverse(const Vec3& v) const { return matrix_.transpose() * v; }
  Rotation3 inverse() const { return Rotation3(q_.conjugate()); }
  const Eigen::Quaterniond& quaternion() const { return q_; }
  const Eigen::Matrix3d& matrix() const { return matrix_; }

 private:
  Eigen::Quaterniond q_ = Eigen::Quaterniond::Identity();
  Eigen::Matrix3d matrix_ = Eigen::Matrix3d::Identity();
};

/// The frame of a contact with normal n: the columns n, t.  t = (n_y, -n_x) is +x on level ground.
inline Eigen::Matrix2d contact_frame(const Vec2& n) {
  Eigen::Matrix2d frame;
  frame << n.x(), n.y(), n.y(), -n.x();
  return frame;
}

/// The columns n, t, s with s x t = n; on level ground t = +x. Continuous in n except at the cone n_z = -0.9,
/// which contains the normals of neither level nor upright faces.
Eigen::Matrix3d contact_frame(const Vec3& n);

/// What depends on the dimension: the type of a spin, of a moment of inertia and of a rotation, and the
/// number of velocity components of a rigid body.
template <int D>
struct Space;

template <>
struct Space<2> {
  using Spin = double;     ///< rad/s
  using Inertia = double;  ///< kg m2 about the centre of mass
  using Rotation = Rotation2;
  static constexpr int dof = 3;  ///< (v_x, v_y, omega)
  static Spin no_spin() { return 0; }
  static Spin spin_of(const Vec<dof>& velocity) { return velocity[2]; }
};

template <>
struct Space<3> {
  using Spin = Vec3;  ///< rad/s, world frame
  /// kg m2, the principal moments about the centre of mass, because a body's frame is its principal frame
  using Inertia = Vec3;
  using Rotation = Rotation3;
  static constexpr int dof = 6;  ///< (v_x, v_y, v_z, omega_x, omega_y, omega_z)
  static Spin no_spin() { return Vec3::Zero(); }
  static Spin spin_of(const Vec<dof>& velocity) { return velocity.tail<3>(); }
};

}  // namespace flyrock
