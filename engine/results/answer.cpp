#include "results/answer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "geometry/bearing.h"
#include "results/answer_shares.h"
#include "results/lost.h"
#include "results/outer.h"
#include "results/weights.h"
#include "results/wording.h"
#include "scenario/plan.h"

namespace flyrock {

std::string_view ended(StopReason reason, const Scenario& scenario) {
  return reason == StopReason::stopped && scenario.method == Method::ballistic ? "first landed"
                                                                               : name_of(reason);
}

std::string display(const Bounded& number, std::string_view unit) {
  if (std::isnan(number.value)) return "-";
  const std::string text = (number.censored ? ">= " : "") + three_digits(number.value);
  return unit.empty() ? text : fmt::format("{} {}", text, unit);
}

namespace {

/// How a body ended, as the end of a sentence.
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

/// Why a clearance is not given.
std::string not_given(const ClearancePlan& asked, const ClearanceSummary& found) {
  const char* of = asked.per_blast ? "blasts" : "rocks";
  if (asked.sectors > 0)
    return fmt::format("there is no area, {} {} that are independent are too few",
                       three_digits(found.area.effective), of);
  if (found.interval.trials_needed > 0)
    return fmt::format("too few trials, it needs about {}", found.interval.trials_needed);
  return fmt::format("it needs {} {} and there are {}", found.needed, of, found.count);
}

/// "Clearance road: at most 0.1 % of the rocks go farther than 320 m (95 % interval 301 to 345 m). With the
/// factor 1.5 that is 480 m." With sectors, the greatest distance of the area. In a sweep, the least to the
/// greatest distance with their points.
std::string clearance_answer(const Plan& plan, const Results& results, std::size_t c) {
  const ClearancePlan& asked = plan.points.front().clearances[c];
  const auto at = [&](std::size_t p) -> const ClearanceSummary& {
    return results.points[p].clearances.at(c);
  };
  const ClearanceSummary& first = at(0);
  const bool one = results.points.size() == 1;
  if (one && !first.enough())
    return fmt::format("Clearance {}: not given, {}.", asked.name, not_given(asked, first));
  const auto distance_text = [&](std::size_t p) {
    if (asked.sectors > 0) return display(at(p).distance, "m");
    return with_interval(at(p).distance, at(p).interval, asked.confidence);
  };
  const auto value_at = [&](std::size_t p) { return at(p).distance.value; };
  const std::string distance = over_points(plan, results, value_at, distance_text);
  std::string text;
  if (asked.sectors > 0) {
    text = fmt::format("Area of {}: with {} confidence at most {} of new {} outside; it reaches {} from {}",
                       asked.name, percent(stated_confidence), percent(asked.probability),
                       asked.per_blast ? "blasts throw a rock" : "rocks stop", distance,
                       asked.about ? "the given point" : "the hull of the release places");
    if (one)
      text += fmt::format(", at {}",
                          bearing_text(first.area.farthest()->azimuth, plan.points.front().terrain.north));
  } else {
    text = fmt::format("Clearance {}: at most {} of the {} farther than {}", asked.name,
                       percent(asked.probability), who_goes(plan.points.front(), asked, first), distance);
  }
  if (one && first.is_upper_bound(asked))
    text +=
        fmt::format(", an upper bound, because a rock stands for {} real ones", three_digits(first.weight));
  text += '.';
  if (asked.factor)
    text += fmt::format(" With the factor {} that is {}.", three_digits(*asked.factor),
                        over_points(plan, results, value_at, [&](std::size_t p) {
                          return display({at(p).with_factor, at(p).distance.censored}, "m");
                        }));
  return text;
}

/// " Least area of road: 3.1 ha in 2 parts; with 95 % confidence at most 2 % of new rocks stop outside. A
/// circle about the release places takes 24.3 ha (278 m)."
std::string least_area_answer(const Plan& plan, const Results& results, std::size_t c) {
  const ClearancePlan& asked = plan.points.front().clearances[c];
  if (!asked.least_area) return {};
  const auto at = [&](std::size_t p) -> const LeastArea& {
    return results.points[p].clearances.at(c).least_area;
  };
  const bool one = results.points.size() == 1;
  const char* of = asked.per_blast ? "blasts" : "rocks";
  if (one && !at(0).beyond)
    return fmt::format(
        " Least area of {}: there is none, {} {} that are independent are too few in half of the trials.",
        asked.name, three_digits(at(0).effective), of);
  const auto hectares = [](double value) { return three_digits(value) + " ha"; };
  std::string text = fmt::format(
      " Least area of {}: {}", asked.name,
      over_points(
          plan, results, [&](std::size_t p) { return at(p).hectares; },
          [&](std::size_t p) { return (at(p).censored > 0 ? ">= " : "") + hectares(at(p).hectares); }));
  if (one && at(0).polygons.size() > 1) text += fmt::format(" in {} parts", at(0).polygons.size());
  text += fmt::format("; with {} confidence at most {} of new {} outside.", percent(stated_confidence),
                      percent(asked.probability), asked.per_blast ? "blasts throw a rock" : "rocks stop");
  if (one && !std::isnan(at(0).circle_hectares))
    text += fmt::format(" A circle about the release places takes {} ({} m).",
                        hectares(at(0).circle_hectares), three_digits(at(0).circle_distance));
  return text;
}

/// " Beside it: the customary distance is 300 m; 1.5 times the farthest known throw is 270 m."
std::string beside_clearance(const ClearancePlan& asked) {
  if (!asked.customary && !asked.known_throw) return {};
  std::string text = " Beside it:";
  if (asked.customary)
    text += fmt::format(" the legal or customary distance is {} m", three_digits(*asked.customary));
  if (asked.customary && asked.known_throw) text += ";";
  if (asked.known_throw)
    text += fmt::format(" {} times the farthest known throw is {} m", three_digits(beyond_known_throw),
                        three_digits(beyond_known_throw * *asked.known_throw));
  return text + '.';
}

std::string clearances_answer(const Plan& plan, const Results& results) {
  std::string text;
  for (std::size_t c = 0; c < plan.points.front().clearances.size(); ++c)
    text += clearance_answer(plan, results, c) + least_area_answer(plan, results, c) +
            beside_clearance(plan.points.front().clearances[c]) + ' ';
  return text;
}

/// "0.012 % (one blast in 8,300; 95 % interval 0.009 to 0.016 %)". Of one that no rock came near, the bound.
std::string hit_text(const ExposureSummary& found, std::uint64_t trials) {
  const BlastBounds& hit = found.per_blast;
  if (!(hit.upper > 0))
    return fmt::format("below {} (no rock of {} blasts landed within {} m; 95 % bound)",
                       percent(hit.interval.upper), trials, three_digits(found.radius));
  const std::string interval = fmt::format("95 % interval {} to {} %", three_digits(100 * hit.interval.lower),
                                           three_digits(100 * hit.interval.upper));
  if (!hit.tells())
    return fmt::format("between {} and {} ({}; {})", three_digits(100 * hit.lower), percent(hit.upper),
                       interval, telling_text(hit));
  return fmt::format("{} (one blast in {}; {})", percent(hit.upper), three_digits(1 / hit.upper), interval);
}

/// "Exposure house: a blast hits it with the probability 0.012 % (...), in a year of 50 blasts and occupied
/// 100 % of the time with 0.6 %." Of traffic a vehicle, and how often a rock lands on the road.
std::string exposure_answer(const Plan& plan, const Results& results, std::size_t e) {
  const ExposurePlan& asked = plan.points.front().exposures[e];
  const bool traffic = asked.has_traffic();
  const auto at = [&](std::size_t p) -> const ExposureSummary& { return results.points[p].exposures.at(e); };
  const auto over = [&](auto value_at, auto text_at) {
    return over_points(plan, results, value_at, text_at);
  };
  std::string text = fmt::format(
      "Exposure {}: a blast hits {} with the probability {}", asked.name, traffic ? "a vehicle" : "it",
      over([&](std::size_t p) { return at(p).per_blast.upper; },
           [&](std::size_t p) { return hit_text(at(p), results.points[p].trials); }));
  if (asked.blasts_per_year != 1 || (asked.occupied != 1 && !traffic))
    text += fmt::format(", in a year of {} blast{}{} with {}", three_digits(asked.blasts_per_year),
                        asked.blasts_per_year == 1 ? "" : "s",
                        traffic ? "" : fmt::format(" and occupied {} of the time", percent(asked.occupied)),
                        over([&](std::size_t p) { return at(p).per_year; },
                             [&](std::size_t p) {
                               const bool none = !(at(p).per_blast.upper > 0);
                               return (none ? "below " : "") +
                                      percent(none ? at(p).per_year_interval.upper : at(p).per_year);
                             }));
  if (traffic)
    text += fmt::format("; a rock lands on the road with {}",
                        over([&](std::size_t p) { return at(p).road_hit; },
                             [&](std::size_t p) { return percent(at(p).road_hit); }));
  return text + '.';
}

std::string exposures_answer(const Plan& plan, const Results& results) {
  std::string text;
  for (std::size_t e = 0; e < plan.points.front().exposures.size(); ++e)
    text += exposure_answer(plan, results, e) + ' ';
  return text;
}

/// What the scenario asks: places, clearances and exposures come before the distances that every run has.
std::string asked_answer(const Plan& plan, const Results& results) {
  return barriers_answer(plan, results) + gates_answer(plan, results) + clearances_answer(plan, results) +
         exposures_answer(plan, results) + trees_answer(plan, results);
}

/// What a reader asks of several runs: the clearances and exposures, or else the runout.
std::vector<std::pair<std::string, std::string>> outer_questions(const Plan& plan, const Results& results) {
  const Scenario& scenario = plan.points.front();
  std::vector<std::pair<std::string, std::string>> asked;  // words, measure
  for (const ClearancePlan& clearance : scenario.clearances)
    asked.emplace_back("clearance " + clearance.name, fmt::format("clearance.{}.distance", clearance.name));
  for (const ExposurePlan& exposure : scenario.exposures)
    asked.emplace_back("the probability of exposure " + exposure.name,
                       fmt::format("exposure.{}.per_blast", exposure.name));
  if (!asked.empty()) return asked;
  const std::vector<GroupSummary>& groups = results.points.front().groups;
  if (groups.size() == 1) return {{"the p95 of the runout", "rocks.runout.p95"}};
  for (std::size_t g = first_shown_group(plan, results); g < groups.size(); ++g)
    asked.emplace_back(g == 0 ? "the p95 of the runout of all rocks" : "that of " + groups[g].name,
                       g == 0 ? "rocks.runout.p95" : fmt::format("rocks.{}.runout.p95", groups[g].name));
  return asked;
}

/// " Between 20 runs of 500 trials, which differ by what is drawn `per: run`, clearance people is from 98 to
/// 131 m (p5 to p95; median 110 m)."
std::string outer_answer(const Plan& plan, const Results& results) {
  if (results.points.size() > 1 || !results.points.front().outer) return {};
  const OuterSummary& outer = *results.points.front().outer;
  std::vector<std::string> parts;
  for (const auto& [words, measure] : outer_questions(plan, results)) {
    const OuterNumber* number = outer.find(measure);
    if (!number || number->runs == 0) {
      parts.push_back(words + " is given by none of them");
      continue;
    }
    const bool is_share = number->unit == "1";
    const auto shown = [&](const Bounded& value) {
      if (is_share) return (value.censored ? ">= " : "") + percent(value.value);
      return display(value, number->unit);
    };
    parts.push_back(fmt::format(
        "{} is from {} to {} (p5 to p95; median {}{})", words, shown(number->p5), shown(number->p95),
        shown(number->p50),
        number->runs < outer.runs ? fmt::format("; {} runs give it", number->runs) : std::string()));
  }
  return fmt::format(" Between {} runs of {} trial{}, which differ by what is drawn `per: run`, {}.",
                     outer.runs, outer.trials, outer.trials == 1 ? "" : "s", fmt::join(parts, "; "));
}

/// A stone of an arch or a stack that stands: the error of the solver is all that it moves by. A body that
/// falls is faster after 10 us.
bool stood(const RockRecord& body) {
  constexpr double still = 1e-4;  // m/s, also of the motion that a spin's energy is worth
  const bool ended_well = body.reason == StopReason::stopped || body.reason == StopReason::timed_out;
  return ended_well && body.impacts == 0 && body.max_energy < 0.5 * body.mass * still * still;
}

/// "ball came to rest after 2 s, 3.1 m from where it began, with 4 impacts." With `stop.speed: 0` nothing
/// comes to rest, so the end of the time does not tell that a body moved.
std::string motion_of(const RockRecord& body, const std::string& name, double stop_speed) {
  constexpr double rounding = 1e-9;  // m
  const double way = body.runout < rounding ? 0 : body.runout;
  const std::string impacts = fmt::format("{} impact{}", body.impacts, body.impacts == 1 ? "" : "s");
  if (body.reason == StopReason::timed_out && stop_speed == 0)
    return fmt::format("{} was {:.4g} m from where it began after {:.4g} s, with {}.", name, way, body.time,
                       impacts);
  return fmt::format("{} {} after {:.4g} s, {:.4g} m from where it began, with {}.", name,
                     ending(body.reason), body.time, way, impacts);
}

constexpr std::size_t most_bodies_named = 3;  // more are too many for a sentence

std::string more_bodies(std::size_t count) {
  return fmt::format("{} more bod{}", count, count == 1 ? "y" : "ies");
}

/// "box_1, box_2, box_3 and 18 more bodies stood for 0.5 s." What is at rest at once has no time to be told.
std::string standing_text(const std::vector<std::string>& names, double time) {
  const auto end = names.begin() + static_cast<std::ptrdiff_t>(std::min(names.size(), most_bodies_named));
  std::string text = fmt::format("{}", fmt::join(names.begin(), end, ", "));
  if (names.size() > most_bodies_named) text += " and " + more_bodies(names.size() - most_bodies_named);
  return text + (time > 0 ? fmt::format(" stood for {:.4g} s.", time) : " stood from the start on.");
}

/// The bodies that moved, each with a sentence, and those that stood, with one for all of them.
std::string bodies_answer(const Plan& plan, const Results& results) {
  const Scenario& scenario = plan.points.front();
  const std::vector<std::string> names = group_names(scenario);
  std::vector<std::string> moved, standing;
  double longest = 0;  // s, of those that stood
  for (const RockRecord& body : results.points.front().first_trial) {
    const std::string& name = names.at(static_cast<std::size_t>(body.group));
    if (stood(body)) {
      standing.push_back(name);
      longest = std::max(longest, body.time);
    } else {
      moved.push_back(motion_of(body, name, scenario.stop.speed));
    }
  }
  std::vector<std::string> sentences;
  if (!standing.empty()) sentences.push_back(standing_text(standing, longest));
  for (std::size_t b = 0; b < std::min(moved.size(), most_bodies_named); ++b) sentences.push_back(moved[b]);
  if (moved.size() > most_bodies_named)
    sentences.push_back(more_bodies(moved.size() - most_bodies_named) + " moved.");
  if (results.points.size() > 1) sentences.push_back(fmt::format("(Point 0 of {}.)", results.points.size()));
  return fmt::format("{}", fmt::join(sentences, " "));
}

/// A statistic of the runout of a group (0: all rocks): with its interval; in a sweep the least and the
/// greatest with their points.
std::string runout_of(const Plan& plan, const Results& results, Statistic statistic, std::size_t group) {
  const auto at = [&](std::size_t p) -> const Bounded& {
    return results.points[p].groups.at(group).at(rock_statistic("runout"), statistic);
  };
  return over_points(
      plan, results, [&](std::size_t p) { return at(p).value; },
      [&](std::size_t p) {
        if (statistic == Statistic::max) return display(at(p), "m");
        const Interval& interval =
            results.points[p].groups.at(group).interval(rock_statistic("runout"), statistic);
        return with_interval(at(p), interval, stated_confidence);
      });
}

/// "217 m (95 % interval 210 to 226 m)", of several groups each: a mixture depends on how many of each were
/// run. "blocks 217 m (...), loose 15.1 m (...)"; of many the nearest and the farthest.
std::string runouts_of(const Plan& plan, const Results& results, Statistic statistic) {
  const std::vector<GroupSummary>& groups = results.points.front().groups;
  constexpr std::size_t most_named = 4;  // more are too many for a sentence
  if (groups.size() < 2) return runout_of(plan, results, statistic, 0);
  const auto of = [&](std::size_t group) {
    return fmt::format("{} {}", group == 0 ? "all (weighted)" : groups[group].name,
                       runout_of(plan, results, statistic, group));
  };
  const std::size_t first = first_shown_group(plan, results);
  if (groups.size() > most_named + 1) {
    const auto shorter = [&](const GroupSummary& a, const GroupSummary& b) {
      return a.at(rock_statistic("runout"), statistic).value <
             b.at(rock_statistic("runout"), statistic).value;
    };
    const auto [least, most] = std::minmax_element(groups.begin() + 1, groups.end(), shorter);
    return fmt::format("{}from {} to {}", first == 0 ? of(0) + ", " : "",
                       of(static_cast<std::size_t>(least - groups.begin())),
                       of(static_cast<std::size_t>(most - groups.begin())));
  }
  std::vector<std::string> parts;
  for (std::size_t g = first; g < groups.size(); ++g) parts.push_back(of(g));
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// The number of points that lost too many rocks for percentiles.
std::size_t lost_points(const Plan& plan, const Results& results) {
  std::size_t lost = 0;
  for (std::size_t p = 0; p < results.points.size(); ++p) lost += has_lost(plan.points[p], results.points[p]);
  return lost;
}

/// Which points the other sentences leave out; empty if none.
std::string lost_answer(const Plan& plan, const Results& results) {
  const std::size_t lost = lost_points(plan, results);
  if (lost == 0) return {};
  if (results.points.size() == 1)
    return fmt::format("No percentiles, shares and clearances: {}.", lost_text(results.points.front()));
  return fmt::format(
      "{} of {} sweep points have no percentiles, shares and clearances: more than {:g} % of their rocks "
      "failed. {}",
      lost, results.points.size(), 100 * most_lost, lost < results.points.size() ? "At the others: " : "");
}

}  // namespace

std::string answer(const Plan& plan, const Results& results) {
  const std::uint64_t rocks = results.rocks();
  if (rocks == 0) return "No rock was released.";
  std::uint64_t known = 0;
  for (const PointResult& point : results.points)
    known += point.groups.front().count - point.groups.front().faults;
  std::string text;
  if (results.best) text = best_point_text(plan, *results.best);
  if (known == 0) {
    text += fmt::format("All {} rocks failed.", rocks);
  } else if (!plan.points.front().bodies.empty()) {
    text += trees_answer(plan, results) + barriers_answer(plan, results) + bodies_answer(plan, results);
  } else if (lost_points(plan, results) == results.points.size()) {
    text += lost_answer(plan, results);
  } else {
    text += lost_answer(plan, results) + asked_answer(plan, results);
    text += fmt::format(
        "The {} that 95 % of the rocks do not exceed is {}; that of 99 % is {}; the greatest is {}.",
        plan.all_end_at_landing() ? "distance of the first landing" : "runout",
        runouts_of(plan, results, Statistic::p95), runouts_of(plan, results, Statistic::p99),
        runouts_of(plan, results, Statistic::max));
    text += outer_answer(plan, results);
    text += censored_answer(plan, results);
    if (const PointResult& first = results.points.front(); first.observation && results.points.size() == 1)
      text += " " + observation_text(*plan.points.front().observed, *first.observation);
    if (has_weights(plan, results)) text += fmt::format(" {}", meaning_of_weights);
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

std::string scales_of_tables(const Scenario& scenario) {
  std::string text;
  for (const RockGroup& group : scenario.rocks) {
    if (!group.table) continue;
    std::vector<double> scales;
    const double density =
        group.table->own_density || !group.density.is_constant()
            ? group.table->own_density
                  ? 1
                  : scenario.draws[static_cast<std::size_t>(group.density.draw)].quantile(0.5)
            : group.density.constant;
    for (const TableRock& rock : group.table->rocks)
      if (rock.lengths || rock.diameter)
        scales.push_back(group.mass ? 1 : group.table->scale_of(rock, density));
    text +=
        fmt::format("{}`{}` are the {} rocks of {}", text.empty() ? "" : " ", group.name,
                    group.table->rocks.size(), std::filesystem::path(group.table->file).filename().string());
    const SortedSample sorted(scales);
    if (scales.empty())
      text += ".";
    else if (sorted.values().front() == 1 && sorted.values().back() == 1)
      text += " with their lengths as measured.";
    else
      text += fmt::format(
          ", with the masses of the table; their lengths are scaled by {} to {} (median {}) to {} kg/m3.",
          three_digits(sorted.values().front()), three_digits(sorted.values().back()),
          three_digits(sorted.quantile(0.5)), three_digits(density));
  }
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

std::string surveyed_ground(const Plan& plan) {
  std::vector<std::string> lines;
  for (const Scenario& point : plan.points) {
    const TerrainPlan& terrain = point.terrain;
    if (terrain.survey.empty()) continue;
    std::string line =
        fmt::format("terrain: {}{}{}", terrain.survey, terrain.crs.empty() ? "" : ", ", terrain.crs);
    if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(std::move(line));
  }
  return fmt::format("{}", fmt::join(lines, "\n"));
}

namespace {

/// Which rocks the air slows down.
std::string assumed_air(const Scenario& scenario) {
  const char* drag = "drag of the air as on a sphere of equal volume";
  std::vector<std::string> with, without;
  for (const RockGroup& group : scenario.rocks) (group.air ? with : without).push_back(group.name);
  if (scenario.rocks.empty()) (scenario.air ? with : without).emplace_back();
  if (with.empty()) return "no drag of the air";
  if (without.empty()) return drag;
  return fmt::format("{} for `{}`, none for `{}`", drag, fmt::join(with, "`, `"), fmt::join(without, "`, `"));
}

}  // namespace

std::string assumptions(const Plan& plan) {
  const Scenario& scenario = plan.points.front();
  std::string text =
      fmt::format("Assumed: {}, ", scenario.dimension == 2 ? "a vertical section (2D)" : "space (3D)");
  if (plan.all_end_at_landing()) {
    text +=
        "each rock is a point whose path ends where it first meets the ground: what it does there is not "
        "computed; ";
    text += assumed_air(scenario) + ".";
  } else if (plan.methods() == std::vector{Method::lumped_mass}) {
    text +=
        "each rock is a point without extent and spin that rebounds from the ground and slides on it (lumped "
        "mass): its mass and size matter only where a law, the air or a barrier reads them; ";
    text += assumed_air(scenario) + ".";
  } else {
    text += "rigid bodies, ";
    if (scenario.bodies.empty())
      text += scenario.rock_contacts ? "rocks that meet each other, "
                                     : "each rock alone, rocks do not meet each other, ";
    text += assumed_air(scenario) + "; ";
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
  if (const std::string tables = scales_of_tables(scenario); !tables.empty()) text += " " + tables;
  return text +
         " Percentiles are those of this model and of the numbers given to it: whether it is the bench in "
         "question is not "
         "part of the computation.";
}

}  // namespace flyrock
