#pragma once
// The motions of bodies: free, over a step of the scheme, and the mean motion of a step.

#include "world/body.h"

namespace flyrock {

/// How a body is turned, and its spin, at one moment of a motion.
template <int D>
struct Turned {
  Attitude<D> attitude;
  typename Space<D>::Spin spin;
};
inline Turned<2> turn_at(const Motion2& motion, double t) { return {motion.angle_at(t), motion.spin(t)}; }
inline Turned<3> turn_at(const Motion3& motion, double t) {
  const Turn turn = motion.turn(t);
  return {turn.rotation, turn.spin};
}

/// Place and velocities of a body at one moment.
template <int D>
struct Moment {
  Vec<D> x, v;
  Attitude<D> attitude;
  typename Space<D>::Spin w;
};
template <int D>
Moment<D> moment_of(const Body<D>& body) {
  return {body.x, body.v, body.attitude, body.w};
}

/// From `start`, under gravity and the push of the air, without torque; a body that forces do not move keeps
/// its velocities.
Motion2 free_motion(const Body<2>& body, const Moment<2>& start, const Vec2& gravity);
Motion3 free_motion(const Body<3>& body, const Moment<3>& start, const Vec3& gravity);

/// The path of a step of length h from `start` to the present state of `body`: velocities begin as at the
/// start and change by 2 theta (v+ - v) t / h, so that x arrives where (1 - theta) v + theta v+ carries it.
Motion2 step_motion(const Moment<2>& start, const Body<2>& body, double h, double theta);
Motion3 step_motion(const Moment<3>& start, const Body<3>& body, double h, double theta);

/// The same with the constant mean velocities of the step.
Motion2 mean_motion(const Moment<2>& start, const Body<2>& body, double h);
Motion3 mean_motion(const Moment<3>& start, const Body<3>& body, double h);

}  // namespace flyrock
