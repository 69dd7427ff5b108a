#include "results/answer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "results/answer_shares.h"
#include "results/lost.h"

namespace flyrock {

std::string_view ended(StopReason reason, const Scenario& scenario) {
  return reason == StopReason::stopped && scenario.method == Method::ballistic ? "first landed"
                                                                               : name_of(reason);
}

std::string display(const Bounded& number, std::string_view unit) {
  if (std::isnan(number.value)) return "-";
  const std::string text = fmt::format("{}{:.4g}", number.censored ? ">= " : "", number.value);
  return unit.empty() ? text : fmt::format("{} {}", text, unit);
}

namespace {

/// How a body or a rock ended, as the end of a sentence.
std::string_view ending(StopReason reason) {
  switch (reason) {
    case StopReason::stopped:
      return "came to rest";
    case StopReason::left_domain:
      return "left the domain";
    case StopReason::timed_out:
      return "was still moving";
    case StopReason::caught:
      return "was caught";
    case StopReason::diverged:
    case StopReason::plugin_error:
    case StopReason::not_started:
      break;
  }
  return "failed";
}

/// The values that exist: one number, or the range over a sweep.
std::string range_of(std::vector<Bounded> values) {
  std::erase_if(values, [](const Bounded& value) { return std::isnan(value.value); });
  if (values.empty()) return "not known";
  const auto less = [](const Bounded& a, const Bounded& b) { return a.value < b.value; };
  const auto [low, high] = std::minmax_element(values.begin(), values.end(), less);
  if (low->value == high->value) return display(*high, "m");
  return fmt::format("{} to {}", display(*low, "m"), display(*high, "m"));
}

/// A statistic of the runout of a group (0: all rocks) over all sweep points.
std::string range_of(const Results& results, Statistic statistic, std::size_t group = 0) {
  std::vector<Bounded> values;
  for (const PointResult& point : results.points)
    values.push_back(point.groups.at(group).at(RockQuantity::runout, statistic));
  return range_of(std::move(values));
}

/// Who goes farther than a clearance: "rocks of face go", "blasts (with 3 rocks a blast) throw a rock of
/// face".
std::string who_goes(const Scenario& scenario, const ClearancePlan& asked, const ClearanceSummary& found) {
  const std::string of =
      asked.group < 0 ? "" : " of " + scenario.rocks.at(static_cast<std::size_t>(asked.group)).name;
  if (!asked.per_blast)
    return fmt::format("rocks{} {}", of, scenario.method == Method::ballistic ? "first land" : "go");
  const double rocks = found.rocks_per_blast();
  return fmt::format("blasts (with {:.4g} rock{} a blast) throw a rock{}{}", rocks, rocks == 1 ? "" : "s", of,
                     scenario.method == Method::ballistic ? " that first lands" : "");
}

/// "301 to 345 m". An end is unknown if the sample is too small for it, or if it is among censored rocks.
std::string ends_text(const Interval& interval) {
  if (std::isnan(interval.lower) && std::isnan(interval.upper)) return "not known";
  if (std::isnan(interval.upper))
    return fmt::format("from {:.4g} m on, its upper end is not known", interval.lower);
  if (std::isnan(interval.lower))
    return fmt::format("up to {:.4g} m, its lower end is not known", interval.upper);
  return fmt::format("{:.4g} to {:.4g} m", interval.lower, interval.upper);
}

/// " Clearance road: at most 0.1 % of the rocks go farther than 320 m (95 % interval 301 to 345 m). With the
/// factor 1.5 that is 480 m." With sectors, the distance of the sector that reaches farthest. In a sweep, the
/// least to the greatest distance without an interval, because each point has its own.
std::string clearance_answer(const Plan& plan, const Results& results, std::size_t c) {
  const ClearancePlan& asked = plan.points.front().clearances[c];
  const ClearanceSummary& first = results.points.front().clearances.at(c);
  if (!first.enough())
    return fmt::format(" Clearance {}: not given, it needs {} {} and there are {}.", asked.name, first.needed,
                       asked.per_blast ? "blasts" : "rocks", first.count);
  std::vector<Bounded> distances, with_factor;
  for (const PointResult& point : results.points) {
    const ClearanceSummary& clearance = point.clearances.at(c);
    distances.push_back(clearance.distance);
    with_factor.push_back({clearance.with_factor, clearance.distance.censored});
  }
  const std::string from = asked.sectors == 0 ? ""
                           : asked.about      ? " from the given point"
                                              : " from the hull of the release places";
  std::string text = fmt::format(
      " Clearance {}: {}at most {} of the {} farther than {}{}", asked.name,
      asked.sectors > 0 ? fmt::format("in each of {} directions ", asked.sectors) : "",
      percent(asked.probability), who_goes(plan.points.front(), asked, first), range_of(distances), from);
  if (results.points.size() == 1) {
    if (const SectorSummary* farthest = first.area.farthest())
      text += fmt::format(", which is reached at azimuth {:.4g} deg", farthest->azimuth * 180 / pi);
    if (asked.sectors > 0 && std::isnan(first.interval.lower) && std::isnan(first.interval.upper))
      text += " (the farthest rock there: too few ended there for an interval)";
    else
      text += fmt::format(" ({} interval {})", percent(asked.confidence), ends_text(first.interval));
  }
  text += '.';
  if (asked.factor)
    text += fmt::format(" With the factor {:.4g} that is {}.", *asked.factor, range_of(with_factor));
  return text;
}

std::string clearances_answer(const Plan& plan, const Results& results) {
  std::string text;
  for (std::size_t c = 0; c < plan.points.front().clearances.size(); ++c)
    text += clearance_answer(plan, results, c);
  return text;
}

std::string bodies_answer(const Plan& plan, const Results& results) {
  const std::vector<std::string> names = group_names(plan.points.front());
  std::string text;
  constexpr std::size_t most_named = 4;  // more are too many for a sentence
  const std::vector<RockRecord>& bodies = results.points.front().first_trial;
  for (std::size_t b = 0; b < std::min(bodies.size(), most_named); ++b) {
    const RockRecord& body = bodies[b];
    constexpr double rounding = 1e-9;  // m
    text += fmt::format("{}{} {} after {:.4g} s, {:.4g} m from where it began, with {} impact{}.",
                        b > 0 ? " " : "", names.at(static_cast<std::size_t>(body.group)), ending(body.reason),
                        body.time, body.runout < rounding ? 0 : body.runout, body.impacts,
                        body.impacts == 1 ? "" : "s");
  }
  if (bodies.size() > most_named) text += fmt::format(" In all {} bodies moved.", bodies.size());
  if (results.points.size() > 1) text += fmt::format(" (Point 0 of {}.)", results.points.size());
  return text;
}

/// " (blocks 217 m, loose 15.1 m)", because a percentile of all rocks together says little if groups differ.
std::string by_group(const Results& results, Statistic statistic) {
  const std::vector<GroupSummary>& groups = results.points.front().groups;
  constexpr std::size_t most_named = 4;  // more are too many for a sentence
  if (groups.size() < 2) return "";
  if (groups.size() > most_named + 1) {
    const auto shorter = [&](const GroupSummary& a, const GroupSummary& b) {
      return a.at(RockQuantity::runout, statistic).value < b.at(RockQuantity::runout, statistic).value;
    };
    const auto [least, most] = std::minmax_element(groups.begin() + 1, groups.end(), shorter);
    const auto of = [&](auto group) {
      return fmt::format("{} {}", group->name,
                         range_of(results, statistic, static_cast<std::size_t>(group - groups.begin())));
    };
    return fmt::format(" (from {} to {})", of(least), of(most));
  }
  std::vector<std::string> parts;
  for (std::size_t g = 1; g < groups.size(); ++g)
    parts.push_back(fmt::format("{} {}", groups[g].name, range_of(results, statistic, g)));
  return fmt::format(" ({})", fmt::join(parts, ", "));
}

/// The answer of a run of which points lost too many rocks: what the others say of the runout. Empty if none
/// did.
std::string lost_answer(const Plan& plan, const Results& results) {
  std::size_t lost = 0;
  std::array<std::vector<Bounded>, 3> kept;  // p95, p99, max
  for (std::size_t p = 0; p < results.points.size(); ++p) {
    const PointResult& point = results.points[p];
    if (has_lost(plan.points[p], point)) {
      ++lost;
      continue;
    }
    for (std::size_t k = 0; k < kept.size(); ++k)
      kept[k].push_back(point.groups.front().at(
          RockQuantity::runout, std::array{Statistic::p95, Statistic::p99, Statistic::max}[k]));
  }
  if (lost == 0) return {};
  if (results.points.size() == 1)
    return fmt::format("No percentiles, shares and clearances: {}.", lost_text(results.points.front()));
  std::string text = fmt::format(
      "{} of {} sweep points have no percentiles, shares and clearances: more than {:g} % of their rocks "
      "failed.",
      lost, results.points.size(), 100 * most_lost);
  if (lost < results.points.size())
    text += fmt::format(
        " At the others the runout that 95 % of the rocks do not exceed is {}; that of 99 % is {}; the "
        "greatest is "
        "{}.",
        range_of(kept[0]), range_of(kept[1]), range_of(kept[2]));
  return text;
}

}  // namespace

std::string answer(const Plan& plan, const Results& results) {
  const std::uint64_t rocks = results.rocks();
  if (rocks == 0) return "No rock was released.";
  std::uint64_t known = 0;
  for (const PointResult& point : results.points)
    known += point.groups.front().count - point.groups.front().faults;
  std::string text;
  if (known == 0) {
    text = fmt::format("All {} rocks failed.", rocks);
  } else if (!plan.points.front().bodies.empty()) {
    text = trees_answer(plan, results) + barriers_answer(plan, results) + bodies_answer(plan, results);
  } else if (const std::string lost = lost_answer(plan, results); !lost.empty()) {
    text = lost;
  } else {
    text = trees_answer(plan, results) + barriers_answer(plan, results);
    text += fmt::format(
        "The {} that 95 % of the rocks do not exceed is {}{}; that of 99 % is {}{}; the greatest is {}.",
        plan.all_end_at_landing() ? "distance of the first landing" : "runout",
        range_of(results, Statistic::p95), by_group(results, Statistic::p95),
        range_of(results, Statistic::p99), by_group(results, Statistic::p99),
        range_of(results, Statistic::max));
    text += clearances_answer(plan, results);
    if (results.points.size() > 1)
      text += fmt::format(" The ranges are over {} sweep points.", results.points.size());
    text += censored_answer(plan, results);
  }
  if (known > 0 && known < rocks)
    text += fmt::format(" {} rocks failed and are in no statistic.", rocks - known);
  if (!results.ended_early.empty()) text += fmt::format(" The run ended early: {}.", results.ended_early);
  return text;
}

std::string assumed_elevations(const Plan& plan) {
  std::map<double, std::vector<std::string>> groups;  // by elevation
  const auto add = [](std::vector<std::string>& names, const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  for (const Scenario& point : plan.points)
    for (const RockGroup& group : point.rocks)
      if (group.assumed_elevation) add(groups[*group.assumed_elevation], "`" + group.name + "`");
  std::string text;
  for (const auto& [elevation, names] : groups)
    text += fmt::format("{}The launch of {} gives no elevation, {:.4g} deg is assumed.",
                        text.empty() ? "" : " ", fmt::join(names, ", "), elevation * 180 / pi);
  return text;
}

std::string assumed_trees(const Plan& plan) {
  const auto any = [&](bool fixed) {
    return std::any_of(plan.points.begin(), plan.points.end(), [&](const Scenario& point) {
      return point.forest && point.forest->is_fixed == fixed;
    });
  };
  if (any(false))
    return "Trees are upright cylinders that take energy by the law dorren_berger, which is unverified: its "
           "source was not read.";
  return any(true) ? "Trees are upright cylinders that all take the same energy at most." : "";
}

std::string assumptions(const Plan& plan) {
  const Scenario& scenario = plan.points.front();
  std::string text =
      fmt::format("Assumed: {}, ", scenario.dimension == 2 ? "a vertical section (2D)" : "space (3D)");
  if (plan.all_end_at_landing()) {
    text +=
        "each rock is a point whose path ends where it first meets the ground: what it does there is not "
        "computed; ";
    text += scenario.air ? "drag of the air as on a sphere of equal volume." : "no drag of the air.";
  } else if (plan.methods() == std::vector{Method::lumped_mass}) {
    text +=
        "each rock is a point without extent and spin that rebounds from the ground and slides on it (lumped "
        "mass): its mass and size matter only where a law, the air or a barrier reads them; ";
    text += scenario.air ? "drag of the air as on a sphere of equal volume." : "no drag of the air.";
  } else {
    text += "rigid bodies, ";
    if (scenario.bodies.empty())
      text += scenario.rock_contacts ? "rocks that meet each other, "
                                     : "each rock alone, rocks do not meet each other, ";
    text += scenario.air ? "drag of the air as on a sphere of equal volume; " : "no drag of the air; ";
    text += "contacts by non-smooth contact dynamics, ";
    text += scenario.solver.flight == FlightMode::exact ? "flights exact between them."
                                                        : "flights in time steps.";
  }
  const std::vector<Method> methods = plan.methods();
  const auto also = [&](Method method) {
    return methods.size() > 1 && std::find(methods.begin(), methods.end(), method) != methods.end();
  };
  if (also(Method::ballistic))
    text += " At points with the method ballistic a path ends where it first meets the ground.";
  if (also(Method::lumped_mass))
    text +=
        " At points with the method lumped_mass a rock is a point without extent and spin, whose mass "
        "matters "
        "only where a law, the air or a barrier reads it.";
  if (const std::string trees = assumed_trees(plan); !trees.empty()) text += " " + trees;
  if (!scenario.bodies.empty()) return text;
  if (const std::string elevations = assumed_elevations(plan); !elevations.empty()) text += " " + elevations;
  return text +
         " Percentiles are those of this model and of the numbers given to it: whether it is the bench in "
         "question is not "
         "part of the computation.";
}

}  // namespace flyrock
