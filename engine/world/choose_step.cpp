// The length of the next step, and what the error of a step is made of besides accelerations.

#include <algorithm>

#include "world/world.h"

namespace flyrock {

namespace {

/// The longest step that gives a rate [rad/s] enough steps a period.
double enough_steps(double rate) { return rate > 0 ? 2 * pi / steps_a_period / rate : infinite; }

}  // namespace

template <int D>
double World<D>::step_length() {
  if (dense_) return dense_length();
  if (!chooses_steps()) return settings_.time_step;
  touching_.assign(bodies.size(), false);
  for (const Contact& c : last_) {
    // A spring keeps its energy only if the steps are equal.
    if (c.law.condition == NormalCondition::penalty) continue;
    for (const int body : {c.candidate, c.antagonist})
      if (body >= 0) touching_[body] = true;
  }
  return std::min(control_.length(bodies, touching_), longest_of_springs());
}

/// For how many usual phases the error of a step acts. Where a contact turns, errors add up over a phase that
/// nothing ends: for as long again as it has lasted, and a while more. A swing between bodies (in a drum, a
/// ball on a turntable, a slab on a boulder) counts from its begin; on the ground, and where the place of a
/// rim walks, from where it has once turned by more than a little, and goes on in the flight from a crest.
template <int D>
double World<D>::phases_so_far() const {
  constexpr double of_swing = 16, of_flight = 1;  // s
  double longest = usual_phase;
  for (const Contact& c : contacts_) {
    if (!c.lasts || c.impulse[0] <= 0) continue;
    if (c.antagonist >= 0 && !c.walks)
      longest = std::max(longest, c.age + of_swing);
    else if (c.has_turned)
      longest = std::max(longest, c.age + of_flight);
  }
  return longest / usual_phase;
}

/// The greatest angular frequency of the radii that move [rad/s]; 0 if all bodies are rigid.
template <int D>
double World<D>::fastest_breath() const {
  double fastest = 0;
  for (const Body<D>& body : bodies)
    if (body.breathes()) fastest = std::max(fastest, body.breathing.frequency(body.spin_speed()));
  return fastest;
}

/// The longest step for the dampers of the last step or impact [s]: enough steps for a speed to decay, or so
/// long that a contact errs in place by little, once its speed has decayed. Reads after_.
template <int D>
void World<D>::limit_by_dampers() {
  constexpr double small = 0.01;  // of the tolerance
  longest_of_dampers_ = infinite;
  for (std::size_t a = 0; a < damper_rates_.size(); ++a) {
    const double decays = enough_steps(damper_rates_[a]);
    const Contact& c = contacts_[a];
    const double place = small * settings_.step_tolerance * contact_size(c.candidate, c.antagonist);
    const double changes = std::abs(after_[a][0] - c.before[0]);
    if (changes > 0) longest_of_dampers_ = std::min(longest_of_dampers_, std::max(decays, place / changes));
  }
}

/// The longest step for the springs and dampers of the last step or impact, and the radii that move [s].
template <int D>
double World<D>::longest_of_springs() const {
  return std::min(longest_of_dampers_, enough_steps(std::max(spring_rate_, fastest_breath())));
}

/// How deep rims in a hollow contactor have sunk by the end of a step, as a share of what they may. The place
/// of a rim that is nearest to the wall walks, and the search passes over it while it is held.
template <int D>
double World<D>::sunk_rims() const {
  double deepest = 0;
  if constexpr (D == 3) {
    constexpr double most = 1e-5;  // of the size
    for (const Contact& c : contacts_) {
      if (c.antagonist < 0 || c.law.condition == NormalCondition::penalty) continue;
      const Contactor3& a = bodies[c.candidate].contactor_with(c.at.feature);
      const Contactor3& b = bodies[c.antagonist].contactor_with(c.at.against);
      if ((a.form == Form::hollow && !b.circles.empty()) || (b.form == Form::hollow && !a.circles.empty()))
        deepest = std::max(deepest, (-gap_at(c, false) - carry_reach(c.candidate, c.antagonist)) /
                                        (most * contact_size(c.candidate, c.antagonist)));
    }
  }
  return deepest;
}

/// The velocity error of each body due to friction [m/s]: half of the change of its velocity (plus that of
/// its spin times the radius) if friction and rolling resistance had the direction of the start of the step
/// instead of its end, or the coefficients of the last step. A contact that ends at rest causes no error,
/// because the solver finds the impulse that stops it. If the direction turns smoothly, the error is
/// multiplied by the number of steps in half of the phase so far, because it recurs in each of them.
/// Reads after_.
template <int D>
std::span<const double> World<D>::doubt_of_friction(double h) {
  constexpr double at_rest = 1e-6;  // of the speed of the contact or of its bodies, or of the speed of rest
  constexpr double smooth = 0.5;    // rad
  doubt_.assign(bodies.size(), 0.0);
  const auto speed_of = [&](int i) {
    return i < 0 ? 0 : starts_[i].v.norm() + bodies[i].radius * spin_speed(starts_[i].w);
  };
  for (std::size_t a = 0; a < contacts_.size(); ++a) {
    const Contact& contact = contacts_[a];
    if (contact.impulse[0] <= 0) continue;
    const Row& after = after_[a];
    Row half = Row::Zero();
    const auto doubt = [&](int first, int count, double impulse, const auto& change) {
      const double times =
          change.norm() < smooth ? std::max(1.0, 0.5 * std::max(usual_phase, contact.age) / h) : 1;
      half.segment(first, count) += 0.5 * times * impulse * change;
    };
    const auto turn = [&](int first, int count, double usual) {
      const double impulse = contact.impulse.segment(first, count).norm();
      if (impulse == 0) return;
      const auto from = contact.before.segment(first, count), to = after.segment(first, count);
      const double slow = from.norm(), fast = to.norm(), still = at_rest * std::max({slow, fast, usual});
      if (fast <= still || slow <= still) return;
      doubt(first, count, impulse, (to / fast - from / slow).eval());
    };
    const double speed =
        std::max({speed_of(contact.candidate), speed_of(contact.antagonist), settings_.rest_speed});
    const double spin = speed / bodies[contact.candidate].radius;
    turn(1, D - 1, speed);
    const double slip = tangential(after).norm();
    if (contact.carried && slip > at_rest * tangential(contact.before).norm()) {
      const double bound = contact.mu() * contact.impulse[0] + h * contact.law.c_t;
      const double bound_before = contact.mu_before * contact.impulse[0] + h * contact.c_t_before;
      if (bound > 0) doubt(1, D - 1, bound, ((1 - bound_before / bound) / slip * tangential(after)).eval());
    }
    if constexpr (D == 3) turn(D, 1, spin);
    turn(Problem::rows - (D - 1), D - 1, spin);
    if (half.isZero(0)) continue;
    for_bodies(a, [&](int i, const auto& columns) {
      if (!bodies[i].moves()) return;
      const typename Body<D>::Rows change = bodies[i].inverse_mass_times(columns * half);
      doubt_[i] +=
          change.template head<D>().norm() + bodies[i].radius * change.tail(change.size() - D).norm();
    });
  }
  return doubt_;
}

#define FLYROCK_INSTANTIATE(D)                          \
  template double World<D>::step_length();              \
  template double World<D>::phases_so_far() const;      \
  template double World<D>::fastest_breath() const;     \
  template double World<D>::longest_of_springs() const; \
  template double World<D>::sunk_rims() const;          \
  template void World<D>::limit_by_dampers();           \
  template std::span<const double> World<D>::doubt_of_friction(double)
FLYROCK_INSTANTIATE(2);
FLYROCK_INSTANTIATE(3);
#undef FLYROCK_INSTANTIATE

}  // namespace flyrock
