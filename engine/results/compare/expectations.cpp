#include "results/compare/expectations.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "results/measured/lost.h"
#include "results/statistics/unknown.h"
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

double axis_value(const Plan& plan, std::size_t point, const std::string& path) {
  for (std::size_t axis = 0; axis < plan.axes.size(); ++axis)
    if (plan.axes[axis].path == path) return plan.at[point][axis];
  return unknown;
}

/// The slope of the line of least squares through points (x, y); NaN if all x are equal.
double slope_of(const std::vector<double>& x, const std::vector<double>& y) {
  const auto count = static_cast<double>(x.size());
  const double mean_x = std::accumulate(x.begin(), x.end(), 0.0) / count;
  const double mean_y = std::accumulate(y.begin(), y.end(), 0.0) / count;
  double xy = 0, xx = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xy += (x[i] - mean_x) * (y[i] - mean_y);
    xx += (x[i] - mean_x) * (x[i] - mean_x);
  }
  return xy / xx;
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

/// `points`: those that the expectation names.
Verdict judge_order(const Expectation& expectation, const Plan& plan, const std::vector<PointResult>& results,
                    const std::vector<std::size_t>& points, bool full) {
  std::vector<double> steps, errors;
  for (const std::size_t point : points) {
    Verdict at_point =
        judge_at(expectation, plan.points[point], results[point], static_cast<int>(point), full);
    at_point.point = -1;
    if (at_point.judgement == Judgement::not_judged || std::isnan(at_point.computed) || at_point.censored)
      return at_point;
    const double error = std::abs(at_point.computed - expectation.order->exact);
    if (error == 0) {
      at_point.judgement = Judgement::failed;
      at_point.computed = unknown;
      at_point.reason = fmt::format("the error at point {} is 0, so that there is no order", point);
      return at_point;
    }
    steps.push_back(std::log(std::abs(axis_value(plan, point, expectation.order->in))));
    errors.push_back(std::log(error));
  }
  Verdict verdict{expectation,       -1, slope_of(steps, errors), false, expectation.tolerance,
                  Judgement::failed, {}};
  if (expectation.relative) verdict.tolerance = *expectation.relative * std::abs(expectation.value);
  if (!std::isfinite(verdict.computed))
    verdict.reason =
        fmt::format("an order needs points with different values of `{}`", expectation.order->in);
  else if (holds(expectation, verdict.computed, verdict.tolerance))
    verdict.judgement = Judgement::passed;
  return verdict;
}

}  // namespace

std::string compared_text(const Expectation& expectation) {
  if (!expectation.order) return expectation.measure;
  return fmt::format("order of {} in {}", expectation.measure, expectation.order->in);
}

std::vector<Verdict> judge(const Plan& plan, const std::vector<PointResult>& points, bool full) {
  std::vector<Verdict> verdicts;
  const std::vector<Expectation>& expectations = plan.points.front().expect;
  for (const Expectation& expectation : expectations) {
    std::vector<std::size_t> named;
    for (std::size_t point = 0; point < points.size(); ++point)
      if (applies(expectation, plan, point)) named.push_back(point);
    if (named.empty())
      verdicts.push_back(
          {expectation, -1, unknown, false, 0, Judgement::failed, "`at` names no point of the sweep"});
    else if (expectation.order)
      verdicts.push_back(judge_order(expectation, plan, points, named, full));
    else
      for (const std::size_t point : named)
        verdicts.push_back(
            judge_at(expectation, plan.points[point], points[point], static_cast<int>(point), full));
  }
  return verdicts;
}

}  // namespace flyrock
