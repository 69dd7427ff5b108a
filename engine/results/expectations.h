#pragma once
// What a scenario expects of its own results, and whether it came.

#include <optional>
#include <string>
#include <vector>

#include "results/measures.h"

namespace flyrock {

enum class Judgement { passed, failed, not_judged };

/// One expectation at one point.
struct Verdict {
  Expectation expectation;
  int point = -1;         ///< -1: its `at` names no point of the sweep
  double computed = 0;    ///< NaN where there is no value
  bool censored = false;  ///< computed is a lower bound
  double tolerance = 0;   ///< absolute; `equals` only
  Judgement judgement = Judgement::failed;
  std::string reason;  ///< why it failed without a comparison, or was not judged
};

/// Every expectation of a plan at every point that it names, in file order. `full` is false where fewer
/// trials ran than the scenario asks for: expectations on rocks are then not judged.
std::vector<Verdict> judge(const Plan& plan, const std::vector<PointResult>& points, bool full);

}  // namespace flyrock
