// The friction problem of the active contacts: laws, Delassus operator, right-hand side; its solution applied.

#include <algorithm>
#include <cmath>

#include "world/manifold.h"
#include "world/world.h"

namespace flyrock {

namespace {

/// The columns n, t, rolling of H for a body with lever r: they map its (v, w) to the velocity of the contact.
Eigen::Matrix3d contact_columns(const Vec2& normal, const Vec2& r) {
  const Vec2 tangent = tangent_of(normal);
  Eigen::Matrix3d columns;
  columns << normal.x(), tangent.x(), 0,  //
      normal.y(), tangent.y(), 0,         //
      cross(r, normal), cross(r, tangent), 1;
  return columns;
}

}  // namespace

template <int D>
typename World<D>::Row World<D>::relative_velocity(const Contact& contact) const {
  const Body<D>& a = bodies[contact.candidate];
  const Vec<D> t = tangent_of(contact.at.normal);
  Vec<D> v = a.velocity_at(contact.at.point);
  double spin = a.w;
  if (contact.antagonist >= 0) {
    v -= bodies[contact.antagonist].velocity_at(contact.at.point);
    spin -= bodies[contact.antagonist].w;
  }
  return {contact.at.normal.dot(v), t.dot(v), spin};
}

template <int D>
void World<D>::measure_before() {
  for (Contact& contact : contacts_) contact.before = relative_velocity(contact);
}

template <int D>
ContactState World<D>::state_of(const Contact& contact) const {
  const Body<D>& body = bodies[contact.candidate];
  ContactState state;
  state.approach_speed = contact.approach();
  state.slip_speed = std::abs(contact.before[1]);
  state.impact_angle = std::atan2(state.approach_speed, state.slip_speed);
  state.gap = contact.at.gap;
  double inverse_mass = 0;
  for (const int i : {contact.candidate, contact.antagonist}) {
    if (i < 0) continue;
    const typename Body<D>::Rows h = contact_columns(contact.at.normal, contact.at.point - bodies[i].x).col(0);
    inverse_mass += h.dot(bodies[i].inverse_mass_times(h));
  }
  state.effective_mass = 1 / inverse_mass;
  state.mass = body.mass;
  state.radius = body.radius;
  state.spin = std::abs(body.w);
  state.kinetic_energy = body.kinetic_energy();
  // Half the distance to the other points of the same manifold is this point's tributary length.
  for (const Contact& other : contacts_)
    if (&other != &contact && other.candidate == contact.candidate && other.antagonist == contact.antagonist &&
        same_direction<D>(other.at.normal, contact.at.normal))
      state.length += 0.5 * (other.at.point - contact.at.point).norm();
  state.age = contact.age;
  state.was_sticking = contact.sticking;
  state.impact_number = body.impacts;
  state.time = time;
  state.group_a = body.group;
  if (contact.antagonist >= 0)
    state.group_b = bodies[contact.antagonist].group;
  else
    state.group_b = terrain_->profile().parts[part_of(*terrain_, contact.at.against)];
  state.material = contact.surface->material;
  return state;
}

/// The velocity H v of contact a now, in the frame of detection (the bodies may have moved on).
template <int D>
typename World<D>::Row World<D>::velocity_after(int a) const {
  const Contact& contact = contacts_[a];
  Row u = rows_[a].candidate.transpose() * bodies[contact.candidate].velocity();
  if (contact.antagonist >= 0) u += rows_[a].antagonist.transpose() * bodies[contact.antagonist].velocity();
  return u;
}

/// Groups the contacts that close faster than rest_speed into manifolds, and counts them as impacts of their bodies.
template <int D>
void World<D>::begin_manifolds() {
  int manifolds = 0;
  for (std::size_t i = 0; i < contacts_.size(); ++i) {
    Contact& contact = contacts_[i];
    contact.manifold = -1;
    if (contact.approach() <= settings_.rest_speed) continue;
    for (std::size_t k = 0; k < i && contact.manifold < 0; ++k) {
      const Contact& other = contacts_[k];
      if (other.manifold >= 0 && other.candidate == contact.candidate && other.antagonist == contact.antagonist &&
          same_direction<D>(other.at.normal, contact.at.normal))
        contact.manifold = other.manifold;
    }
    if (contact.manifold >= 0) continue;
    contact.manifold = manifolds++;
    ++bodies[contact.candidate].impacts;
    if (contact.antagonist >= 0) ++bodies[contact.antagonist].impacts;
    if (contact.surface) contact.surface->begin_impact(bodies[contact.candidate].impacts);
  }
}

template <int D>
void World<D>::ask_laws() {
  for (Contact& contact : contacts_) {
    contact.law = {};
    Surface* surface = contact.surface;
    if (!surface) continue;
    ++surface->use.contacts;
    const bool impact = contact.manifold >= 0;
    const ContactState state = impact || surface->reads_state() ? state_of(contact) : ContactState{};
    if (impact) {
      const Restitution restitution = surface->ask_restitution(state);
      contact.law.e_n = restitution.e_n;
      contact.law.e_t = restitution.e_t;
    }
    const Friction friction = surface->ask_friction(state);
    contact.law.mu_s = friction.mu_s;
    contact.law.mu_d = friction.mu_d;
    contact.law.mu_r = surface->ask_rolling(state);
    contact.law.condition = surface->ask_condition(state);
  }
}

/// W = sum over bodies of H^T M^-1 H, and q = u_free + restitution; `warm` starts from the last impulses.
template <int D>
void World<D>::assemble(double h, bool warm) {
  problem_.clear();
  rows_.clear();
  impulses_.clear();
  for (auto& list : contacts_of_) list.clear();
  for (int a = 0; a < static_cast<int>(contacts_.size()); ++a) {
    Contact& contact = contacts_[a];
    ContactRows rows;
    rows.antagonist.setZero();
    const auto columns = [&](int body) { return contact_columns(contact.at.normal, contact.at.point - bodies[body].x); };
    rows.candidate = columns(contact.candidate);
    if (contact.antagonist >= 0) rows.antagonist = -columns(contact.antagonist);
    rows_.push_back(rows);
    if (bodies[contact.candidate].moves()) contacts_of_[contact.candidate].push_back(a);
    if (contact.antagonist >= 0 && bodies[contact.antagonist].moves()) contacts_of_[contact.antagonist].push_back(a);

    typename Problem::Contact row;
    row.q = relative_velocity(contact);
    // Signorini with Newton's law: 0 <= u_n + e_n min(0, v_n^-) _|_ r_n >= 0; friction on u_t + e_t v_t^-.
    row.q[0] += contact.law.e_n * std::min(0.0, contact.before[0]);
    row.q[1] += contact.law.e_t * contact.before[1];
    row.mu = contact.sticking ? contact.law.mu_s : contact.law.mu_d;
    row.mu_r = contact.law.mu_r;
    row.w.setZero();
    problem_.contacts.push_back(row);
    impulses_.push_back(warm && contact.carried ? contact.impulse : Row::Zero());
  }

  const auto of = [&](int a, int body) -> const auto& {
    return contacts_[a].candidate == body ? rows_[a].candidate : rows_[a].antagonist;
  };
  for (int a = 0; a < static_cast<int>(contacts_.size()); ++a) {
    problem_.first.push_back(problem_.couplings());
    for (const int body : {contacts_[a].candidate, contacts_[a].antagonist}) {
      if (body < 0 || !bodies[body].moves()) continue;
      Eigen::Matrix<double, Space<D>::dof, Problem::rows> mobility;  // M^-1 H of contact a
      for (int k = 0; k < Problem::rows; ++k) mobility.col(k) = bodies[body].inverse_mass_times(of(a, body).col(k));
      for (const int b : contacts_of_[body]) {
        const typename Problem::Block w = mobility.transpose() * of(b, body);
        if (b == a)
          problem_.contacts[a].w += w;
        else
          problem_.couple(b, w);
      }
    }
  }
  problem_.first.push_back(problem_.couplings());
  // A body without rotational inertia to speak of cannot roll.
  for (auto& contact : problem_.contacts)
    if (contact.w(2, 2) <= 0) contact.mu_r = 0;
  scale_by_island(h);
}

/// The tolerance of a contact is relative to g h, or to the fastest approach in its island of touching bodies.
template <int D>
void World<D>::scale_by_island(double h) {
  island_.resize(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) island_[i] = static_cast<int>(i);
  const auto root = [&](int i) {
    while (island_[i] != i) i = island_[i] = island_[island_[i]];
    return i;
  };
  const auto mover = [&](const Contact& c) { return bodies[c.candidate].moves() ? c.candidate : c.antagonist; };
  for (const Contact& c : contacts_)
    if (c.antagonist >= 0 && bodies[c.candidate].moves() && bodies[c.antagonist].moves())
      island_[root(c.candidate)] = root(c.antagonist);
  island_speed_.assign(bodies.size(), gravity_.norm() * (h > 0 ? h : settings_.time_step));
  for (const Contact& c : contacts_) {
    double& speed = island_speed_[root(mover(c))];
    speed = std::max(speed, c.approach());
  }
  for (std::size_t a = 0; a < contacts_.size(); ++a)
    problem_.contacts[a].speed_scale = island_speed_[root(mover(contacts_[a]))];
}

template <int D>
void World<D>::solve_and_apply() {
  const PhaseTimer timer(clock, &PhaseTimes::solve);
  const SolveResult result =
      nlgs_.solve(problem_, {settings_.tolerance, settings_.max_iterations}, impulses_);
  quality_.iterations += result.iterations;
  if (!result.converged) {
    ++quality_.not_converged;
    const double scale = problem_.contacts[result.worst_contact].speed_scale;
    if (scale > 0)
      quality_.not_converged_residual = std::max(quality_.not_converged_residual, result.residual / scale);
  }
  quality_.max_residual = std::max(quality_.max_residual, result.residual);
  for (std::size_t a = 0; a < contacts_.size(); ++a) {
    Contact& contact = contacts_[a];
    contact.impulse = impulses_[a];
    const auto apply = [&](int i, const auto& rows) {
      if (i >= 0) bodies[i].add_velocity(bodies[i].inverse_mass_times(rows * contact.impulse));
    };
    apply(contact.candidate, rows_[a].candidate);
    apply(contact.antagonist, rows_[a].antagonist);
  }
}

/// One Impact a manifold; the energy change of them all is audited.
template <int D>
void World<D>::record_impacts() {
  impacts_.clear();
  double change = 0, rounding = 0;
  for (int a = 0; a < static_cast<int>(contacts_.size()); ++a) {
    const Contact& contact = contacts_[a];
    const Row after = velocity_after(a);
    const double energy = 0.5 * contact.impulse.dot(contact.before + after);
    change += energy;
    rounding += contact.impulse.template head<D>().norm() *
                (1e-12 * (contact.before.norm() + after.norm()) +
                 10 * settings_.tolerance * problem_.contacts[a].speed_scale);
    if (contact.manifold < 0) continue;
    if (contact.manifold >= static_cast<int>(impacts_.size())) {
      Impact impact;
      impact.body = contact.candidate;
      impact.other = contact.antagonist;
      if (contact.antagonist < 0)
        impact.part = part_of(*terrain_, contact.at.against);
      impact.number = bodies[contact.candidate].impacts;
      impact.time = time;
      impacts_.push_back(impact);
    }
    Impact& impact = impacts_[contact.manifold];
    const double pn = contact.impulse[0];
    impact.pn += pn;
    impact.pt += contact.impulse[1];
    impact.energy_change += energy;
    // Means weighted by the normal impulse; a contact that carries none does not count unless it is the only one.
    const double weight = pn + 1e-300;
    impact.place.template head<D>() += weight * contact.at.point;
    impact.vn_before += weight * contact.before[0];
    impact.vn_after += weight * after[0];
    impact.vt_before += weight * contact.before[1];
    impact.vt_after += weight * after[1];
  }
  for (Impact& impact : impacts_) {
    double weight = 0;
    for (const Contact& contact : contacts_)
      if (contact.manifold == &impact - impacts_.data()) weight += contact.impulse[0] + 1e-300;
    impact.place /= weight;
    impact.vn_before /= weight;
    impact.vn_after /= weight;
    impact.vt_before /= weight;
    impact.vt_after /= weight;
  }
  if (!impacts_.empty() && change > rounding) {
    ++quality_.energy_gains;
    quality_.energy_gained += change;
  }
}

/// Whether contact a counts as closed after an impact or step. Restitution throws it off at any speed. Otherwise it opens
/// where it is faster than g h / 2: slower, it would close again within a step, and a block that rocks to rest would do
/// so without end.
template <int D>
bool World<D>::stays_closed(int a) const {
  const Contact& contact = contacts_[a];
  const double speed = velocity_after(a)[0];
  if (contact.manifold >= 0 && contact.law.e_n > 0) return speed <= 0;
  const double within_tolerance = 10 * settings_.tolerance * problem_.contacts[a].speed_scale + 1e-14 * contact.before.norm();
  return speed <= std::max(within_tolerance, 0.5 * gravity_.norm() * settings_.time_step);
}

template typename World<2>::Row World<2>::relative_velocity(const Contact&) const;
template void World<2>::measure_before();
template ContactState World<2>::state_of(const Contact&) const;
template void World<2>::begin_manifolds();
template void World<2>::ask_laws();
template void World<2>::assemble(double, bool);
template void World<2>::scale_by_island(double);
template void World<2>::solve_and_apply();
template void World<2>::record_impacts();
template typename World<2>::Row World<2>::velocity_after(int) const;
template bool World<2>::stays_closed(int) const;

}  // namespace flyrock
