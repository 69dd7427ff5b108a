#pragma once
// The motions of bodies: free motion, the path over a step of the scheme, and the mean motion of a step.

#include "world/body.h"

namespace flyrock {

/// Attitude and spin of a body at one time of a motion.
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

/// Position, attitude and velocities of a body at one time.
template <int D>
struct Moment {
  Vec<D> x, v;
  Attitude<D> attitude;
  typename Space<D>::Spin w;
  Breathing::State shape;

  typename Geometry<D>::Pose pose() const { return {x, attitude.rotation}; }
};
template <int D>
Moment<D> moment_of(const Body<D>& body) {
  return {body.x, body.v, body.attitude, body.w, body.breathing.now};
}

/// The motion from `start` under gravity and the acceleration by the air, without torque. A body that forces
/// do not move keeps its velocities.
Motion2 free_motion(const Body<2>& body, const Moment<2>& start, const Vec2& gravity);
Motion3 free_motion(const Body<3>& body, const Moment<3>& start, const Vec3& gravity);

/// The path of a step of length h from `start` to the present state of `body`. Its velocity
///    v + 2 theta (v+ - v) t / h
/// takes x to the same end as the mean velocity of the scheme, (1 - theta) v + theta v+.
Motion2 step_motion(const Moment<2>& start, const Body<2>& body, double h, double theta);
Motion3 step_motion(const Moment<3>& start, const Body<3>& body, double h, double theta);

/// The same with the constant mean velocities of the step.
Motion2 mean_motion(const Moment<2>& start, const Body<2>& body, double h);
Motion3 mean_motion(const Moment<3>& start, const Body<3>& body, double h);

/// By how much the shape grows at most along a motion of length h [m].
inline double greatest_swell(const Motion2& motion, double h) {
  return std::max(0.0, motion.swell.greatest(h));
}
inline double greatest_swell(const Motion3&, double) { return 0; }

}  // namespace flyrock
