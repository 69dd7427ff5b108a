#include "batch/answer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace flyrock {

std::string display(const Bounded& number, std::string_view unit) {
  if (std::isnan(number.value)) return "-";
  const std::string text = fmt::format("{}{:.4g}", number.censored ? ">= " : "", number.value);
  return unit.empty() ? text : fmt::format("{} {}", text, unit);
}

namespace {

/// How a body or a rock ended, as the end of a sentence.
std::string_view ending(StopReason reason) {
  switch (reason) {
    case StopReason::stopped: return "came to rest";
    case StopReason::left_domain: return "left the domain";
    case StopReason::timed_out: return "was still moving";
    case StopReason::caught: return "was caught";
    case StopReason::diverged:
    case StopReason::plugin_error: break;
  }
  return "failed";
}

std::string percent(double share) { return fmt::format("{:.3g} %", 100 * share); }

/// The values that exist: a number, or the range of a sweep.
std::string range_of(std::vector<Bounded> values) {
  std::erase_if(values, [](const Bounded& value) { return std::isnan(value.value); });
  if (values.empty()) return "not known";
  const auto less = [](const Bounded& a, const Bounded& b) { return a.value < b.value; };
  const auto [low, high] = std::minmax_element(values.begin(), values.end(), less);
  if (low->value == high->value) return display(*high, "m");
  return fmt::format("{} to {}", display(*low, "m"), display(*high, "m"));
}

/// A statistic of the runout of a group (0: all rocks) over all points.
std::string range_of(const Results& results, Statistic statistic, std::size_t group = 0) {
  std::vector<Bounded> values;
  for (const PointResult& point : results.points)
    values.push_back(point.groups.at(group).at(RockQuantity::runout, statistic));
  return range_of(std::move(values));
}

/// " Clearance road: at most 0.1 % of the rocks go farther than 320 m (95 % interval 301 to 345 m). With the factor 1.5 that is 480
/// m."; over a sweep the least to the greatest distance, without an interval: the points have their own.
std::string clearances_answer(const Plan& plan, const Results& results) {
  std::string text;
  const std::vector<ClearancePlan>& plans = plan.points.front().clearances;
  for (std::size_t c = 0; c < plans.size(); ++c) {
    const ClearancePlan& asked = plans[c];
    const ClearanceSummary& first = results.points.front().clearances.at(c);
    if (!first.enough()) {
      text += fmt::format(" Clearance {}: not given, it needs {} {} and there are {}.", asked.name, first.needed,
                          asked.per_blast ? "blasts" : "rocks", first.count);
      continue;
    }
    std::vector<Bounded> distances, with_factor;
    for (const PointResult& point : results.points) {
      const ClearanceSummary& clearance = point.clearances.at(c);
      distances.push_back(clearance.distance);
      with_factor.push_back({clearance.with_factor, clearance.distance.censored});
    }
    text += fmt::format(" Clearance {}: at most {} of the {} farther than {}", asked.name, percent(asked.probability),
                        asked.per_blast ? "blasts throw a rock" : "rocks go", range_of(distances));
    const auto end = [](double value) { return std::isnan(value) ? std::string("unknown") : fmt::format("{:.4g}", value); };
    if (results.points.size() == 1)
      text += fmt::format(" ({} interval {} to {} m)", percent(asked.confidence), end(first.interval.lower),
                          end(first.interval.upper));
    text += '.';
    if (asked.factor) text += fmt::format(" With the factor {:.4g} that is {}.", *asked.factor, range_of(with_factor));
  }
  return text;
}

std::string bodies_answer(const Plan& plan, const Results& results) {
  const std::vector<std::string> names = group_names(plan.points.front());
  std::string text;
  constexpr std::size_t most_named = 4;  // of a heap of bodies the table says more than a sentence
  const std::vector<RockRecord>& bodies = results.points.front().first_trial;
  for (std::size_t b = 0; b < std::min(bodies.size(), most_named); ++b) {
    const RockRecord& body = bodies[b];
    text += fmt::format("{}{} {} after {:.4g} s, {:.4g} m from where it began, with {} impact{}.", b > 0 ? " " : "",
                        names.at(static_cast<std::size_t>(body.group)), ending(body.reason), body.time, body.runout,
                        body.impacts, body.impacts == 1 ? "" : "s");
  }
  if (bodies.size() > most_named) text += fmt::format(" In all {} bodies moved.", bodies.size());
  if (results.points.size() > 1) text += fmt::format(" (Point 0 of {}.)", results.points.size());
  return text;
}

/// " (blocks 217 m, loose 15.1 m)": of all rocks together a percentile says little where groups differ.
std::string by_group(const Results& results, Statistic statistic) {
  const std::vector<GroupSummary>& groups = results.points.front().groups;
  constexpr std::size_t most_named = 4;  // of more the table says more than a sentence
  if (groups.size() < 2) return "";
  if (groups.size() > most_named + 1) {
    const auto shorter = [&](const GroupSummary& a, const GroupSummary& b) {
      return a.at(RockQuantity::runout, statistic).value < b.at(RockQuantity::runout, statistic).value;
    };
    const auto [least, most] = std::minmax_element(groups.begin() + 1, groups.end(), shorter);
    const auto of = [&](auto group) {
      return fmt::format("{} {}", group->name, range_of(results, statistic, static_cast<std::size_t>(group - groups.begin())));
    };
    return fmt::format(" (from {} to {})", of(least), of(most));
  }
  std::vector<std::string> parts;
  for (std::size_t g = 1; g < groups.size(); ++g)
    parts.push_back(fmt::format("{} {}", groups[g].name, range_of(results, statistic, g)));
  return fmt::format(" ({})", fmt::join(parts, ", "));
}

}  // namespace

