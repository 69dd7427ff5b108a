// The pushes of contacts and links on the spins of bodies, which the gyroscopic moment of a step feels.

#include "world/world.h"

namespace flyrock {

/// The change of the spin that contacts are expected to make in a step [rad/s].
template <int D>
typename Space<D>::Spin World<D>::foreseen_push(std::size_t i, double h) const {
  const typename Space<D>::Spin push = h * by_contacts_[i];
  return goes_on(push, bodies[i].w, h, last_step_) ? push : Space<D>::no_spin();
}

/// The change of the spin by the contacts of the step that has been solved [rad/s].
template <int D>
typename Space<D>::Spin World<D>::push_of_contacts(std::size_t i) const {
  return bodies[i].w - Space<D>::spin_of(free_[i]);
}

/// The energy that body i loses in a step, before it has turned on from the middle, because its contacts
/// change its spin otherwise than free_spin foresaw, by p instead of q [J]:
///   h theta (p - q) . (w_th x I w_th),  w_th of free_spin.
template <int D>
double World<D>::lost_by_turning(std::size_t i, double h) const {
  if constexpr (D == 3) {
    const double theta = settings_.theta;
    const Vec3 middle = (1 - theta) * starts_[i].w + theta * (Space<3>::spin_of(free_[i]) + foreseen_[i]);
    const Vec3 missed = push_of_contacts(i) - foreseen_[i];
    return h * theta * missed.dot(gyroscopic_moment(bodies[i], middle));
  }
  return 0;
}

/// Whether lost_by_turning is a notable share of the energy of a body. So it may be in the first step after
/// an impact, when nothing is foreseen.
template <int D>
bool World<D>::pushed_otherwise(double h) const {
  constexpr double notable = 1e-7;
  if (D == 2) return false;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Body<D>& body = bodies[i];
    if (!body.moves()) continue;
    if (std::abs(lost_by_turning(i, h)) > notable * (body.kinetic_energy() + body.mass * g_ * body.size))
      return true;
  }
  return false;
}

/// Solves the step from the velocities that the bodies have without contacts and links.
template <int D>
void World<D>::solve_step(double h, double warm) {
  links.hold(bodies);
  assemble(h, warm);
  last_solve_ = {};
  pressed_.clear();
  if (!contacts_.empty()) solve_and_apply();
}

/// Solves the step anew with the pushes that it has found, from the impulses that it has found.
template <int D>
void World<D>::solve_with_found_pushes(double h) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    Body<D>& body = bodies[i];
    if (!body.moves()) continue;
    foreseen_[i] = push_of_contacts(i);
    body.v = free_[i].template head<D>();
    body.w = starts_[i].w;
    body.w = free_spin(body, h, settings_.theta, foreseen_[i]);
    free_[i] = body.velocity();
    if (changes_shape(body)) take_back_pushes(body, starts_[i].shape, h, settings_.theta);
  }
  solve_step(h, 1);
}

#define FLYROCK_INSTANTIATE(D)                                                \
  template Space<D>::Spin World<D>::foreseen_push(std::size_t, double) const; \
  template Space<D>::Spin World<D>::push_of_contacts(std::size_t) const;      \
  template double World<D>::lost_by_turning(std::size_t, double) const;       \
  template bool World<D>::pushed_otherwise(double) const;                     \
  template void World<D>::solve_step(double, double);                         \
  template void World<D>::solve_with_found_pushes(double)
FLYROCK_INSTANTIATE(2);
FLYROCK_INSTANTIATE(3);
#undef FLYROCK_INSTANTIATE

}  // namespace flyrock
