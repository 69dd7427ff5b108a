// The Moreau-Jean scheme.

#include <algorithm>
#include <cmath>

#include "collision/pairs.h"
#include "world/world.h"

namespace flyrock {

namespace {

/// Stops a body that is at rest in all but its last digits. Contacts would let its speed decay further, down
/// to numbers with which arithmetic is slow and inexact, and whose squares are 0.
template <int D>
void stop_if_still(Body<D>& body) {
  constexpr double still = 1e-30;  // m/s
  if (body.v.squaredNorm() >= still * still || body.spin_speed() * body.size >= still) return;
  body.v.setZero();
  body.w = Space<D>::no_spin();
}

}  // namespace

template <int D>
void World<D>::save() {
  starts_.clear();
  impacts_before_.clear();
  for (const Body<D>& body : bodies) {
    starts_.push_back(moment_of(body));
    impacts_before_.push_back(body.impacts);
  }
  after_.swap(last_after_);
  memory_.clear();
  for (const PairLaws* laws : laws_) laws->save_history(memory_);
}

template <int D>
void World<D>::restore() {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Moment<D>& start = starts_[i];
    bodies[i].move_to(start.x, start.attitude);
    bodies[i].set_shape(start.shape);
    bodies[i].v = start.v;
    bodies[i].w = start.w;
    bodies[i].impacts = impacts_before_[i];
  }
  const double* memory = memory_.data();
  for (PairLaws* laws : laws_) memory = laws->restore_history(memory);
}

/// Velocities jump, or bodies fly: the next step is not like the last one.
template <int D>
void World<D>::forget_steps() {
  control_.forget();
  by_contacts_.clear();
  gains_.clear();
}

