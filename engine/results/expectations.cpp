#include "results/expectations.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "results/lost.h"
#include "results/unknown.h"
#include "scenario/plan.h"

namespace flyrock {

namespace {

/// Swept values of a range have rounding errors: 0.1 + 2 * 0.1 must match the 0.3 of `at`.
bool same(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b)); }

bool applies(const Expectation& expectation, const Plan& plan, std::size_t point) {
  return std::all_of(expectation.at.begin(), expectation.at.end(), [&](const auto& wanted) {
    for (std::size_t axis = 0; axis < plan.axes.size(); ++axis)
      if (plan.axes[axis].path == wanted.first) return same(plan.at[point][axis], wanted.second);
    return false;
  });
}

bool holds(const Expectation& expectation, double computed, double tolerance) {
  switch (expectation.kind) {
    case ExpectKind::equals:
      return std::abs(computed - expectation.value) <= tolerance;
    case ExpectKind::below:
      return computed < expectation.value;
    case ExpectKind::above:
      return computed > expectation.value;
    case ExpectKind::between:
      return expectation.value <= computed && computed <= expectation.high;
  }
  return false;
}

Verdict judge_at(const Expectation& expectation, const Scenario& scenario, const PointResult& result,
                 int point, bool full) {
  Verdict verdict{expectation, point, unknown, false, expectation.tolerance, Judgement::failed, {}};
  if (expectation.relative) verdict.tolerance = *expectation.relative * std::abs(expectation.value);
  const Measure measure(expectation.measure, scenario);
  Measured measured = measure.value(result);
  const bool is_count = expectation.measure.ends_with(".count");
  if (measure.of_rocks() && !is_count && has_lost(scenario, result)) measured.fault = lost_text(result);
  if (measured.fault.empty()) verdict.computed = measured.value;
  verdict.censored = measured.censored;

  if (measure.of_rocks() && !full) {
    verdict.judgement = Judgement::not_judged;
    verdict.reason = "fewer trials ran than the scenario asks for";
  } else if (!measured.fault.empty()) {
    verdict.reason = measured.fault;
  } else if (measured.censored) {
    verdict.reason = "censored rocks fall into it: the computed value is only a lower bound";
  } else if (holds(expectation, measured.value, verdict.tolerance)) {
    verdict.judgement = Judgement::passed;
  }
  return verdict;
}

}  // namespace

std::vector<Verdict> judge(const Plan& plan, const std::vector<PointResult>& points, bool full) {
  std::vector<Verdict> verdicts;
  const std::vector<Expectation>& expectations = plan.points.front().expect;
  for (const Expectation& expectation : expectations) {
    bool anywhere = false;
    for (std::size_t point = 0; point < points.size(); ++point) {
      if (!applies(expectation, plan, point)) continue;
      anywhere = true;
      verdicts.push_back(
          judge_at(expectation, plan.points[point], points[point], static_cast<int>(point), full));
    }
    if (!anywhere)
      verdicts.push_back(
          {expectation, -1, unknown, false, 0, Judgement::failed, "`at` names no point of the sweep"});
  }
  return verdicts;
}

}  // namespace flyrock
