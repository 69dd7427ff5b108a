#pragma once
// What the gates and barriers of one point saw.

#include <array>
#include <cstdint>
#include <vector>

#include "batch/statistics.h"

namespace flyrock {

/// Rocks without faults of one point. A censored rock that has not arrived might have done so later: the numbers of a
/// place for which there is one are lower bounds.
struct GateSummary {
  std::uint64_t passed = 0;  ///< rocks
  Bounded share;             ///< of all rocks; NaN where there are none
  Statistics speed{}, energy{}, height{};  ///< of the rocks that passed, at the gate
};

struct BarrierSummary {
  std::array<std::uint64_t, 3> outcomes{};  ///< rocks, indexed by BarrierOutcome
  Bounded reached;                          ///< share of all rocks that arrived
  std::array<Bounded, 3> shares{};          ///< of all rocks, indexed by BarrierOutcome
  Statistics energy{}, height{};            ///< of the rocks that arrived, before the barrier acts
};

/// In the order of Scenario::gates and Scenario::barriers.
std::vector<GateSummary> summarise_gates(const TrialRecords& records, std::size_t gates);
std::vector<BarrierSummary> summarise_barriers(const TrialRecords& records, std::size_t barriers);

}  // namespace flyrock
