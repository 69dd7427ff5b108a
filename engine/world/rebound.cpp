// Solves the friction problem with restitution, applies the solution, and records impacts.

#include <algorithm>

#include "solver/law_terms.h"
#include "solver/spring.h"
#include "world/manifold.h"
#include "world/world.h"

namespace flyrock {

template <int D>
void World<D>::apply_laws(double h) {
  rebounds_.resize(contacts_.size());
  spring_rate_ = links.fastest();
  damper_rates_.assign(contacts_.size(), 0.0);
  for (std::size_t a = 0; a < contacts_.size(); ++a) {
    const Contact& contact = contacts_[a];
    auto& row = problem_.contacts[a];
    rebounds_[a].before = contact.before;
    set_law<D>(contact.law, contact.sticking, contact.at.gap, h, row, rebounds_[a]);
    if (contact.law.condition == NormalCondition::penalty) apply_spring(static_cast<int>(a), h);
    if (row.w(D, D) <= 0)
      row.mu_r = row.mu_spin = row.c_r = row.c_spin =
          0;  // a body with negligible rotational inertia cannot roll
  }
}

/// Writes the spring of contact a into the problem, and measures how fast it changes: by the
/// stiffness and the damping where the body turns round, because those of a spring of Hertz begin with 0.
template <int D>
void World<D>::apply_spring(int a, double h) {
  Contact& contact = contacts_[a];
  const Spring& spring = contact.law.spring;
  const double w = problem_.contacts[a].w(0, 0), overlap = contact.compression(contact.at.gap);
  double power = 1;
  if (spring.exponent != 1) {
    constexpr double soon = 1e-3;  // s, in which its weight speeds up a body that lies on the spring
    const double speed = std::abs(contact.before[0]) + g_ * std::max(h, soon);
    power = overlap_power(spring, turning_overlap(spring, overlap, speed, w));
  }
  const double stiffness = spring.exponent * spring.stiffness * power;
  const double stiffest =
      spring.tangential_stiffness * problem_.contacts[a].w.diagonal().template segment<D - 1>(1).maxCoeff();
  const double damping = spring.damping * power, swings = std::sqrt(stiffness * w);
  const bool creeps = damping * w > 2 * swings;  // nothing swings: the rate is k/c
  spring_rate_ = std::max({spring_rate_, creeps ? stiffness / damping : swings, std::sqrt(stiffest)});
  damper_rates_[a] = damping * w;

  // The stretch turns with the plane of the contact and grows by the slip until the middle of the step.
  const auto tangents = contact_frame(contact.at.normal).template rightCols<D - 1>().eval();
  Vec<D - 1> stretch = tangents.transpose() * contact.stretch;
  if (stretch.norm() > 0) stretch *= contact.stretch.norm() / stretch.norm();
  stretch += (1 - settings_.theta) * h * tangential(contact.before);
  set_spring<D>(spring, overlap, stretch, h, problem_, a, rebounds_[a]);
}

/// The sweeps that a dense problem has: few of a pile of hundreds, whose contacts change in every step, and
/// more of a stack or a slope of tens of blocks, which would move where it can stand.
template <int D>
int World<D>::dense_sweeps() const {
  constexpr int least = 100, most = 1000, contact_solves = 20'000;
  const int contacts = std::max(1, static_cast<int>(contacts_.size()));
  return settings_.dense_iterations.value_or(std::clamp(contact_solves / contacts, least, most));
}

/// A dense problem whose solution would sink a body by a notable share of its size within the step has ten
/// times the sweeps.
template <int D>
SolveResult World<D>::solve() {
  constexpr std::size_t most_of_newton = 100;  // contacts of a dense step, for which its factorisations pay
  constexpr double sinks = 1e-4;               // of the size
  constexpr int more = 10;
  SolveSettings wanted;
  wanted.tolerance = tolerance();
  wanted.to_rounding = !dense_;
  wanted.max_iterations = dense_ ? dense_sweeps() : settings_.max_iterations;
  wanted.solver = settings_.solver;
  if (!dense_) return solver_.solve(problem_, rebounds_, wanted, impulses_);
  if (contacts_.size() > most_of_newton && wanted.solver == SolverKind::automatic)
    wanted.solver = SolverKind::nlgs;
  free_of_contacts_.clear();
  for (const auto& contact : problem_.contacts) free_of_contacts_.push_back(contact.q);
  const SolveResult result = solver_.solve(problem_, rebounds_, wanted, impulses_);
  if (result.converged) return result;
  const Contact& worst = contacts_[result.worst_contact];
  if (ahead_ * result.residual <= sinks * contact_size(worst.candidate, worst.antagonist)) return result;
  for (std::size_t a = 0; a < contacts_.size(); ++a) problem_.contacts[a].q = free_of_contacts_[a];
  wanted.max_iterations *= more;
  SolveResult again = solver_.solve(problem_, rebounds_, wanted, impulses_);
  again.iterations += result.iterations;
  again.work += result.work;
  return again;
}

/// Islands of a few contacts are solved to rounding. The residual of an impact would turn a body that should
/// land flat, and its corners would then arrive one after the other.
template <int D>
void World<D>::solve_and_apply() {
  const PhaseTimer timer(clock, &PhaseTimes::solve);
  if (on_hard_problem) start_ = impulses_;
  const SolveResult result = last_solve_ = solve();
  pressed_.clear();
  ++quality_.problems;
  quality_.iterations += result.iterations;
  solver_work_ += result.work;
  if (!result.converged) {
    ++(dense_ ? quality_.dense_unfinished : quality_.not_converged);
    if (on_hard_problem && !dense_) on_hard_problem(problem_, start_);
    double& greatest = dense_ ? quality_.dense_residual : quality_.not_converged_residual;
    const double scale = problem_.contacts[result.worst_contact].speed_scale;
    if (scale > 0) greatest = std::max(greatest, result.residual / scale);
  }
  if (missed_last_solve() || throws()) find_pressed();
  // Impulses that grow without bound hold nothing: the run ends with the velocities before them.
  if (!pressed_.empty()) std::fill(impulses_.begin(), impulses_.end(), Row::Zero());
  quality_.max_residual = std::max(quality_.max_residual, result.residual);
  for (std::size_t a = 0; a < contacts_.size(); ++a) {
    Contact& contact = contacts_[a];
    contact.impulse = impulses_[a];
    for_bodies(a, [&](int i, const auto& columns) {
      bodies[i].add_velocity(bodies[i].inverse_mass_times(columns * contact.impulse));
      if (changes_shape(bodies[i]))
        push_shape<D>(bodies[i], shape_touch(contact, i), contact.impulse.template head<D>(), theta_h_);
      unsolved_[i] = {result.residual, time};
    });
  }
  links.hold(bodies);
}

/// Solves the impact of the contacts, again until just those ropes pull that are taut.
template <int D>
void World<D>::solve_instant() {
  constexpr int most = 12;
  velocities_.clear();
  for (const Body<D>& body : bodies) velocities_.push_back(body.velocity());
  for (int again = 0;; ++again) {
    solve_and_apply();
    if (links.keeps_instant(bodies) || again == most) return;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      bodies[i].v = velocities_[i].template head<D>();
      bodies[i].w = Space<D>::spin_of(velocities_[i]);
    }
    assemble(0, 0);
  }
}

