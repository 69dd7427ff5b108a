#include "batch/results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace flyrock {

namespace {

constexpr std::size_t faults_kept = 20;

/// Finds out what one point left.
class PointTally {
 public:
  PointTally(const Scenario& scenario, int point, Results& results)
      : point_(point),
        results_(results),
        rocks_(group_names(scenario)),
        crossings_(scenario.gates.size(), scenario.barriers.size()),
        clearances_(scenario.clearances) {}

  /// Rows of the first pass.
  void see_first(const TrialRecords& chunk) {
    result_.totals.add(chunk.totals);
    for (const RockRecord& rock : chunk.rocks) {
      if (result_.first_trial.empty() || rock.trial == result_.first_trial.front().trial) result_.first_trial.push_back(rock);
      if (!is_fault(rock.reason)) continue;
      ++results_.fault_count;
      if (results_.faults.size() < faults_kept)
        results_.faults.push_back({point_, rock.trial, rock.rock, rock.reason, rock.fault});
    }
    see(chunk);
  }

  void see(const TrialRecords& chunk) {
    rocks_.see(chunk);
    crossings_.see(chunk);
    clearances_.see(chunk);
  }

  bool again() {
    const bool rocks = rocks_.again(), crossings = crossings_.again(), clearances = clearances_.again();
    return rocks || crossings || clearances;
  }

  PointResult result() {
    result_.groups = rocks_.summaries();
    result_.gates = crossings_.gates();
    result_.barriers = crossings_.barriers();
    result_.clearances = clearances_.summaries();
    return std::move(result_);
  }

