#pragma once
// The motion of one body over a short or long interval.

#include <variant>

#include "math/free_rotation.h"
#include "math/space.h"

namespace flyrock {

/// Of the centre of mass: x(t) = x + v t + a t^2 / 2, from t = 0. In flight a is gravity; over a contact step
/// the mean acceleration of the step.
template <int D>
struct Path {
  Vec<D> x = Vec<D>::Zero(), v = Vec<D>::Zero(), a = Vec<D>::Zero();

  Vec<D> position(double t) const { return x + t * (v + 0.5 * t * a); }
  Vec<D> velocity(double t) const { return v + t * a; }
};

/// angle(t) = angle + w t + alpha t^2 / 2. In flight alpha is 0; over a contact step it is the mean of the
/// step.
struct Motion2 : Path<2> {
  double angle = 0, w = 0, alpha = 0;

  double angle_at(double t) const { return angle + t * (w + 0.5 * t * alpha); }
  double spin(double t) const { return w + t * alpha; }
};

/// A rotation along a given path: R(t) = exp(t w + t^2 alpha / 2) R(0), world frame. At rest by default.
struct GivenRotation {
  Rotation3 start;
  Vec3 w = Vec3::Zero(), alpha = Vec3::Zero();

  /// The path from `start` with spin w that is at `end` after h.
  static GivenRotation between(const Rotation3& start, const Vec3& w, const Rotation3& end, double h);
  Turn at(double t) const;
  /// Bounds of |w| and |w'| over [0, t].
  double greatest_spin(double t) const;
  double greatest_spin_rate(double t) const;
};

/// In flight the rotation is free; over a contact step, and for a driven body, it is given.
struct Motion3 : Path<3> {
  std::variant<GivenRotation, FreeRotation> rotation;

  Turn turn(double t) const;
  double greatest_spin(double t) const;       ///< rad/s over [0, t]
  double greatest_spin_rate(double t) const;  ///< rad/s2 over [0, t]
};

/// Times a <= b; empty where a > b.
struct TimeWindow {
  double a = 0, b = -1;
  bool empty() const { return a > b; }
};

/// The length of the path over [0, t].
template <int D>
double path_length(const Path<D>& path, double t);

/// A box with sides along the axes.
template <int D>
struct Box {
  Vec<D> low = Vec<D>::Zero(), high = Vec<D>::Zero();
  bool overlaps(const Box& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
};
using Box2 = Box<2>;
using Box3 = Box<3>;

/// A window in [0, t_max] outside of which a circle (sphere) of radius r about the moving point does not meet
/// the box.
template <int D>
TimeWindow meeting_window(const Path<D>& path, double r, const Box<D>& box, double t_max);

/// The box of the moving circle (sphere) over [0, t].
template <int D>
Box<D> swept_box(const Path<D>& path, double r, double t);

}  // namespace flyrock
