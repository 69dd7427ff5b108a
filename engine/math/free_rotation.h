#pragma once
// The torque-free rotation of a rigid body in closed form.

#include <optional>

#include "math/elliptic.h"
#include "math/space.h"

namespace flyrock {

/// The attitude and spin of a body at one time.
struct Turn {
  Rotation3 rotation;        ///< from the body's principal frame to the world
  Vec3 spin = Vec3::Zero();  ///< rad/s, world frame
};

/// Euler's equations I w' = I w x w, solved once at t = 0 and evaluated at any t.
///
/// A spin about a principal axis, a ball and a symmetric top rotate as R(t) = exp(t p) R(0) exp(t q), with p
/// along the angular momentum L and q along the axis of symmetry. For three different moments, let c be the
/// axis that the spin circles (the one of the smallest or the greatest moment), b the axis of the middle
/// moment and a the third axis. In the body's frame
///   w = (A cn(u), B sn(u), C dn(u)),  u = lambda t + u_0,
/// with Jacobi's functions of modulus k. The direction of L in the body determines the attitude up to an
/// angle about L, which is
///   phi = L t / I_c + L (1/I_a - 1/I_c) (Pi(n; u) - Pi(n; u_0)) / lambda,
/// with the elliptic integral of the third kind. |L| and the energy hold to rounding at any t.
/// Source: van Zon and Schofield, J. Comput. Phys. 225 (2007) 145-164.
class FreeRotation {
 public:
  /// Principal moments [kg m2] or any multiple of them, attitude, and spin [rad/s, world frame] at t = 0.
  FreeRotation(const Vec3& moments, const Rotation3& rotation, const Vec3& spin);

  Turn at(double t) const;
  /// The same rotation in a frame at rest that is turned by `frame`.
  FreeRotation seen_from(const Rotation3& frame) const;
  /// Bounds on |w| [rad/s] and |w'| [rad/s2] at all times.
  double greatest_spin() const { return greatest_spin_; }
  double greatest_spin_rate() const { return greatest_spin_rate_; }
  /// The rate |p| at which an axis of the body turns about the angular momentum, if the axis keeps its angle
  /// to it: then the spin across the axis is constant [rad/s].
  std::optional<double> precession_of(const Vec3& axis) const;

 private:
  void precess(const Vec3& p, const Vec3& q);
  void set_bounds(double a, double b, double c);

  Rotation3 start_;
  double greatest_spin_ = 0, greatest_spin_rate_ = 0;
  bool precesses_ = true;
  Vec3 p_ = Vec3::Zero(), q_ = Vec3::Zero();
  // Three moments; vectors are in the frame (a, b, c).
  Eigen::Matrix3d to_body_ = Eigen::Matrix3d::Identity();   ///< from (a, b, c) to the principal frame
  Eigen::Matrix3d to_world_ = Eigen::Matrix3d::Identity();  ///< from the frame whose z axis is L
  Vec3 moments_ = Vec3::Ones();
  Vec3 amplitude_ = Vec3::Zero();
  double momentum_ = 0, lambda_ = 1, u0_ = 0, third_kind_start_ = 0;
  EllipticFunctions functions_;
};

}  // namespace flyrock