 private:
  int point_;
  Results& results_;  ///< takes the faults
  PointResult result_;
  RockTally rocks_;
  CrossingTally crossings_;
  ClearanceTally clearances_;
};

std::vector<std::string> collect_warnings(const Plan& plan, const std::vector<PointResult>& points) {
  std::vector<std::string> warnings = laws_never_asked(plan, points);
  for (const std::string& key : plan.not_used) warnings.push_back("not used: " + key);
  SolverQuality quality;
  for (const PointResult& point : points) quality.add(point.totals.quality);
  if (quality.not_converged > 0)
    warnings.push_back(
        fmt::format("solver: {} of {} contact problems did not converge; relative to the approach speed "
                    "their greatest residual is {:.2g}, solver.tolerance is {:.2g}",
                    quality.not_converged, quality.steps + quality.impact_problems,
                    quality.not_converged_residual, plan.points.front().solver.tolerance));
  if (quality.energy_gains > 0)
    warnings.push_back(fmt::format("solver: {} impacts or steps gained energy, {:.3g} J together", quality.energy_gains,
                                   quality.energy_gained));
  std::set<std::string> notes;  // the same launch may have the same trouble at every point
  for (const PointResult& point : points)
    for (const std::string& note : point.totals.notes)
      if (notes.insert(note).second) warnings.push_back(note);
  return warnings;
}

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

/// " Clearance road: 0.001 of the rocks go farther than 320 m (95 % interval 301 to 345 m); with the factor 1.5 that is
/// 480 m."
std::string clearances_answer(const Scenario& scenario, const PointResult& point) {
  std::string text;
  for (std::size_t c = 0; c < point.clearances.size(); ++c) {
    const ClearancePlan& plan = scenario.clearances[c];
    const ClearanceSummary& clearance = point.clearances[c];
    if (!clearance.enough()) {
      text += fmt::format(" Clearance {}: not given, it needs {} {} and there are {}.", plan.name, clearance.needed,
                          plan.per_blast ? "blasts" : "rocks", clearance.count);
      continue;
    }
    const auto end = [](double value) { return std::isnan(value) ? std::string("unknown") : fmt::format("{:.4g}", value); };
    text += fmt::format(" Clearance {}: {} of the {} farther than {} ({} interval {} to {} m).", plan.name,
                        percent(plan.probability), plan.per_blast ? "blasts throw a rock" : "rocks go",
                        display(clearance.distance, "m"), percent(plan.confidence),
                        end(clearance.interval.lower), end(clearance.interval.upper));
    if (plan.factor)
      text += fmt::format(" With the factor {:.4g} that is {}.", *plan.factor,
                          display({clearance.with_factor, clearance.distance.censored}, "m"));
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

/// A statistic of the runout of a group (0: all rocks) over all points that have one: a number, or the range
/// of a sweep.
std::string range_of(const Results& results, Statistic statistic, std::size_t group = 0) {
  std::vector<Bounded> values;
  for (const PointResult& point : results.points)
    if (const Bounded value = point.groups.at(group).at(RockQuantity::runout, statistic);
        !std::isnan(value.value))
      values.push_back(value);
  if (values.empty()) return "not known";
  const auto less = [](const Bounded& a, const Bounded& b) { return a.value < b.value; };
  const auto [low, high] = std::minmax_element(values.begin(), values.end(), less);
  if (low->value == high->value) return display(*high, "m");
  return fmt::format("{} to {}", display(*low, "m"), display(*high, "m"));
}

/// " (blocks 217 m, loose 15.1 m)": of all rocks together a percentile says little where groups differ.
std::string by_group(const Results& results, Statistic statistic) {
  const std::vector<GroupSummary>& groups = results.points.front().groups;
  if (groups.size() < 2) return "";
  std::vector<std::string> parts;
  for (std::size_t g = 1; g < groups.size(); ++g)
    parts.push_back(fmt::format("{} {}", groups[g].name, range_of(results, statistic, g)));
  return fmt::format(" ({})", fmt::join(parts, ", "));
}

}  // namespace

std::uint64_t Results::rocks() const {
  std::uint64_t sum = 0;
  for (const PointResult& point : points) sum += point.groups.front().count;
  return sum;
}

int Results::count(Judgement judgement) const {
  return static_cast<int>(std::count_if(verdicts.begin(), verdicts.end(),
                                        [&](const Verdict& verdict) { return verdict.judgement == judgement; }));
}

Results make_results(const Plan& plan, const std::vector<Rows>& rows, const RunFacts& facts, const SeePoint& see) {
  Results results;
  for (std::size_t p = 0; p < rows.size(); ++p) {
    const int point = static_cast<int>(p);
    PointTally tally(plan.points[p], point, results);
    rows[p](Part::whole, [&](const TrialRecords& chunk) {
      see(point, chunk);
      tally.see_first(chunk);
    });
    if (tally.again()) read_in_passes(rows[p], tally);
    results.points.push_back(tally.result());
    results.points.back().trials = facts.trials.at(p);
  }
  results.verdicts = judge(plan, results.points, facts.full && facts.ended_early.empty());
  results.warnings = facts.warnings;
  for (std::string& warning : collect_warnings(plan, results.points)) results.warnings.push_back(std::move(warning));
  results.ended_early = facts.ended_early;
  return results;
}

std::vector<std::string> laws_never_asked(const Plan& plan, const std::vector<PointResult>& points) {
  std::vector<std::string> warnings;
  const std::vector<Material>& materials = plan.points.front().materials;
  for (std::size_t m = 0; m < materials.size(); ++m) {
    MaterialUse use;
    for (const PointResult& point : points) {
      if (m >= point.totals.materials.size()) continue;
      const MaterialUse& more = point.totals.materials[m];
      use.contacts += more.contacts;
      use.restitution += more.restitution;
      use.friction += more.friction;
      use.rolling += more.rolling;
      use.unilateral += more.unilateral;
    }
    if (use.contacts == 0) {
      warnings.push_back(fmt::format("material {}: nothing touched it, none of its laws was asked", materials[m].name));
      continue;
    }
    const auto note = [&](const std::optional<PluginUse>& law, std::uint64_t asked, std::string_view kind) {
      if (law && asked == 0)
        warnings.push_back(fmt::format("material {}: its {} {} was never asked", materials[m].name, kind,
                                       law->plugin->spec.name));
    };
    note(materials[m].restitution, use.restitution, "restitution");
    note(materials[m].friction, use.friction, "friction");
    note(materials[m].rolling, use.rolling, "rolling");
    note(materials[m].unilateral, use.unilateral, "unilateral");
  }
  return warnings;
}

std::string display(const Bounded& number, std::string_view unit) {
  if (std::isnan(number.value)) return "-";
  const std::string text = fmt::format("{}{:.4g}", number.censored ? ">= " : "", number.value);
  return unit.empty() ? text : fmt::format("{} {}", text, unit);
}

std::string answer(const Plan& plan, const Results& results) {
  const std::uint64_t rocks = results.rocks();
  if (rocks == 0) return "No rock was released.";
  std::uint64_t known = 0, censored = 0;
  for (const PointResult& point : results.points) {
    known += point.groups.front().count - point.groups.front().faults;
    censored += point.groups.front().censored;
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
    if (results.points.size() == 1) text += clearances_answer(plan.points.front(), results.points.front());
    if (results.points.size() > 1) text += fmt::format(" The ranges are over {} sweep points.", results.points.size());
    text += censored == 0 ? " No rock is censored."
                          : fmt::format(" {} of the rocks are censored (left the domain or ran out of time): "
                                        "their distances are lower bounds.",
                                        percent(static_cast<double>(censored) / static_cast<double>(known)));
  }
  if (known > 0 && known < rocks) text += fmt::format(" {} rocks failed and are in no statistic.", rocks - known);
  if (!results.ended_early.empty()) text += fmt::format(" The run ended early: {}.", results.ended_early);
  return text;
}

}  // namespace flyrock
