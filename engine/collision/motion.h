#pragma once
// The motion of one body over a short or long interval.

#include "math/space.h"

namespace flyrock {

/// x(t) = x + v t + a t^2 / 2, angle(t) = angle + w t + alpha t^2 / 2, from t = 0. In flight a is gravity and alpha
/// 0; over a contact step a and alpha are the mean accelerations of the step.
struct Motion2 {
  Vec2 x = Vec2::Zero(), v = Vec2::Zero(), a = Vec2::Zero();
  double angle = 0, w = 0, alpha = 0;

  Vec2 position(double t) const { return x + t * (v + 0.5 * t * a); }
  Vec2 velocity(double t) const { return v + t * a; }
  double angle_at(double t) const { return angle + t * (w + 0.5 * t * alpha); }
  double spin(double t) const { return w + t * alpha; }
};

/// Times a <= b; empty where a > b.
struct TimeWindow {
  double a = 0, b = -1;
  bool empty() const { return a > b; }
};

/// The length of the path over [0, t].
double path_length(const Motion2& motion, double t);

/// A box with sides along the axes.
struct Box2 {
  Vec2 low = Vec2::Zero(), high = Vec2::Zero();
  bool overlaps(const Box2& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
};

/// A window in [0, t_max] outside of which a circle of radius r about the moving point does not meet the box.
TimeWindow meeting_window(const Motion2& motion, double r, const Box2& box, double t_max);

/// The box of the moving circle over [0, t].
Box2 swept_box(const Motion2& motion, double r, double t);

}  // namespace flyrock
