#include "world/motions.h"

namespace flyrock {

Motion2 free_motion(const Body<2>& body, const Moment<2>& start, const Vec2& gravity) {
  return {{start.x, start.v, body.acceleration(gravity)},
          start.attitude.angle,
          start.w,
          0,
          {},
          start.attitude.rotation};
}

Motion3 free_motion(const Body<3>& body, const Moment<3>& start, const Vec3& gravity) {
  if (!body.moves())
    return {{start.x, start.v, body.acceleration(gravity)},
            GivenRotation{start.attitude.rotation, start.w, Vec3::Zero()}};
  return {{start.x, start.v, body.acceleration(gravity)},
          FreeRotation(body.inertia, start.attitude.rotation, start.w)};
}

Motion2 step_motion(const Moment<2>& start, const Body<2>& b, double h, double theta) {
  const double rate = 2 * theta / h;
  Motion2 motion{{start.x, start.v, rate * (b.v - start.v)},
                 start.attitude.angle,
                 start.w,
                 rate * (b.w - start.w),
                 {},
                 start.attitude.rotation};
  if (b.breathes())
    motion.swell = {start.shape.radius - b.breathing.now.radius, start.shape.rate,
                    rate * (b.breathing.now.rate - start.shape.rate)};
  return motion;
}

Motion3 step_motion(const Moment<3>& start, const Body<3>& b, double h, double theta) {
  const double rate = 2 * theta / h;
  return {{start.x, start.v, rate * (b.v - start.v)},
          GivenRotation::between(start.attitude.rotation, start.w, b.attitude.rotation, h)};
}

Motion2 mean_motion(const Moment<2>& start, const Body<2>& b, double h) {
  return {{start.x, (b.x - start.x) / h, Vec2::Zero()},
          start.attitude.angle,
          (b.attitude.angle - start.attitude.angle) / h,
          0};
}

Motion3 mean_motion(const Moment<3>& start, const Body<3>& b, double h) {
  const Vec3 turned = (b.attitude.rotation * start.attitude.rotation.inverse()).vector();
  return {{start.x, (b.x - start.x) / h, Vec3::Zero()},
          GivenRotation{start.attitude.rotation, turned / h, Vec3::Zero()}};
}

}  // namespace flyrock
