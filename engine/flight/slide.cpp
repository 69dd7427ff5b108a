#include "flight/slide.h"

#include <algorithm>
#include <cmath>

namespace flyrock {

namespace {

constexpr double parallel = 1e-7;  // rad: the error of taking the path as straight is its square

/// Straight ahead with a constant acceleration along `direction`.
template <int D>
Arc<D> straight(double start, double longest, const Vec<D>& position, const Vec<D>& velocity,
                const Vec<D>& acceleration, double slow, bool& stops) {
  const double speed = velocity.norm();
  const double rate = speed > 0 ? acceleration.dot(velocity) / speed : 0;
  double length = longest;
  // Slightly above `slow`, so that the speed falls below it in the next arc.
  if (rate < 0 && slow > 0 && speed > slow * (1 + 1e-9))
    length = std::min(length, (slow * (1 + 1e-10) - speed) / rate);
  if (rate < 0 && -speed / rate <= length) {
    length = -speed / rate;
    stops = true;
  }
  return parabola(start, length, FlightState<D>{position, velocity, acceleration});
}

/// A leg of a path that turns towards the pull.
struct Turning {
  double k, u0, scale;  // A
  double pull;

  static double power(double q, double log_r) {  // P(q)
    return std::abs(q * log_r) < 1e-12 ? -log_r : -std::expm1(q * log_r) / q;
  }
  double time(double log_r) const {
    return scale / pull * (power(k - 1, log_r) + u0 * u0 * power(k + 1, log_r));
  }
  double along(double log_r) const {
    return scale * scale / pull * (power(2 * k - 2, log_r) - std::pow(u0, 4) * power(2 * k + 2, log_r));
  }
  double across(double log_r) const {
    return 2 * scale * scale / pull *
           (u0 * power(2 * k - 1, log_r) + std::pow(u0, 3) * power(2 * k + 1, log_r));
  }
  double speed(double log_r) const {
    return scale * (std::exp((k - 1) * log_r) + u0 * u0 * std::exp((k + 1) * log_r));
  }
};

Arc<3> turned(double start, double longest, const Vec3& position, const Sliding<3>& sliding, double angle) {
  const double pull = sliding.pull.norm(), speed = sliding.velocity.norm();
  const Vec3 down = sliding.pull / pull;
  const Vec3 side = (sliding.velocity - sliding.velocity.dot(down) * down).normalized();
  const double u0 = std::tan(0.5 * angle);
  const Turning turning{sliding.friction / pull, u0, speed / (1 + u0 * u0), pull};
  constexpr double turn = 0.1, share = 0.8;
  double log_r = std::log(std::max(angle > turn ? std::tan(0.5 * (angle - turn)) / u0 : 0.0, share));
  // A leg that is too long is cut where its time is `longest`; time grows as log_r falls.
  if (turning.time(log_r) > longest) {
    double low = log_r, high = 0;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (turning.time(middle) > longest ? low : high) = middle;
    }
    log_r = high;
  }
  const double u = u0 * std::exp(log_r), square = u * u;
  FlightState<3> from{position, sliding.velocity, sliding.acceleration()}, to;
  to.position = position + turning.along(log_r) * down + turning.across(log_r) * side;
  Sliding<3> after = sliding;
  after.velocity = turning.speed(log_r) / (1 + square) * ((1 - square) * down + 2 * u * side);
  to.velocity = after.velocity;
  to.acceleration = after.acceleration();
  return arc_between(start, turning.time(log_r), from, to);
}

/// The angle between velocity and pull [rad].
double angle_of(const Vec3& velocity, const Vec3& pull) {
  return std::atan2(velocity.cross(pull).norm(), velocity.dot(pull));
}

}  // namespace

template <int D>
Vec<D> Sliding<D>::acceleration() const {
  const double speed = velocity.norm(), strength = pull.norm();
  if (speed > 0) return pull - friction / speed * velocity;
  if (strength <= holds) return Vec<D>::Zero();
  return (1 - friction / strength) * pull;
}

template <int D>
Arc<D> slide(double start, double longest, const Vec<D>& position, const Sliding<D>& sliding, double slow,
             bool& stops) {
  stops = false;
  if constexpr (D == 3) {
    if (!sliding.velocity.isZero(0) && !sliding.pull.isZero(0) && sliding.friction > 0) {
      const double angle = angle_of(sliding.velocity, sliding.pull);
      if (angle > parallel && angle < pi - parallel) return turned(start, longest, position, sliding, angle);
    }
  }
  return straight<D>(start, longest, position, sliding.velocity, sliding.acceleration(), slow, stops);
}

template struct Sliding<2>;
template struct Sliding<3>;
template Arc<2> slide(double, double, const Vec2&, const Sliding<2>&, double, bool&);
template Arc<3> slide(double, double, const Vec3&, const Sliding<3>&, double, bool&);

}  // namespace flyrock
