#pragma once
// The friction problem solved with restitution, its solution applied, and what it left.

#include <algorithm>

#include "world/manifold.h"
#include "world/world.h"

namespace flyrock {

/// Signorini with Newton's law: 0 <= u_n + e_n min(0, v_n^-) _|_ r_n >= 0; friction on u_t + e_t v_t^-.
template <int D>
void World<D>::shift_by_restitution() {
  for (std::size_t a = 0; a < contacts_.size(); ++a) {
    const Contact& contact = contacts_[a];
    Row& q = problem_.contacts[a].q;
    q[0] += contact.law.e_n * std::min(0.0, contact.before[0]);
    q.template segment<D - 1>(1) += contact.law.e_t * tangential(contact.before);
  }
}

template <int D>
void World<D>::solve_and_apply() {
  const PhaseTimer timer(clock, &PhaseTimes::solve);
  shift_by_restitution();
  if (on_hard_problem) start_ = impulses_;
  SolveSettings wanted;
  wanted.tolerance = settings_.tolerance;
  wanted.max_iterations = settings_.max_iterations;
  wanted.solver = settings_.solver;
  const SolveResult result = solver_.solve(problem_, wanted, impulses_);
  quality_.iterations += result.iterations;
  if (!result.converged) {
    ++quality_.not_converged;
    if (on_hard_problem) on_hard_problem(problem_, start_);
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

/// The velocity H v of contact a now, in the frame of detection (the bodies may have moved on).
template <int D>
typename World<D>::Row World<D>::velocity_after(int a) const {
  const Contact& contact = contacts_[a];
  Row u = rows_[a].candidate.transpose() * bodies[contact.candidate].velocity();
  if (contact.antagonist >= 0) u += rows_[a].antagonist.transpose() * bodies[contact.antagonist].velocity();
  return u;
}

/// One Impact a manifold; the energy change of them all is audited.
template <int D>
void World<D>::record_impacts() {
  impacts_.clear();
  sums_.clear();
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
      if (contact.antagonist < 0) impact.part = part_of(*terrain_, contact.at.against);
      impact.number = bodies[contact.candidate].impacts;
      impact.time = time;
      impacts_.push_back(impact);
      sums_.emplace_back();
    }
    Impact& impact = impacts_[contact.manifold];
    ImpactSum& sum = sums_[contact.manifold];
    const double pn = contact.impulse[0];
    impact.pn += pn;
    impact.energy_change += energy;
    // A contact that carries no normal impulse does not count in the means unless it is the only one.
    const double weight = pn + 1e-300;
    sum.weight += weight;
    sum.place += weight * contact.at.point;
    sum.vn_before += weight * contact.before[0];
    sum.vn_after += weight * after[0];
    sum.vt_before += weight * tangential(contact.before);
    sum.vt_after += weight * tangential(after);
    sum.pt += tangential(contact.impulse);
  }
  // Signed in 2D, magnitudes in 3D.
  const auto slip = [](const Vec<D - 1>& t) { return D == 2 ? t[0] : t.norm(); };
  for (std::size_t i = 0; i < impacts_.size(); ++i) {
    Impact& impact = impacts_[i];
    const ImpactSum& sum = sums_[i];
    impact.place.template head<D>() = sum.place / sum.weight;
    impact.vn_before = sum.vn_before / sum.weight;
    impact.vn_after = sum.vn_after / sum.weight;
    impact.vt_before = slip(sum.vt_before) / sum.weight;
    impact.vt_after = slip(sum.vt_after) / sum.weight;
    impact.pt = slip(sum.pt);
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

}  // namespace flyrock