/// The Moreau-Jean step:
///   q_m = q + h (1 - theta) v          positions where contacts are detected
///   v_free = v + h (g + a_air),  w_free from free_spin
///   v+ = v_free + M^-1 H r             r from the friction problem
///   q+ = q_m + h theta v+
template <int D>
typename World<D>::Outcome World<D>::step(double h, bool cut, bool pass_held) {
  if (dense_) return dense_step(h);
  constexpr int most_cuts = 4, most_refinements = 4, most_refusals = 12, most_pushes = 3, most_turns = 12;
  constexpr std::size_t most_late = 16;
  const double theta = settings_.theta;
  by_contacts_.resize(bodies.size(), Space<D>::no_spin());
  foreseen_.resize(bodies.size());
  free_.resize(bodies.size());
  const auto drift = [&](double dt) {
    for (Body<D>& body : bodies)
      if (body.present && body.kind != BodyKind::fixed) {
        body.displace(dt * body.velocity());
        if (changes_shape(body)) move_shape(body, dt);
      }
  };
  impacts_.clear();
  save();
  late_.clear();
  const bool chooses = chooses_steps() && cut;
  if (chooses) reach_time_ = std::max(h, last_step_);
  bool new_touch = false;
  double error = 0;
  Drift drifted;
  for (int cuts = 0, refinements = 0, refusals = 0;;) {
    drift((1 - theta) * h);
    detect((1 - theta) * h);
    drifted = {};
    if (cut)
      drifted = keep_closed_at_start(h);
    else
      keep_closed(0);
    // The drift of an edge that turns fast about a corner while it slides grows with h^2: repeat with a
    // shorter step.
    if (drifted.share > 1 && refinements++ < most_refinements) {
      restore();
      h *= std::max(0.1, 1 / std::sqrt(drifted.share));
      new_touch = false;
      continue;
    }
    measure_before(h);
    if (!links.empty()) links.begin_step(bodies, starts_, h, theta);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      Body<D>& body = bodies[i];
      body.v += h * body.acceleration(gravity_);
      if (!body.moves()) continue;
      foreseen_[i] = foreseen_push(i, h);
      body.w = free_spin(body, h, theta, foreseen_[i]);
      free_[i] = body.velocity();
      if (changes_shape(body)) accelerate_shape(body, h, theta);
    }
    begin_manifolds();
    ask_laws(h);
    solve_step(h, last_step_ > 0 ? h / last_step_ : 1);
    for (int again = 0; again < most_pushes && pushed_otherwise(h); ++again) solve_with_found_pushes(h);
    for (int again = 0; again < most_turns && !links.keeps_step(bodies, starts_); ++again)
      solve_with_found_pushes(h);
    if (deforms_) {  // in the frame of the block in the middle of the step, which turns on
      measure_after(h);
      account_turns(h);
    }
    drift(theta * h);
    if (!deforms_) measure_after(h);
    if (chooses && refusals++ < most_refusals) {
      error = phases_so_far() * control_.error(bodies, starts_, doubt_of_friction(h), h);
      error = std::max({error, walked_ * walked_, sunk_rims()});
      const auto lasts = [](const Contact& c) { return c.lasts; };
      if (!control_.has_last() && std::any_of(contacts_.begin(), contacts_.end(), lasts))
        error = std::max(error, 1.0);  // it is not known yet, and the next step must not be longer
      const double of_springs = longest_of_springs();
      const double fits = error > 1 ? StepControl<D>::shorter(h, error) : h;
      if (std::min(fits, of_springs) < h) {
        restore();
        h = std::min(fits, 0.95 * of_springs);
        new_touch = false;
        ++quality_.refused_steps;
        continue;
      }
    }
    if (!cut) break;
    if (cuts++ == most_cuts) {
      measure_unsolved(h);
      break;
    }
    const std::size_t joined = late_.size();
    const std::optional<double> touch = first_touch(h, pass_held);
    if (late_.size() > joined && joined < most_late) {
      restore();
      --cuts;
      continue;
    }
    if (!touch || *touch >= h * (1 - 1e-9)) break;
    new_touch = true;
    restore();
    h = *touch;
    if (h <= 1e-12 * settings_.time_step) {
      contacts_ = last_;
      after_.swap(last_after_);
      return {0, true, true};
    }
  }
  quality_.max_spring_angle =
      std::max(quality_.max_spring_angle, h * std::max(spring_rate_, fastest_breath()));
  quality_.max_penetration = std::max(quality_.max_penetration, drifted.penetration);
  if (chooses) control_.finished(bodies, starts_, h, error, longest_of_springs());
  find_shocks(h);
  record_impacts();
  audit_energy(h);
  if (deforms_) account_deformations(h);
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (bodies[i].moves()) energy_given_ += bodies[i].mass * bodies[i].push.dot(bodies[i].x - starts_[i].x);
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (bodies[i].moves()) by_contacts_[i] = push_of_contacts(i) / h;
  project_drift(cut);
  if (!links.empty()) links.end_step(bodies);
  time += h;
  last_step_ = h;
  finish_bodies();
  gains_.clear();
  for (std::size_t i = 0; impacts_.empty() && i < bodies.size(); ++i) {  // a jump does not go on as a rate
    typename Body<D>::Rows before;
    before << starts_[i].v, starts_[i].w;
    gains_.push_back((bodies[i].velocity() - before) / h);
  }
  quality_.count_step(h, new_touch);
  const Outcome outcome = keep(h, new_touch);
  if (!new_touch) choose_density();
  return outcome;
}

/// At the end of a step.
template <int D>
void World<D>::finish_bodies() {
  for (Body<D>& body : bodies) {
    if (!body.present || body.kind == BodyKind::fixed) continue;
    body.attitude.settle();
    if (body.moves()) stop_if_still(body);
  }
}

template <int D>
void World<D>::find_motions(double h) {
  motions_.clear();
  for (std::size_t i = 0; i < bodies.size(); ++i)
    motions_.push_back(step_motion(starts_[i], bodies[i], h, settings_.theta));
}

