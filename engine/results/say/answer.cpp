#include "results/say/answer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "results/compare/barrier_choice.h"
#include "results/measured/assembly.h"
#include "results/measured/lost.h"
#include "results/measured/outer.h"
#include "results/say/answer_shares.h"
#include "results/say/asked_answer.h"
#include "results/say/weights.h"
#include "results/say/wording.h"
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
  if (moved.size() >= least_assembly) {
    const Assembly assembly = assembly_of(moving_bodies(scenario), results.points.front().totals.bodies);
    sentences.push_back(assembly_text(assembly, moved.size(), scenario.dimension));
    moved.clear();
  }
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

std::string distances_answer(const Plan& plan, const Results& results) {
  return fmt::format(
      "The {} that 95 % of the rocks do not exceed is {}; that of 99 % is {}; the greatest is {}.",
      plan.all_end_at_landing() ? "distance of the first landing" : "runout",
      runouts_of(plan, results, Statistic::p95), runouts_of(plan, results, Statistic::p99),
      runouts_of(plan, results, Statistic::max));
}

/// What a run of rocks answers, of which some came through.
void put_answers(const Plan& plan, const Results& results, AnswerTexts& texts) {
  const bool is_sweep = results.points.size() > 1;
  if (!is_sweep) {
    texts.questions = questions(plan.points.front(), results.points.front());
    texts.first = first_sentence(texts.questions);
  } else if (!results.best) {
    texts.first = barrier_choice_text(plan, results);
  }
  texts.asked = lost_answer(plan, results) + barriers_answer(plan, results) + gates_answer(plan, results) +
                (is_sweep ? asked_over_points(plan, results) : beside_questions(plan, results)) +
                trees_answer(plan, results);
  texts.distances = distances_answer(plan, results);
  texts.remarks = outer_answer(plan, results) + censored_answer(plan, results);
  if (const PointResult& point = results.points.front(); point.observation && !is_sweep)
    texts.remarks += " " + observation_text(*plan.points.front().observed, *point.observation);
  if (has_weights(plan, results)) texts.remarks += fmt::format(" {}", meaning_of_weights);
}

}  // namespace

AnswerTexts answer_texts(const Plan& plan, const Results& results) {
  AnswerTexts texts;
  const std::uint64_t rocks = results.rocks();
  if (rocks == 0) {
    texts.asked = "No rock was released.";
    return texts;
  }
  std::uint64_t known = 0;
  for (const PointResult& point : results.points)
    known += point.groups.front().count - point.groups.front().faults;
  if (results.best) texts.first = best_point_text(plan, *results.best);
  if (known == 0)
    texts.asked = fmt::format("All {} rocks failed.", rocks);
  else if (!plan.points.front().bodies.empty())
    texts.asked = trees_answer(plan, results) + barriers_answer(plan, results) + bodies_answer(plan, results);
  else if (lost_points(plan, results) == results.points.size())
    texts.asked = lost_answer(plan, results);
  else
    put_answers(plan, results, texts);
  if (known > 0 && known < rocks)
    texts.remarks += fmt::format(" {} rocks failed and are in no statistic.", rocks - known);
  if (!results.ended_early.empty())
    texts.remarks += fmt::format(" The run ended early: {}.", results.ended_early);
  return texts;
}

std::string AnswerTexts::rest() const { return asked + distances + remarks; }

std::string AnswerTexts::beside_table() const {
  const std::string text =
      asked + remarks.substr(asked.empty() ? 0 : std::min<std::size_t>(remarks.size(), 1));
  return text.substr(std::min(text.find_first_not_of(' '), text.size()));
}

std::string answer(const Plan& plan, const Results& results) {
  const AnswerTexts texts = answer_texts(plan, results);
  return texts.first + (texts.first.empty() ? "" : " ") + texts.rest();
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
  std::vector<std::string> grounds;  // of the points
  for (const Scenario& point : plan.points) {
    const TerrainPlan& terrain = point.terrain;
    grounds.push_back(terrain.survey.empty() ? ""
                                             : fmt::format("{}{}{}", terrain.survey,
                                                           terrain.crs.empty() ? "" : ", ", terrain.crs));
  }
  const bool is_one = std::all_of(grounds.begin(), grounds.end(),
                                  [&](const std::string& ground) { return ground == grounds.front(); });
  std::vector<std::string> lines;
  for (std::size_t p = 0; p < (is_one ? 1 : grounds.size()); ++p)
    if (!grounds[p].empty())
      lines.push_back(is_one ? fmt::format("terrain: {}", grounds[p])
                             : fmt::format("terrain at {}: {}", point_text(plan, p), grounds[p]));
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
    const bool deforms =
        std::any_of(scenario.bodies.begin(), scenario.bodies.end(),
                    [](const BodyPlan& body) { return body.shape.plugin->spec.name == "deformable"; });
    text += deforms ? "rigid and linearly elastic bodies, " : "rigid bodies, ";
    if (scenario.bodies.empty())
      text += scenario.rock_contacts ? "rocks that meet each other, "
                                     : "each rock alone, rocks do not meet each other, ";
    text += assumed_air(scenario) + "; ";
    text += "contacts by non-smooth contact dynamics, ";
    const bool steps = deforms || !scenario.links.empty() || scenario.solver.flight != FlightMode::exact;
    text += steps ? "flights in time steps." : "flights exact between them.";
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