/// The velocity of contact a at the end of a step of length h (0: an impact).
template <int D>
typename World<D>::Row World<D>::velocity_after(int a, double h) const {
  const Contact& contact = contacts_[a];
  Row u = rows_[a].candidate.transpose() * bodies[contact.candidate].velocity();
  if (contact.antagonist >= 0) u += rows_[a].antagonist.transpose() * bodies[contact.antagonist].velocity();
  add_shape_velocity(contact, u);
  if (h > 0) u += settings_.theta * h * contact.turning;
  return u;
}

template <int D>
void World<D>::measure_after(double h) {
  after_.resize(contacts_.size());
  for (int a = 0; a < static_cast<int>(contacts_.size()); ++a) after_[a] = velocity_after(a, h);
  if (chooses_steps()) limit_by_dampers();
}

/// The work of contact a on its bodies in an impact or step [J].
template <int D>
double World<D>::energy_of(int a) const {
  return 0.5 * contacts_[a].impulse.dot(contacts_[a].before + after_[a]);
}

/// Finds shocks without collision (Painleve): no contact of the island approaches, but the velocity of a
/// contact jumps by far more than forces can change it in one step. Each such contact is recorded as an
/// impact of its own.
template <int D>
void World<D>::find_shocks(double h) {
  constexpr double usual = 20;  // times the change by gravity; friction on a round body reaches 4 at mu = 1
  island_collides_.assign(islands_.count(), false);
  int manifolds = 0;
  for (std::size_t a = 0; a < contacts_.size(); ++a) {
    if (contacts_[a].manifold >= 0) island_collides_[islands_.of(a)] = true;
    manifolds = std::max(manifolds, contacts_[a].manifold + 1);
  }
  for (std::size_t a = 0; a < contacts_.size(); ++a) {
    Contact& contact = contacts_[a];
    const Body<D>& body = bodies[rock_of(contact.candidate, contact.antagonist)];
    const bool yields = contact.law.condition == NormalCondition::penalty || deforms(contact);
    if (island_collides_[islands_.of(a)] || yields) continue;
    const double forces = (g_ + body.push.norm()) * h;
    if ((after_[a] - contact.before).template head<D>().norm() <= settings_.rest_speed + usual * forces)
      continue;
    contact.manifold = manifolds++;
    count_impact(contact);
    ++quality_.shocks;
  }
}

