#include "trial/blast_at.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "trial/scenario_error.h"

namespace flyrock {

namespace {

/// Texts about a blast begin with their key: "blast.hole: it ends above the floor".
ScenarioError error_at_key(const std::string& text) {
  const std::size_t colon = text.find(": ");
  if (colon == text.npos) return {"blast", text};
  return {text.substr(0, colon), text.substr(colon + 2)};
}

/// Completes the blast of a hole with its scatter: added to what is given before the rest follows from it,
/// and to what is not given afterwards.
void complete_scattered(const Scenario& scenario, const DrawKey& key, Blast& blast) {
  std::vector<std::pair<BlastField, double>> later;
  for (const auto& [field, number] : scenario.blast->scatter) {
    const double added = number.value(scenario.draws, scenario.streams, key);
    if (std::isnan(blast[field]))
      later.emplace_back(field, added);
    else
      blast[field] += added;
  }
  complete(blast);
  for (const auto& [field, added] : later) blast[field] += added;
  if (scenario.blast->forced.empty()) return;
  for (const auto& [field, number] : scenario.blast->forced)
    force(field, number.value(scenario.draws, scenario.streams, key), blast);
  complete(blast);
}

}  // namespace

double time_of_hole(const Scenario& scenario, const DrawKey& key) {
  const double time = scenario.blast->pattern.time(hole_of(key));
  const auto& scatter = scenario.blast->time_scatter;
  return scatter ? std::max(0.0, time + scatter->value(scenario.draws, scenario.streams, key)) : time;
}

Blast blast_at(const Scenario& scenario, const DrawKey& key) {
  Blast blast;
  if (!scenario.blast) return blast;
  for (const auto& [field, value] : scenario.blast->fields)
    blast[field] = value.value(scenario.draws, scenario.streams, key);
  blast.is_anfo = scenario.blast->is_anfo;
  const bool measured = scenario.blast->has_holes();
  if (measured) put_own(scenario.blast->pattern.measured[static_cast<std::size_t>(hole_of(key))], blast);
  try {
    if (measured)
      complete_scattered(scenario, key, blast);
    else
      complete(blast);
  } catch (const std::invalid_argument& fault) {
    throw error_at_key(fault.what());
  }
  return blast;
}

}  // namespace flyrock
