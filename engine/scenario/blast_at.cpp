#include "scenario/blast_at.h"

#include <stdexcept>

namespace flyrock {

Blast blast_at(const Scenario& scenario, const DrawKey& key) {
  Blast blast;
  if (!scenario.blast) return blast;
  for (const auto& [field, value] : scenario.blast->fields) blast[field] = value.value(scenario.draws, scenario.seed, key);
  blast.is_anfo = scenario.blast->is_anfo;
  try {
    complete(blast);
  } catch (const std::invalid_argument& fault) {
    throw PluginError(fault.what());
  }
  return blast;
}

}  // namespace flyrock
