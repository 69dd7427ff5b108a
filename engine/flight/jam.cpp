#include "flight/jam.h"

#include <algorithm>
#include <cmath>

#include "world/driven.h"

namespace flyrock {

template <int D>
void ProgressWatch::begin(const World<D>& world) {
  marked_time_ = time_ = world.time;
  problems_ = world.quality().problems;
  of_solver_ = world.solver_work();
  searches_ = world.quality().toc_iterations;
}

/// The work of a world since it was last looked at.
template <int D>
double ProgressWatch::work_since(const World<D>& world) {
  const SolverQuality& quality = world.quality();
  const std::uint64_t of_solver = world.solver_work() - of_solver_;
  const std::uint64_t of_searches = (quality.toc_iterations - searches_) * of_search;
  const std::uint64_t of_rest =
      (quality.problems - problems_ + 1) * (world.bodies.size() + world.contacts().size()) * of_solve;
  problems_ = quality.problems;
  of_solver_ = world.solver_work();
  searches_ = quality.toc_iterations;
  return static_cast<double>((D == 3 ? in_3d : 1) * (of_solver + of_searches + of_rest));
}

template <int D>
bool ProgressWatch::stands_still(const World<D>& world) {
  const double work = work_since(world);
  work_ += work;
  ++steps_;
  const double step_length = world.settings().time_step;
  if (world.time - marked_time_ >= step_length) {
    marked_time_ = world.time;
    steps_ = 0;
    work_ = 0;
  }
  const double share =
      static_cast<double>((D == 3 ? in_3d : 1) * (world.bodies.size() + world.contacts().size())) *
      std::max(1.0, world.settings().max_iterations / 1000.0);
  debt_ += work - share * (repaid_by_step + repaid_by_time * (world.time - time_) / step_length);
  ++steps_in_debt_;
  time_ = world.time;
  if (debt_ <= 0) {
    debt_ = 0;
    steps_in_debt_ = 0;
  }
  return steps_ >= most_steps || std::max(work_, debt_) >= most_work;
}

std::string ProgressWatch::fault() const {
  if (steps_ < most_steps && debt_ >= most_work)
    return "no progress in " + std::to_string(steps_in_debt_) +
           " steps: time crawls, as where bodies of very different mass touch";
  return "no progress in " + std::to_string(steps_) +
         " steps: the contacts of this rock cannot all hold at once";
}

template void ProgressWatch::begin(const World<2>&);
template void ProgressWatch::begin(const World<3>&);
template bool ProgressWatch::stands_still(const World<2>&);
template bool ProgressWatch::stands_still(const World<3>&);

template <int D>
JamWatch<D>::JamWatch(const World<D>& world) : world_(world) {
  any_driven_ = std::any_of(world.bodies.begin(), world.bodies.end(),
                            [](const Body<D>& body) { return body.kind == BodyKind::driven; });
}

/// The bodies that touch a driven one, over other free bodies too, and how fast driven bodies approach.
template <int D>
void JamWatch<D>::find_reached() {
  const std::vector<Body<D>>& bodies = world_.bodies;
  reached_.assign(bodies.size(), false);
  fastest_ = work_ = work_in_all_ = 0;
  for (const auto& contact : world_.contacts()) {
    double approach = 0, speed = 0;
    const auto add = [&](int i, double side) {
      if (i < 0 || bodies[i].kind != BodyKind::driven) return;
      const Vec<D> velocity = bodies[i].velocity_at(contact.at.point);
      approach -= side * contact.at.normal.dot(velocity);
      speed = std::max(speed, velocity.norm());
    };
    add(contact.candidate, 1);
    add(contact.antagonist, -1);
    approach = driven_approach_beyond_rounding(approach, speed);
    work_ += contact.impulse[0] * approach;
    work_in_all_ += std::abs(contact.impulse[0] * approach);
    if (approach <= 0) continue;
    fastest_ = std::max(fastest_, approach);
    for (const int i : {contact.candidate, contact.antagonist})
      if (i >= 0 && bodies[i].moves()) reached_[i] = true;
  }
  for (bool more = fastest_ > 0; more;) {
    more = false;
    for (const auto& contact : world_.contacts()) {
      const int a = contact.candidate, b = contact.antagonist;
      if (b < 0 || !bodies[a].moves() || !bodies[b].moves() || reached_[a] == reached_[b]) continue;
      reached_[a] = reached_[b] = true;
      more = true;
    }
  }
}

/// The deepest penetration of the bodies that a driven one reaches, as a share of the size. Springs penetrate
/// by design.
template <int D>
double JamWatch<D>::deepest_share() const {
  double deepest = 0;
  for (const auto& contact : world_.contacts()) {
    if (contact.law.condition == NormalCondition::penalty) continue;
    for (const int i : {contact.candidate, contact.antagonist})
      if (is_reached(i) && !changes_shape(world_.bodies[i]))
        deepest = std::max(deepest, -world_.gap_now(contact) / world_.bodies[i].size);
  }
  return deepest;
}

template <int D>
const std::vector<int>& JamWatch<D>::look() {
  jammed_.clear();
  if (!any_driven_ || world_.quality().problems == problems_) return jammed_;
  problems_ = world_.quality().problems;
  find_reached();
  if (fastest_ == 0) return jammed_;
  const bool is_missed = world_.missed_last_solve() &&
                         world_.last_solve().residual > missed_share * fastest_ &&
                         work_ > missed_share * work_in_all_;
  met_ = is_missed ? 0 : met_ + 1;
  missed_ = is_missed ? missed_ + 1 : met_ < most_steps ? missed_ : 0;
  const double deepest = deepest_share();
  if (deepest != last_deepest_) grown_ = deepest > deep_share && deepest > last_deepest_ ? grown_ + 1 : 0;
  last_deepest_ = deepest;
  if (missed_ < most_steps && grown_ < most_steps) return jammed_;
  for (std::size_t i = 0; i < reached_.size(); ++i)
    if (reached_[i]) jammed_.push_back(static_cast<int>(i));
  return jammed_;
}

template class JamWatch<2>;
template class JamWatch<3>;

}  // namespace flyrock
