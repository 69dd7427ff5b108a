#include "trial/blast_at.h"

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

}  // namespace

Blast blast_at(const Scenario& scenario, const DrawKey& key) {
  Blast blast;
  if (!scenario.blast) return blast;
  for (const auto& [field, value] : scenario.blast->fields)
    blast[field] = value.value(scenario.draws, scenario.seed, key);
  blast.is_anfo = scenario.blast->is_anfo;
  try {
    complete(blast);
  } catch (const std::invalid_argument& fault) {
    throw error_at_key(fault.what());
  }
  return blast;
}

}  // namespace flyrock
