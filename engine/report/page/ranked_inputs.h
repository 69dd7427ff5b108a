#pragma once
// Decides which drawn numbers are ranked: those that the run reads. A number that is not read moves no rock,
// so any correlation of it with the runout is chance.

#include <cstdint>
#include <map>
#include <vector>

#include "record/records.h"
#include "scenario/derived_inputs.h"
#include "scenario/scenario.h"

namespace flyrock {

class RankedInputs {
 public:
  explicit RankedInputs(const Scenario& scenario);

  /// Counts the calls of the laws of each material.
  void add(const TrialTotals& totals);

  /// Whether the scenario makes the rocks of a group depend on a draw (an index of Scenario::draws).
  bool reads(std::size_t group, int draw) const {
    return reads_.at(group).at(static_cast<std::size_t>(draw));
  }
  /// Whether they depend on any number that a derived number of the blast is made of.
  bool reads(std::size_t group, Derived derived) const {
    return derived_.at(group).at(static_cast<std::size_t>(derived));
  }
  /// Whether the law of a draw was ever called; true for a draw that belongs to no law.
  bool was_asked(int draw) const;

 private:
  using LawCount = std::uint64_t MaterialUse::*;
  struct LawOf {
    std::size_t material = 0;
    LawCount law = nullptr;
  };
  void find_laws(const Scenario& scenario);

  std::vector<std::vector<bool>> reads_, derived_;  ///< for each group
  std::map<int, LawOf> law_of_draw_;
  std::vector<MaterialUse> use_;  ///< for each material
};

}  // namespace flyrock
