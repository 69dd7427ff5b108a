#pragma once
// Where the rocks come from that go too far: beyond a clearance, past a barrier or a gate, or else the
// farthest 1 %. By measured hole, and by branch.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "record/records.h"
#include "results/statistics/share.h"
#include "results/statistics/unknown.h"
#include "scenario/scenario.h"

namespace flyrock {

struct Risk {
  std::string of;                      ///< "clearance people", "barrier fence", "gate road", "farthest 1 %"
  double distance = unknown;           ///< m, that the rocks exceed; NaN for barriers and gates
  std::uint64_t rocks = 0;             ///< that do it
  std::vector<std::uint64_t> of_hole;  ///< of these, in the order of Pattern::measured
  std::vector<std::uint64_t> of_branch, units_of_branch;  ///< rocks, and holes or blasts with such a rock
};

/// How often a branch happened, and what its rocks did. The first one is the regular blast.
struct BranchSummary {
  bool per_blast = false;      ///< its units are blasts (trials), else holes of them
  double probability = 0;      ///< that a unit takes it
  std::uint64_t units = 0;     ///< that took it
  Share share;                 ///< of all units, with its exact binomial interval
  std::uint64_t rocks = 0;     ///< without those that failed
  Bounded p50, p95, p99, max;  ///< of their runout [m]; NaN without rocks
};

struct RiskSummary {
  std::vector<Risk> risks;  ///< without those that no rock exceeds; where there are none, the farthest 1 %
  std::vector<BranchSummary> branches;  ///< in the order of branch_names(); empty without branches
};

/// Counts rocks by hole and branch, in passes over the rows. Does nothing without measured holes and
/// branches.
class RiskTally {
 public:
  explicit RiskTally(const Scenario& scenario);
  void add(const TrialRecords& chunk);
  /// `clearances`: the distances of the scenario's clearances (NaN: not given), once they are known.
  bool needs_another_pass(const std::optional<std::vector<double>>& clearances);
  RiskSummary summary() const;

 private:
  enum class Stage { search, count, done };
  /// A risk, and the trial in which each hole last had a rock that exceeds it.
  struct Counted {
    Risk risk;
    std::vector<std::uint64_t> last_trial;
  };

  bool is_of_blasts(int branch) const;
  void count_branches(const TrialRecords& chunk);
  void count_lines(const TrialRecords& chunk);
  void count_distances(const TrialRecords& chunk);
  void count(Counted& counted, const RockRecord& rock) const;

  const Scenario& scenario_;
  Stage stage_ = Stage::search;
  bool first_pass_ = true;
  std::uint64_t holes_ = 1;
  Sample runouts_{Questions{{0.99}, {}}};
  std::vector<Sample> of_branch_;  ///< runouts
  std::vector<std::uint64_t> units_;
  std::uint64_t trials_ = 0, next_trial_ = 0;
  std::vector<Counted> clearances_, barriers_, gates_;
  Counted farthest_;
};

}  // namespace flyrock