/// The time of the first touch of features that are not in contact, along the path of the step [s]. With
/// `pass_held`, only touches of bodies that have no contact with each other count.
template <int D>
std::optional<double> World<D>::first_touch(double h, bool pass_held) {
  const PhaseTimer timer(clock, &PhaseTimes::detect);
  std::optional<double> first;
  find_motions(h);
  const auto consider = [&](std::optional<double> t) {
    if (t && (!first || *t < *first)) first = t;
  };
  // While springs yield, other places of the body may lie as deep in the ground. Mostly they are springs,
  // too, and act as soon as a step finds them; rigid places of another part of the ground are found later.
  const auto search_on = [&](int i, int j) {
    return TouchSearch{held_in_step(i, j), 0.5 * touch(i, j) + 2 * sunk_springs(i, j), contact_size(i, j),
                       &quality_.toc_iterations};
  };
  for (int i = 0; i < static_cast<int>(bodies.size()); ++i) {
    const Body<D>& body = bodies[i];
    if (!body.moves()) continue;
    const bool close = is_close(i, -1);
    if (pass_held && close) continue;
    const TouchSearch search = search_on(i, -1);
    near_parts(work_, body.parts, starts_[i].pose(), *terrain_, greatest_travel(motions_[i], body.size, h),
               parts_);
    bool watched = false;
    for (const int k : parts_) {
      if (close && !is_searched(i, k))
        watched = true;
      else
        consider(time_of_contact<D>(work_, {body.contactors[k], motions_[i], k}, *terrain_, first.value_or(h),
                                    search));
    }
    if (watched) consider(first_event(i, -1, first.value_or(h)));
  }
  if (!pass_held) consider(first_return(h));
  if (!bodies_meet()) return first;
  boxes_.clear();
  for (std::size_t i = 0; i < bodies.size(); ++i)
    boxes_.push_back(swept_box<D>(motions_[i], bodies[i].size + greatest_swell(motions_[i], h), h));
  for (const auto& [i, j] : broad_phase_.template pairs<D>(boxes_)) {
    const Body<D>&a = bodies[i], &b = bodies[j];
    if (!may_touch(i, j)) continue;
    const bool close = is_close(i, j);
    if (pass_held && close) continue;
    const TouchSearch search =
        close ? search_on(i, j)
              : TouchSearch{held_in_flight(i, j), 0, contact_size(i, j), &quality_.toc_iterations};
    const double travel = greatest_travel(motions_[i], a.size, h) + greatest_travel(motions_[j], b.size, h);
    near_parts(work_, a.parts, starts_[i].pose(), b.parts, starts_[j].pose(), travel, part_pairs_);
    bool watched = false;
    for (const auto& [k, l] : part_pairs_) {
      if (close && !is_searched(i, k, j, l))
        watched = true;
      else
        consider(time_of_contact<D>(work_, {a.contactors[k], motions_[i], k},
                                    {b.contactors[l], motions_[j], l}, first.value_or(h), search));
    }
    if (watched) consider(first_event(i, j, first.value_or(h)));
  }
  return first;
}

/// Keeps the contacts for the next step, and reports whether any of them stays closed.
template <int D>
typename World<D>::Outcome World<D>::keep(double duration, bool new_touch) {
  Outcome outcome{duration, new_touch, false};
  for (std::size_t a = 0; a < contacts_.size(); ++a) {
    Contact& c = contacts_[a];
    const bool closed = stays_closed(static_cast<int>(a), duration);
    c.carried = closed;
    c.at_bound = is_at_bound(static_cast<int>(a), duration);
    c.sticking = sticks(static_cast<int>(a));
    c.age = closed ? c.age + duration : 0;
    if (duration > 0) c.normal_force = c.impulse[0] / duration;
    if (!closed) c.normal_force = ContactState::none;
    if (c.laws && c.laws->reads().slip_length) {
      // The way of the scheme, of which the velocity before has the share 1 - theta
      const Row mean = (1 - settings_.theta) * c.before + settings_.theta * after_[a];
      c.slip_length = closed ? c.slip_length + tangential(mean).norm() * duration : 0;
    }
    c.stretch = closed ? stretch_after(static_cast<int>(a), duration) : Vec<D>::Zero();
    outcome.in_contact = outcome.in_contact || c.carried;
  }
  last_ = contacts_;
  return outcome;
}

template <int D>
bool World<D>::slips(const Contact& contact, int body) const {
  constexpr double rolling_slip = 0.05;
  return contact.at_bound &&
         tangential(relative_velocity(contact)).norm() > rolling_slip * bodies[body].v.norm();
}

#define FLYROCK_INSTANTIATE(D)                                        \
  template void World<D>::save();                                     \
  template void World<D>::restore();                                  \
  template void World<D>::forget_steps();                             \
  template void World<D>::finish_bodies();                            \
  template World<D>::Outcome World<D>::step(double, bool, bool);      \
  template void World<D>::find_motions(double);                       \
  template std::optional<double> World<D>::first_touch(double, bool); \
  template World<D>::Outcome World<D>::keep(double, bool);            \
  template bool World<D>::slips(const Contact&, int) const
FLYROCK_INSTANTIATE(2);
FLYROCK_INSTANTIATE(3);
#undef FLYROCK_INSTANTIATE

}  // namespace flyrock
