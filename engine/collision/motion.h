#pragma once
// The motion of one body over a time interval.

#include <algorithm>
#include <cmath>
#include <optional>
#include <variant>

#include "geometry/box.h"
#include "math/free_rotation.h"
#include "math/space.h"

namespace flyrock {

/// The path of the centre of mass: x(t) = x + v t + a t^2 / 2, from t = 0. In free flight a is gravity plus
/// the acceleration by the air. In a contact step it is the mean acceleration of the step.
template <int D>
struct Path {
  Vec<D> x = Vec<D>::Zero(), v = Vec<D>::Zero(), a = Vec<D>::Zero();

  Vec<D> position(double t) const { return x + t * (v + 0.5 * t * a); }
  Vec<D> velocity(double t) const { return v + t * a; }
};

/// By how much a round contactor is larger than given, over time: by + rate t + growth t^2 / 2 [m].
struct Swell {
  double by = 0, rate = 0, growth = 0;

  double at(double t) const { return by + t * (rate + 0.5 * t * growth); }
  double rate_at(double t) const { return rate + t * growth; }
  /// A bound of at() over [0, t] from above.
  double greatest(double t) const;
};

/// angle(t) = angle + w t + alpha t^2 / 2. In free flight alpha is 0. In a contact step it is the mean
/// angular acceleration of the step.
struct Motion2 : Path<2> {
  double angle = 0, w = 0, alpha = 0;
  Swell swell = {};                        ///< of a pneumatic disk
  std::optional<Rotation2> rotation = {};  ///< by `angle`, where it is known

  Rotation2 start() const { return rotation ? *rotation : Rotation2::from_angle(angle); }
  double angle_at(double t) const { return angle + t * (w + 0.5 * t * alpha); }
  double spin(double t) const { return w + t * alpha; }
  double greatest_spin(double t) const { return std::max(std::abs(w), std::abs(spin(t))); }  ///< over [0, t]
};

/// A prescribed rotation: R(t) = exp(t w + t^2 alpha / 2) R(0), world frame. At rest by default.
struct GivenRotation {
  Rotation3 start;
  Vec3 w = Vec3::Zero(), alpha = Vec3::Zero();

  /// The rotation that begins at `start` with spin w and reaches `end` after h.
  static GivenRotation between(const Rotation3& start, const Vec3& w, const Rotation3& end, double h);
  Turn at(double t) const;
  /// The same rotation in a frame at rest that is turned by `frame`.
  GivenRotation seen_from(const Rotation3& frame) const {
    return {frame.inverse() * start, frame.inverse(w), frame.inverse(alpha)};
  }
  /// Bounds on |w| [rad/s] and |w'| [rad/s2] over [0, t].
  double greatest_spin(double t) const;
  double greatest_spin_rate(double t) const;
};

/// In free flight the rotation is free. In a contact step, and for a driven body, it is prescribed.
struct Motion3 : Path<3> {
  std::variant<GivenRotation, FreeRotation> rotation;

  Turn turn(double t) const;
  double greatest_spin(double t) const;       ///< rad/s over [0, t]
  double greatest_spin_rate(double t) const;  ///< rad/s2 over [0, t]
};

/// A bound on the way of a place at most `bound` [m] from the centre, over [0, t] [m].
template <class Motion>
double greatest_travel(const Motion& motion, double bound, double t) {
  const double speed = motion.v.norm() + t * motion.a.norm();
  return t * (speed + motion.greatest_spin(t) * bound);
}

/// A time interval a <= b [s]; empty if a > b.
struct TimeWindow {
  double a = 0, b = -1;
  bool empty() const { return a > b; }
};

/// The length of the path over [0, t] [m].
template <int D>
double path_length(const Path<D>& path, double t);

/// A time window in [0, t_max]. Outside it, a circle (sphere) of radius r about the moving point does not
/// meet the box.
template <int D>
TimeWindow meeting_window(const Path<D>& path, double r, const Box<D>& box, double t_max);

/// The box that contains the moving circle (sphere) over [0, t].
template <int D>
Box<D> swept_box(const Path<D>& path, double r, double t);

}  // namespace flyrock