std::string answer(const Plan& plan, const Results& results) {
  const std::uint64_t rocks = results.rocks();
  if (rocks == 0) return "No rock was released.";
  std::uint64_t known = 0, censored = 0, caught = 0;
  for (const PointResult& point : results.points) {
    known += point.groups.front().count - point.groups.front().faults;
    censored += point.groups.front().censored;
    caught += point.groups.front().reasons[static_cast<std::size_t>(StopReason::caught)];
  }
  std::string text;
  if (known == 0) {
    text = fmt::format("All {} rocks failed.", rocks);
  } else if (!plan.points.front().bodies.empty()) {
    text = bodies_answer(plan, results);
  } else {
    text = fmt::format(
        "The runout that 95 % of the rocks do not exceed is {}{}; that of 99 % is {}{}; the greatest is {}.",
        range_of(results, Statistic::p95), by_group(results, Statistic::p95),
        range_of(results, Statistic::p99), by_group(results, Statistic::p99),
        range_of(results, Statistic::max));
    text += clearances_answer(plan, results);
    if (results.points.size() > 1) text += fmt::format(" The ranges are over {} sweep points.", results.points.size());
    text += censored == 0 ? " No rock is censored."
                          : fmt::format(" {} of the rocks are censored (left the domain or ran out of time): "
                                        "their distances are lower bounds.",
                                        percent(static_cast<double>(censored) / static_cast<double>(known)));
    if (caught > 0)
      text += fmt::format(" Barriers caught {}: these distances hold only while the barriers stand.",
                          percent(static_cast<double>(caught) / static_cast<double>(known)));
  }
  if (known > 0 && known < rocks) text += fmt::format(" {} rocks failed and are in no statistic.", rocks - known);
  if (!results.ended_early.empty()) text += fmt::format(" The run ended early: {}.", results.ended_early);
  return text;
}

std::string assumptions(const Plan& plan) {
  const Scenario& scenario = plan.points.front();
  std::string text = fmt::format("Assumed: {}, ", scenario.dimension == 2 ? "a vertical section (2D)" : "space (3D)");
  if (scenario.method == Method::ballistic) {
    text += "each rock is a point whose path ends where it first meets the ground: what it does there is not computed; ";
    text += scenario.air ? "drag of the air as on a sphere of equal volume." : "no drag of the air.";
  } else {
    text += "rigid bodies, ";
    if (scenario.bodies.empty())
      text += scenario.rock_contacts ? "rocks that meet each other, " : "each rock alone, rocks do not meet each other, ";
    text += scenario.air ? "drag of the air as on a sphere of equal volume; " : "no drag of the air; ";
    text += "contacts by non-smooth contact dynamics, ";
    text += scenario.solver.flight == FlightMode::exact ? "flights exact between them." : "flights in time steps.";
  }
  if (!scenario.bodies.empty()) return text;
  return text + " Percentiles are those of this model and of the numbers given to it: whether it is the bench in question is not "
                "part of the computation.";
}

}  // namespace flyrock