/// Appends one Impact per manifold.
template <int D>
void World<D>::record_impacts() {
  sums_.clear();
  const std::size_t first = impacts_.size();
  for (int a = 0; a < static_cast<int>(contacts_.size()); ++a) {
    const Contact& contact = contacts_[a];
    if (contact.manifold < 0) continue;
    const std::size_t index = first + static_cast<std::size_t>(contact.manifold);
    while (index >=
           impacts_.size()) {  // manifolds of shocks come after the others, not in the order of contacts
      impacts_.emplace_back();
      sums_.emplace_back();
    }
    Impact& impact = impacts_[index];
    ImpactSum& sum = sums_[contact.manifold];
    if (sum.weight == 0) {
      impact.body = contact.rock;
      impact.other = contact.other_than(contact.rock);
      if (contact.antagonist < 0) impact.part = part_of(*terrain_, contact.at.against);
      impact.number = contact.impact_number;
      impact.time = time + contact.touch;
    }
    const double pn = contact.impulse[0];
    impact.pn += pn;
    impact.energy_change += energy_of(a);
    // The tiny weight makes a contact without normal impulse count only if no contact of the manifold has
    // one.
    const double weight = pn + 1e-300;
    sum.weight += weight;
    sum.place += weight * contact.at.point;
    sum.vn_before += weight * contact.before[0];
    sum.vn_after += weight * after_[a][0];
    sum.vt_before += weight * tangential(contact.before);
    sum.vt_after += weight * tangential(after_[a]);
    sum.pt += tangential(contact.impulse);
  }
  // Signed in 2D, magnitudes in 3D.
  const auto slip = [](const Vec<D - 1>& t) { return D == 2 ? t[0] : t.norm(); };
  for (std::size_t i = first; i < impacts_.size(); ++i) {
    Impact& impact = impacts_[i];
    const ImpactSum& sum = sums_[i - first];
    impact.place.template head<D>() = sum.place / sum.weight;
    impact.vn_before = sum.vn_before / sum.weight;
    impact.vn_after = sum.vn_after / sum.weight;
    impact.vt_before = slip(sum.vt_before) / sum.weight;
    impact.vt_after = slip(sum.vt_after) / sum.weight;
    impact.pt = slip(sum.pt);
  }
}

