#include "results/risk/risk.h"

#include <algorithm>
#include <iterator>

#include "trial/branch_of.h"

namespace flyrock {

namespace {

/// The rock of a row; rows are sorted as the rocks are, so the search goes on from the last rock.
const RockRecord& rock_of_row(std::vector<RockRecord>::const_iterator& rock, std::uint64_t trial,
                              int number) {
  while (rock->trial != trial || rock->rock != number) ++rock;
  return *rock;
}

}  // namespace

RiskTally::RiskTally(const Scenario& scenario) : scenario_(scenario) {
  const bool has_holes = scenario.blast && scenario.blast->has_holes();
  if (!has_holes && scenario.branches.empty()) {
    stage_ = Stage::done;
    return;
  }
  if (scenario.blast) holes_ = static_cast<std::uint64_t>(scenario.blast->pattern.holes());
  const std::size_t branches = scenario.branches.size() + 1;
  units_.assign(branches, 0);
  of_branch_.assign(branches, Sample(Questions{{0.5, 0.95, 0.99, 1}, {}}));
  const auto counted = [&](const std::string& of) {
    return Counted{{.of = of,
                    .of_hole = std::vector<std::uint64_t>(holes_, 0),
                    .of_branch = std::vector<std::uint64_t>(branches, 0),
                    .units_of_branch = std::vector<std::uint64_t>(branches, 0)},
                   std::vector<std::uint64_t>(holes_, 0)};
  };
  for (const ClearancePlan& plan : scenario.clearances)
    clearances_.push_back(counted("clearance " + plan.name));
  for (const BarrierPlan& plan : scenario.barriers) barriers_.push_back(counted("barrier " + plan.name));
  for (const GatePlan& plan : scenario.gates) gates_.push_back(counted("gate " + plan.name));
  farthest_ = counted("farthest 1 %");
}

/// Regular holes are counted where a branch may happen to one of them, else regular blasts.
bool RiskTally::is_of_blasts(int branch) const {
  if (branch > 0) return scenario_.branches[static_cast<std::size_t>(branch) - 1].per_blast;
  return std::all_of(scenario_.branches.begin(), scenario_.branches.end(),
                     [](const BranchPlan& plan) { return plan.per_blast; });
}

void RiskTally::count(Counted& counted, const RockRecord& rock) const {
  const auto hole = static_cast<std::size_t>(rock.hole), branch = static_cast<std::size_t>(rock.branch);
  ++counted.risk.rocks;
  ++counted.risk.of_hole.at(hole);
  ++counted.risk.of_branch.at(branch);
  std::uint64_t& last = counted.last_trial.at(is_of_blasts(rock.branch) ? 0 : hole);
  if (last == rock.trial + 1) return;
  last = rock.trial + 1;
  ++counted.risk.units_of_branch.at(branch);
}

void RiskTally::add(const TrialRecords& chunk) {
  if (stage_ == Stage::done) return;
  if (first_pass_) {
    count_branches(chunk);
    count_lines(chunk);
  }
  if (stage_ == Stage::count) return count_distances(chunk);
  for (const RockRecord& rock : chunk.rocks) {
    if (is_fault(rock.reason)) continue;
    runouts_.add({rock.runout, rock.censored}, rock.trial);
    of_branch_.at(static_cast<std::size_t>(rock.branch)).add({rock.runout, rock.censored}, rock.trial);
  }
}

/// The units of the trials, whether or not they have rocks.
void RiskTally::count_branches(const TrialRecords& chunk) {
  if (scenario_.branches.empty()) return;
  for (const RockRecord& rock : chunk.rocks) {
    if (rock.trial < next_trial_) continue;
    next_trial_ = rock.trial + 1;
    ++trials_;
    const int of_blast = branch_of_blast(scenario_, rock.trial);
    if (of_blast > 0 || is_of_blasts(0)) {
      ++units_.at(static_cast<std::size_t>(of_blast));
      continue;
    }
    for (std::uint64_t hole = 0; hole < holes_; ++hole)
      ++units_.at(static_cast<std::size_t>(branch_of_hole(scenario_, rock.trial, hole)));
  }
}

void RiskTally::count_lines(const TrialRecords& chunk) {
  auto rock = chunk.rocks.begin();
  for (const GateRecord& row : chunk.gates)
    count(gates_.at(static_cast<std::size_t>(row.passage.gate)), rock_of_row(rock, row.trial, row.rock));
  rock = chunk.rocks.begin();
  for (const BarrierRecord& row : chunk.barriers)
    if (row.hit.outcome != BarrierOutcome::caught)
      count(barriers_.at(static_cast<std::size_t>(row.hit.barrier)), rock_of_row(rock, row.trial, row.rock));
}

void RiskTally::count_distances(const TrialRecords& chunk) {
  for (const RockRecord& rock : chunk.rocks) {
    if (is_fault(rock.reason)) continue;
    if (rock.runout >= farthest_.risk.distance) count(farthest_, rock);
    for (std::size_t c = 0; c < clearances_.size(); ++c) {
      const ClearancePlan& plan = scenario_.clearances[c];
      const double distance = plan.of_max_distance ? rock.max_distance : rock.runout;
      if (plan.counts(rock.group) && distance > clearances_[c].risk.distance) count(clearances_[c], rock);
    }
  }
}

bool RiskTally::needs_another_pass(const std::optional<std::vector<double>>& clearances) {
  first_pass_ = false;
  if (stage_ == Stage::count) stage_ = Stage::done;
  if (stage_ == Stage::done) return false;
  bool searching = runouts_.needs_another_pass();
  for (Sample& sample : of_branch_) searching |= sample.needs_another_pass();
  if (searching || !clearances) return true;
  if (runouts_.size() > 0) farthest_.risk.distance = runouts_.quantile(0.99).value;
  for (std::size_t c = 0; c < clearances_.size(); ++c) clearances_[c].risk.distance = clearances->at(c);
  stage_ = Stage::count;
  return true;
}

RiskSummary RiskTally::summary() const {
  RiskSummary summary;
  for (const auto* risks : {&clearances_, &barriers_, &gates_})
    for (const Counted& counted : *risks)
      if (counted.risk.rocks > 0) summary.risks.push_back(counted.risk);
  if (summary.risks.empty() && farthest_.risk.rocks > 0) summary.risks.push_back(farthest_.risk);
  if (scenario_.branches.empty()) return summary;
  const auto share_of_holes = [&](std::size_t b) {
    const std::vector<int>& own = scenario_.branches[b].holes;
    return own.empty() ? 1 : static_cast<double>(own.size()) / static_cast<double>(holes_);
  };
  double regular = 1;
  for (std::size_t b = 0; b < scenario_.branches.size(); ++b)
    regular -= scenario_.branches[b].probability * share_of_holes(b);
  for (std::size_t b = 0; b < of_branch_.size(); ++b) {
    BranchSummary& branch = summary.branches.emplace_back();
    branch.per_blast = is_of_blasts(static_cast<int>(b));
    branch.probability = b == 0 ? regular : scenario_.branches[b - 1].probability;
    branch.units = units_[b];
    const std::uint64_t holes =
        b == 0 || scenario_.branches[b - 1].holes.empty() ? holes_ : scenario_.branches[b - 1].holes.size();
    const std::uint64_t all = branch.per_blast ? trials_ : trials_ * holes;
    branch.share.value = static_cast<double>(branch.units) / static_cast<double>(all);
    branch.share.interval =
        share_interval(static_cast<double>(branch.units), static_cast<double>(all), stated_confidence);
    const Sample& runout = of_branch_[b];
    branch.rocks = runout.size();
    const auto quantile = [&](double p) {
      return runout.size() > 0 ? runout.quantile(p) : Bounded{unknown, false};
    };
    branch.p50 = quantile(0.5);
    branch.p95 = quantile(0.95);
    branch.p99 = quantile(0.99);
    branch.max = quantile(1);
  }
  return summary;
}

}  // namespace flyrock
