#include "results/compare/best_point.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "results/results.h"
#include "results/say/answer.h"
#include "results/say/wording.h"
#include "scenario/measure.h"
#include "scenario/plan.h"
#include "units/units.h"

namespace flyrock {

namespace {

/// "12.3 m", "7.2 %", "3"
std::string value_text(double value, const std::string& measure, const std::string& unit) {
  if (is_share(measure)) return percent(value);
  const ReadableUnit shown = readable_unit(unit);
  const std::string number = three_digits(shown.per_si * value);
  return shown.name.empty() ? number : number + " " + shown.name;
}

/// "7.2 % (95 % interval 6.1 % to 8.4 %)"
std::string asked_text(const AskedNumber& asked, const std::string& measure, const std::string& unit) {
  if (!asked.measured.fault.empty()) return "not known: " + asked.measured.fault;
  const auto text = [&](double value) { return value_text(value, measure, unit); };
  const std::string number = (asked.measured.censored ? ">= " : "") + text(asked.measured.value);
  const auto& [lower, upper, effect, needed] = asked.interval;
  if (needed > 0) return fmt::format("{} (too few trials for an interval: about {})", number, needed);
  if (std::isnan(lower) || std::isnan(upper)) return number;
  return fmt::format("{} ({} interval {} to {})", number, percent(stated_confidence), text(lower),
                     text(upper));
}

AskedNumber ask(const std::string& name, const Scenario& scenario, const PointResult& result) {
  const Measure measure(name, scenario);
  AskedNumber asked{.measured = measure.value(result)};
  if (measure.of_rocks() && !name.ends_with(".count") && has_lost(scenario, result))
    asked.measured.fault = lost_text(result);
  else if (asked.measured.fault.empty() && std::isnan(asked.measured.value))
    asked.measured.fault = "there is no such number";
  if (asked.measured.fault.empty()) asked.interval = measure.interval(result);
  return asked;
}

/// A lower bound shows that a number is above a limit or not below it, and never the opposite.
void judge_limit(const AnswerPlan::Limit& limit, AskedNumber& asked) {
  const auto& [value, is_bound, fault] = asked.measured;
  const bool keeps = limit.is_below ? value < limit.value : value > limit.value;
  asked.holds = fault.empty() && keeps && !(limit.is_below && is_bound);
  if (fault.empty() && !keeps) asked.short_by = std::abs(value - limit.value);
}

std::string limit_text(const AnswerPlan::Limit& limit) {
  return fmt::format("{} {} {}", limit.measure, limit.is_below ? "below" : "above",
                     value_text(limit.value, limit.measure, limit.unit));
}

/// " such that a below 5 % and b above 3 m"
std::string limits_text(const AnswerPlan& plan) {
  std::vector<std::string> texts;
  for (const AnswerPlan::Limit& limit : plan.limits) texts.push_back(limit_text(limit));
  return texts.empty() ? "" : fmt::format(" such that {}", fmt::join(texts, " and "));
}

std::string named_point(const Plan& plan, std::size_t point) {
  return plan.axes.empty() ? "the run" : fmt::format("point {} ({})", point, brief_point_text(plan, point));
}

}  // namespace

bool is_share(const std::string& measure) {
  const std::vector<std::string> steps = measure_steps(measure);
  return steps[0] == "barrier" || (steps[0] == "gate" && (steps[2] == "passed" || steps[2] == "per_trial")) ||
         (steps[0] == "trees" && steps[1] != "hits") || (steps[0] == "rocks" && steps.back() == "censored");
}

bool BestPoint::Point::holds() const {
  return least.holds &&
         std::all_of(limits.begin(), limits.end(), [](const AskedNumber& limit) { return limit.holds; });
}

BestPoint find_best_point(const Plan& plan, const std::vector<PointResult>& points) {
  const AnswerPlan& asked = plan.points.front().answer.value();
  BestPoint found;
  for (std::size_t p = 0; p < points.size(); ++p) {
    BestPoint::Point& point = found.points.emplace_back();
    point.least = ask(asked.least, plan.points[p], points[p]);
    point.least.holds = point.least.measured.fault.empty() && !point.least.measured.censored;
    for (const AnswerPlan::Limit& limit : asked.limits) {
      point.limits.push_back(ask(limit.measure, plan.points[p], points[p]));
      judge_limit(limit, point.limits.back());
    }
    if (!point.holds()) continue;
    const auto value = [&](std::size_t of) { return found.points[of].least.measured.value; };
    if (!found.best.empty() && value(p) > value(found.best.front())) continue;
    if (!found.best.empty() && value(p) < value(found.best.front())) found.best.clear();
    found.best.push_back(p);
  }
  return found;
}

std::string best_point_text(const Plan& plan, const BestPoint& best) {
  const AnswerPlan& asked = plan.points.front().answer.value();
  const auto keep = std::count_if(best.points.begin(), best.points.end(),
                                  [](const BestPoint::Point& point) { return point.holds(); });
  const std::string question = fmt::format("Least {}{}: ", asked.least, limits_text(asked));
  if (best.best.empty()) return fmt::format("{}none of {} points.", question, best.points.size());
  const std::string number = asked_text(best.points[best.best.front()].least, asked.least, asked.unit);
  const std::string of = fmt::format("{} of {} points can be chosen", keep, best.points.size());
  if (best.best.size() == 1)
    return fmt::format("{}{}, with {}; {}.", question, named_point(plan, best.best.front()), number, of);
  constexpr std::size_t most_named = 4;  // more are too many for a sentence
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(most_named, best.best.size()); ++i)
    names.push_back(named_point(plan, best.best[i]));
  const std::string more =
      best.best.size() > most_named ? fmt::format(" and {} more", best.best.size() - most_named) : "";
  return fmt::format("{}a tie of {}{}, each with {}; {}.", question, fmt::join(names, ", "), more, number,
                     of);
}

std::string short_text(const Plan& plan, const BestPoint::Point& point) {
  const AnswerPlan& asked = plan.points.front().answer.value();
  std::vector<std::string> reasons;
  if (!point.least.holds)
    reasons.push_back(fmt::format("{} is {}{}", asked.least, asked_text(point.least, asked.least, asked.unit),
                                  point.least.measured.censored ? ", a lower bound" : ""));
  for (std::size_t i = 0; i < point.limits.size(); ++i) {
    const AnswerPlan::Limit& limit = asked.limits[i];
    const AskedNumber& number = point.limits[i];
    if (number.holds) continue;
    std::string text = fmt::format("{} is {}", limit.measure, asked_text(number, limit.measure, limit.unit));
    if (!std::isnan(number.short_by))
      text += fmt::format(", {}{} too {}", value_text(number.short_by, limit.measure, limit.unit),
                          is_share(limit.measure) ? " points" : "", limit.is_below ? "much" : "little");
    else if (number.measured.censored)
      text += ", a lower bound";
    reasons.push_back(text);
  }
  return fmt::format("{}", fmt::join(reasons, "; "));
}

}  // namespace flyrock
