#pragma once
// Compares the results with the expectations of the scenario.

#include <string>
#include <vector>

#include "results/measured/measures.h"

namespace flyrock {

struct Plan;

enum class Judgement { passed, failed, not_judged };

/// One expectation at one point.
struct Verdict {
  Expectation expectation;
  int point = -1;         ///< -1: of several points (an order), or of none, because `at` names none
  double computed = 0;    ///< NaN if there is no value
  bool censored = false;  ///< computed is a lower bound
  double tolerance = 0;   ///< absolute; only for `equals`
  Judgement judgement = Judgement::failed;
  std::string reason;  ///< why it failed without a comparison, or why it was not judged
};

/// What an expectation compares: its measure, or "order of MEASURE in PATH".
std::string compared_text(const Expectation& expectation);

/// Every expectation of a plan at every sweep point that it names, in file order. `full` is false if fewer
/// trials ran than the scenario asks for; then expectations about rocks are not judged.
/// An order is the slope of the line of least squares through (log x, log |measure - exact|), with the swept
/// number x, over the points that the expectation names; it takes one verdict.
std::vector<Verdict> judge(const Plan& plan, const std::vector<PointResult>& points, bool full);

}  // namespace flyrock
