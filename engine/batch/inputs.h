#pragma once
// The numbers that vary from rock to rock: one list for the records, the database and the report.

#include <string>
#include <vector>

#include "scenario/derived_inputs.h"
#include "scenario/scenario.h"
#include "trial/outcomes.h"

namespace flyrock {

struct Input {
  std::string path;  ///< in the scenario, with the names of groups: "rocks.blocks.density"; "rock.volume"
  std::string unit;  ///< SI
};

/// The draws of a scenario in their order, then the outcomes of what plugins draw, then the derived numbers
/// of the blast (blast/derived.h), which are made of draws.
inline std::vector<Input> inputs_of(const Scenario& scenario) {
  std::vector<Input> inputs;
  for (const Draw& draw : scenario.draws) inputs.push_back({draw.stream, draw.unit});
  for (const OutcomeInfo& outcome : outcome_infos)
    inputs.push_back({std::string(outcome.name), outcome.unit});
  for (std::size_t d = 0; d < derived_count; ++d)
    inputs.push_back({path_of(static_cast<Derived>(d)), derived_infos()[d].unit});
  return inputs;
}

/// The index of an outcome in that list.
inline int index_of(Outcome outcome, const Scenario& scenario) {
  return static_cast<int>(scenario.draws.size()) + static_cast<int>(outcome);
}
inline int index_of(Derived derived, const Scenario& scenario) {
  return static_cast<int>(scenario.draws.size() + outcome_infos.size()) + static_cast<int>(derived);
}

}  // namespace flyrock
