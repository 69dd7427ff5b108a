#include "trial/branch_of.h"

#include "random/stream.h"

namespace flyrock {

namespace {

/// The branch of one unit that the uniform number u falls to; the probabilities are divided by `whole`.
int branch_at(const Scenario& scenario, bool per_blast, double u, double whole) {
  double sum = 0;
  for (std::size_t b = 0; b < scenario.branches.size(); ++b) {
    const BranchPlan& branch = scenario.branches[b];
    if (branch.per_blast != per_blast) continue;
    sum += branch.probability / whole;
    if (u < sum) return static_cast<int>(b) + 1;
  }
  return 0;
}

}  // namespace

int branch_of_blast(const Scenario& scenario, std::uint64_t trial) {
  if (scenario.branches.empty()) return 0;
  DrawKey key;
  key.trial = trial;
  return branch_at(scenario, true, RandomStream(scenario.streams, "branches", key).uniform(), 1);
}

int branch_of_hole(const Scenario& scenario, std::uint64_t trial, std::uint64_t hole) {
  if (scenario.branches.empty()) return 0;
  if (const int of_blast = branch_of_blast(scenario, trial); of_blast > 0) return of_blast;
  double regular = 1;
  for (const BranchPlan& branch : scenario.branches)
    if (branch.per_blast) regular -= branch.probability;
  DrawKey key;
  key.trial = trial;
  key.hole = hole + 1;
  return branch_at(scenario, false, RandomStream(scenario.streams, "branches", key).uniform(), regular);
}

}  // namespace flyrock
