#include "results/measured/measure_tally.h"

#include "scenario/trial_design.h"

namespace flyrock {

MeasureTally::MeasureTally(const Scenario& scenario)
    : rocks_(group_names(scenario), trials_of_unit(scenario)),
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

void MeasureTally::put(PointResult& result, std::uint64_t trials) {
  result.trials = trials;
  result.groups = rocks_.summaries();
  result.crossings = crossings_.summaries();
  if (trees_) result.trees = trees_->summary();
  if (!blocks_.empty()) result.blocks = blocks_.summary();
  result.clearances = clearances_.summaries();
  result.exposures = exposures_.summaries(trials);
}

}  // namespace flyrock
