#pragma once
// The state of a body as results describe it.

#include "record/observe.h"
#include "world/body.h"
#include "world/motions.h"

namespace flyrock {

/// `time` [s], place [m], velocity [m/s] and attitude and spin of a body; only dynamic bodies have an energy.
template <int D>
BodyState state_of(const Body<D>& body, double time, const Vec<D>& x, const Vec<D>& v,
                   const Turned<D>& turned) {
  BodyState state;
  state.time = time;
  state.position.template head<D>() = x;
  state.velocity.template head<D>() = v;
  if constexpr (D == 2) {
    state.spin.z() = turned.spin;
    state.angle = turned.attitude.angle;
  } else {
    state.spin = turned.spin;
  }
  if (body.kind == BodyKind::dynamic)
    state.kinetic_energy =
        0.5 * (body.mass * v.squaredNorm() + twice_spin_energy(body, turned.attitude, turned.spin));
  if (body.deforms()) state.kinetic_energy += body.deformation.vibration_energy();
  if (body.breathes()) state.kinetic_energy += body.breathing.kinetic_energy();
  return state;
}

/// The state that the body has now.
template <int D>
BodyState state_of(const Body<D>& body, double time) {
  return state_of(body, time, body.x, body.v, {body.attitude, body.w});
}

}  // namespace flyrock
