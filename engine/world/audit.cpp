// Audits the energy of impacts and steps: what contacts gain, and by how much it may err.

#include <algorithm>

#include "solver/spring.h"
#include "world/world.h"

namespace flyrock {

/// The work of the driven bodies of contact a on the other bodies in a step of length h [J].
template <int D>
double World<D>::work_of_driven(int a, double h) const {
  double work = 0;
  for_bodies(a, [&](int body, const auto& columns) {
    if (bodies[body].kind != BodyKind::driven) return;
    typename Body<D>::Rows mean = bodies[body].velocity();
    mean.template head<D>() -= 0.5 * h * bodies[body].push;
    work -= contacts_[a].impulse.dot(columns.transpose() * mean);
  });
  return work;
}

/// Counts energy gains: the energy that the contacts of an island add in an impact or in a step of length h.
/// In a step it should not exceed rounding plus |r| g h / 2 for each contact, because a contact may open or
/// reverse its slip within the step. A node of a deformable block may also gain |r| h turn_of_node / 2: the
/// step holds its velocity in the middle, and from there to the middle of the next one the block turns.
template <int D>
void World<D>::audit_energy(double h) {
  constexpr double error_of_turning = 0.1;
  for (int a = 0; a < static_cast<int>(contacts_.size()); ++a) {
    energy_given_ += work_of_driven(a, h);
    energy_in_doubt_ += error_of_turning * h * contacts_[a].impulse.template head<D>().norm() *
                        contacts_[a].turning.template head<D>().norm();
  }
  const auto of_links = links.work(bodies);
  energy_given_ += of_links.of_driven;
  energy_in_doubt_ += of_links.in_doubt;
  doubt_springs(h);
  if (h == 0) {
    audit_impact();
    return;
  }
  island_gain_.assign(islands_.count(), 0.0);
  for (int a = 0; a < static_cast<int>(contacts_.size()); ++a) {
    const Contact& contact = contacts_[a];
    double& gain = island_gain_[islands_.of(a)];
    // A spring only returns the energy that it stored.
    if (contact.law.condition != NormalCondition::penalty) gain += energy_of(a);
    const double pushed = contact.impulse.template head<D>().norm();
    gain -= pushed * (1e-12 * (contact.before.norm() + after_[a].norm()) +
                      10 * tolerance() * problem_.contacts[a].speed_scale + 0.5 * g_ * h);
    // A node is much lighter than its body: its speed is the small difference of great ones.
    if (deforms(contact))
      gain -= std::max(1e-12 * pushed * pushed * problem_.contacts[a].w(0, 0),
                       0.5 * h * pushed * turn_of_node(contact));
  }
  for (const double gain : island_gain_)
    if (gain > 0) {
      ++quality_.energy_gains;
      quality_.energy_gained += gain;
    }
}

/// Measures by how much the energy of springs and of radii may err (energy_in_doubt).
template <int D>
void World<D>::doubt_springs(double h) {
  const double angle = h * spring_rate_;
  for (std::size_t a = 0; a < contacts_.size(); ++a) {
    const Contact& contact = contacts_[a];
    if (contact.law.condition != NormalCondition::penalty) continue;
    const Spring& spring = contact.law.spring;
    const double overlap = contact.compression(contact.at.gap),
                 speed = contact.before.template head<D>().norm();
    const double energy = elastic_energy(spring, overlap) +
                          0.5 * speed * speed / problem_.contacts[a].w(0, 0) +
                          0.5 * spring.tangential_stiffness * contact.stretch.squaredNorm();
    const double place = settings_.step_tolerance * contact_size(contact.candidate, contact.antagonist);
    const double force = spring.stiffness * overlap_power(spring, overlap) * overlap +
                         spring.tangential_stiffness * contact.stretch.norm();
    spring_energy_in_doubt_ =
        std::max(spring_energy_in_doubt_, 0.25 * angle * angle * energy + force * place);
  }
  // The gas and the spring of a shape give back what they took to the same order.
  if (const double breath = h * fastest_breath(); breath > 0) {
    double of_shapes = 0;
    for (const Body<D>& body : bodies)
      if (body.breathes()) of_shapes += body.breathing.exchanged_energy(body.spin_speed());
    spring_energy_in_doubt_ = std::max(spring_energy_in_doubt_, 0.25 * breath * breath * of_shapes);
  }
}

/// Counts what each island of an impact gains beyond the bound: 1e-9 of its kinetic energy where impulses are
/// solved to rounding, 10 times the tolerance of it where they are not. The work of slip of the form
/// `newton`, which slip that stops or reverses can give (Kane), is counted apart. No other form gains more
/// than the bound; beyond a thousandth the bodies have `gained`.
template <int D>
void World<D>::audit_impact() {
  constexpr double rounding = 1e-9, fault = 1e-3;
  balances_.assign(islands_.count(), {});
  touching_.assign(bodies.size(), false);  // those whose energy is counted
  for (int a = 0; a < static_cast<int>(contacts_.size()); ++a) {
    const Contact& c = contacts_[a];
    ImpactBalance& island = balances_[islands_.of(a)];
    ++island.size;
    island.driven += work_of_driven(a, 0);
    for (const int i : {c.candidate, c.antagonist}) {
      if (i < 0 || !bodies[i].moves() || touching_[i]) continue;
      touching_[i] = true;
      island.kinetic += bodies[i].kinetic_energy();
    }
    if (c.law.condition == NormalCondition::penalty) continue;
    island.contacts += energy_of(a);
    const double of_slip = 0.5 * c.impulse.template tail<Problem::rows - 1>().dot(
                                     (c.before + after_[a]).template tail<Problem::rows - 1>());
    if (c.law.form == RestitutionForm::newton) island.by_slip += std::max(0.0, of_slip);
    if (c.manifold < 0) continue;
    island.by_newton = island.by_newton || c.law.form == RestitutionForm::newton;
    island.may_gain = island.may_gain || c.law.e_n > 1 || std::abs(c.law.e_t) > 1;
  }
  for (int k = 0; k < islands_.count(); ++k) {
    const ImpactBalance& island = balances_[k];
    const double gain = island.contacts;
    energy_given_ += std::max(0.0, gain);
    const double kinetic = std::max(island.kinetic, island.kinetic - gain - island.driven);
    const double bound = (island.size <= few_contacts ? rounding : 10 * settings_.tolerance) * kinetic;
    if (gain <= bound) continue;
    const double by_slip = island.by_newton ? std::min(island.by_slip, gain) : 0;
    const double from_nowhere = gain - by_slip;
    if (from_nowhere > bound) {
      ++quality_.energy_gains;
      quality_.energy_gained += from_nowhere;
    }
    if (by_slip > bound) {
      ++quality_.gains_by_slip;
      quality_.gained_by_slip += by_slip;
    }
    if (island.may_gain || from_nowhere <= fault * kinetic) continue;
    for (int a = 0; a < static_cast<int>(contacts_.size()); ++a)
      for (const int i : {contacts_[a].candidate, contacts_[a].antagonist})
        if (islands_.of(a) == k && i >= 0 && bodies[i].moves())
          gained_.push_back({i, from_nowhere / kinetic});
  }
}

#define FLYROCK_INSTANTIATE(D) template void World<D>::audit_energy(double)
FLYROCK_INSTANTIATE(2);
FLYROCK_INSTANTIATE(3);
#undef FLYROCK_INSTANTIATE

}  // namespace flyrock