/// Up to which a speed of a contact is what the solver leaves [m/s].
template <int D>
double World<D>::rounding_of_solver(const Contact& contact) const {
  return 10 * tolerance() * contact.speed_scale + 1e-14 * contact.before.norm();
}

/// Whether contact a counts as closed after an impact or a step of length `duration` [s]. A contact with
/// restitution opens at any positive speed. Any other contact opens only above g h / 2. A slower contact
/// would close again within one step, and a rocking block would never come to rest. A node of a deformable
/// block that was pushed stays, whatever the solver leaves of its speed: without the force it would jump.
template <int D>
bool World<D>::stays_closed(int a, double duration) const {
  const Contact& contact = contacts_[a];
  const double speed = after_[a][0];
  if (deforms(contact) && contact.impulse[0] > 0) return true;
  // A spring opens if its gap is positive at the end of the step.
  if (contact.law.condition == NormalCondition::penalty)
    return speed <= 0 || contact.at.gap + contact.born + settings_.theta * duration * speed <= 0;
  if (contact.manifold >= 0 && contact.law.e_n > 0) return speed <= 0;
  return speed <= std::max(rounding_of_solver(contact), 0.5 * g_ * settings_.time_step);
}

/// Whether friction bears all it can at contact a, in an impact or a step of length `duration` [s].
template <int D>
bool World<D>::is_at_bound(int a, double duration) const {
  const Contact& contact = contacts_[a];
  const double most = contact.mu() * contact.impulse[0] + duration * contact.law.c_t;
  return tangential(contact.impulse).norm() >= (1 - 1e-9) * most;
}

/// Whether contact a sticks: it does not slip, or friction could bear more, as where a tangential spring or
/// restitution moves it. The force alone does not tell it: a body on several contacts may share its friction
/// among them in many ways, so that one of them bears all it can although nothing slips.
template <int D>
bool World<D>::sticks(int a) const {
  return !contacts_[a].at_bound || tangential(after_[a]).norm() <= rounding_of_solver(contacts_[a]);
}

/// The stretch of the tangential spring of contact a after a step of length `duration` [s]: in its middle the
/// one whose force friction has let through, and from there on the slip at the end. An impact has no
/// duration, and stretches nothing.
template <int D>
Vec<D> World<D>::stretch_after(int a, double duration) const {
  const Contact& contact = contacts_[a];
  const double stiffness =
      contact.law.condition == NormalCondition::penalty ? contact.law.spring.tangential_stiffness : 0;
  if (stiffness == 0) return Vec<D>::Zero();
  if (duration == 0) return contact.stretch;
  const Vec<D - 1> middle = -tangential(contact.impulse) / (duration * stiffness);
  return contact_frame(contact.at.normal).template rightCols<D - 1>() *
         (middle + settings_.theta * duration * tangential(after_[a]));
}

#define FLYROCK_INSTANTIATE(D)                                        \
  template void World<D>::apply_laws(double);                         \
  template SolveResult World<D>::solve();                             \
  template void World<D>::solve_and_apply();                          \
  template void World<D>::solve_instant();                            \
  template void World<D>::measure_after(double);                      \
  template double World<D>::energy_of(int) const;                     \
  template void World<D>::find_shocks(double);                        \
  template void World<D>::record_impacts();                           \
  template bool World<D>::stays_closed(int, double) const;            \
  template bool World<D>::is_at_bound(int, double) const;             \
  template bool World<D>::sticks(int) const;                          \
  template double World<D>::rounding_of_solver(const Contact&) const; \
  template Vec<D> World<D>::stretch_after(int, double) const
FLYROCK_INSTANTIATE(2);
FLYROCK_INSTANTIATE(3);
#undef FLYROCK_INSTANTIATE

}  // namespace flyrock
