#include "results/measured/measure_tally.h"

#include "results/measured/lost.h"
#include "scenario/trial_design.h"

namespace flyrock {

MeasureTally::MeasureTally(const Scenario& scenario)
    : scenario_(scenario),
      rocks_(group_names(scenario), trials_of_unit(scenario)),
      crossings_(scenario),
      clearances_(scenario.clearances),
      exposures_(scenario) {
  if (scenario.forest) trees_.emplace();
}

void MeasureTally::add(const TrialRecords& chunk) {
  rocks_.add(chunk);
  crossings_.add(chunk);
  if (trees_ && first_pass_) trees_->add(chunk);
  if (first_pass_) blocks_.add(chunk);
  clearances_.add(chunk);
  exposures_.add(chunk);
}

bool MeasureTally::needs_another_pass() {
  first_pass_ = false;
  bool more = rocks_.needs_another_pass();
  more |= crossings_.needs_another_pass();
  seeks_distances_ = clearances_.needs_another_pass();
  more |= seeks_distances_;
  more |= exposures_.needs_another_pass();
  return more;
}

std::optional<std::vector<double>> MeasureTally::clearance_distances() const {
  if (seeks_distances_) return std::nullopt;
  std::vector<double> distances;
  for (const ClearanceSummary& clearance : clearances_.summaries())
    distances.push_back(clearance.area.sectors.empty() ? clearance.distance.value : unknown);
  return distances;
}

Told MeasureTally::told() const { return has_lost(scenario_, rocks_.counts()) ? Told::counts : Told::all; }

void MeasureTally::put(PointResult& result, std::uint64_t trials) {
  const Told told = this->told();
  result.trials = trials;
  result.groups = rocks_.summaries(told);
  result.crossings = crossings_.summaries(told);
  if (trees_) result.trees = trees_->summary(told);
  if (!blocks_.empty()) result.blocks = blocks_.summary();
  result.clearances = clearances_.summaries(told);
  result.exposures = exposures_.summaries(trials, told);
}

}  // namespace flyrock
