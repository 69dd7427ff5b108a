#include "record/observe.h"

#include <algorithm>
#include <cmath>

#include "record/series.h"

namespace flyrock {

const char* name_of(StopReason reason) {
  constexpr const char* names[] = {"stopped",  "left_domain",  "timed_out",  "caught",
                                   "diverged", "plugin_error", "not_started"};
  return names[static_cast<int>(reason)];
}

const char* name_of(BarrierOutcome outcome) {
  constexpr const char* names[] = {"caught", "over_top", "over_energy"};
  return names[static_cast<int>(outcome)];
}

const char* name_of(SeriesState state) {
  constexpr const char* names[] = {"open", "sticking", "sliding", "before_impact", "after_impact"};
  return names[static_cast<int>(state)];
}

void add(Impact& sum, const Impact& later) {
  const double pn = sum.pn + later.pn, share = pn > 0 ? later.pn / pn : 1.0 / (sum.count + 1);
  sum.place += share * (later.place - sum.place);
  for (const auto mean : {&Impact::vn_before, &Impact::vn_after, &Impact::vt_before, &Impact::vt_after})
    sum.*mean += share * (later.*mean - sum.*mean);
  sum.pn = pn;
  sum.pt += later.pt;
  sum.energy_change += later.energy_change;
  sum.count += later.count;
}

void BodyHistory::begin(const BodyState& state) {
  first = last = min = max = state;
  min_speed = max_speed = state.velocity.norm();
}

void BodyHistory::move(const Vec3& by) {
  for (BodyState* state : {&first, &last, &min, &max}) state->position += by;
  for (Impact& impact : impacts) impact.place += by;
  for (TrajectoryPoint& point : trajectory) point.state.position += by;
}

void BodyHistory::include(const BodyState& state) {
  const auto widen = [](auto& low, auto& high, const auto& value) {
    low = low.cwiseMin(value);
    high = high.cwiseMax(value);
  };
  widen(min.position, max.position, state.position);
  widen(min.velocity, max.velocity, state.velocity);
  widen(min.spin, max.spin, state.spin);
  min.angle = std::min(min.angle, state.angle);
  max.angle = std::max(max.angle, state.angle);
  min.kinetic_energy = std::min(min.kinetic_energy, state.kinetic_energy);
  max.kinetic_energy = std::max(max.kinetic_energy, state.kinetic_energy);
  const double speed = state.velocity.norm();
  min_speed = std::min(min_speed, speed);
  max_speed = std::max(max_speed, speed);
}

void SolverQuality::count_step(double h, bool cut) {
  ++steps;
  cut_steps += cut;
  step_time += h;
  greatest_step = std::max(greatest_step, h);
  if (!cut) least_step = std::min(least_step, h);
}

void SolverQuality::add(const SolverQuality& other) {
  for (const auto count : counts) this->*count += other.*count;
  for (const auto value : greatest) this->*value = std::max(this->*value, other.*value);
  step_time += other.step_time;
  greatest_step = std::max(greatest_step, other.greatest_step);
  least_step = std::min(least_step, other.least_step);
  energy_gained += other.energy_gained;
  gained_by_slip += other.gained_by_slip;
  theta_loss += other.theta_loss;
  projection_energy += other.projection_energy;
  if (std::abs(other.energy_relative_change) > std::abs(energy_relative_change))
    energy_relative_change = other.energy_relative_change;
}

}  // namespace flyrock
