#include "results/measured/trial_measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "document/wording.h"
#include "results/measured/crossing_summary.h"
#include "results/measured/rows_of_rock.h"
#include "results/risk/exposure_kernel.h"
#include "results/risk/traffic.h"
#include "results/say/wording.h"
#include "results/statistics/blast_bounds.h"
#include "scenario/measure.h"
#include "units/units.h"

namespace flyrock {

namespace {

constexpr const char* expected =
    "expected rocks.NAME.QUANTITY.mean, .max, .p95 or .beyond[300 m], gate.NAME.per_trial, "
    "barrier.NAME.OUTCOME.per_trial or exposure.NAME.per_blast";

template <class Named>
std::vector<std::string> names_in(const std::vector<Named>& list) {
  std::vector<std::string> names;
  for (const Named& item : list) names.push_back(item.name);
  return names;
}

/// The index of a name; -1 with a fault that names the nearest.
int index_in(const std::vector<std::string>& names, const std::string& name, const char* what,
             std::string& fault) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<int>(found - names.begin());
  fault = fmt::format("the scenario has no {} `{}`{}", what, name, did_you_mean(name, names));
  return -1;
}

struct Weighted {
  double value, weight;
};

/// Linear between order statistics, as Sample::quantile(); with weights at the share of their sum.
double quantile_of(std::vector<Weighted>& values, double share) {
  std::sort(values.begin(), values.end(),
            [](const Weighted& a, const Weighted& b) { return a.value < b.value; });
  double all = 0;
  for (const Weighted& value : values) all += value.weight;
  const double wanted = share * (all - all / static_cast<double>(values.size()));
  double below = 0;
  for (std::size_t i = 0; i + 1 < values.size(); ++i) {
    const double step = values[i].weight;
    if (below + step > wanted) {
      const double part = (wanted - below) / step;
      return values[i].value + part * (values[i + 1].value - values[i].value);
    }
    below += step;
  }
  return values.back().value;
}

}  // namespace

/// The rocks of one trial, and where their rows begin.
struct TrialMeasure::Rocks {
  const TrialRecords& chunk;
  std::span<const RockRecord> rocks;
  std::size_t gates = 0, barriers = 0;
};

std::optional<TrialMeasure> TrialMeasure::read(const std::string& text, const Scenario& scenario,
                                               std::string& fault) {
  TrialMeasure measure(scenario);
  measure.text_ = text;
  const std::vector<std::string> steps = measure_steps(text);
  fault = fmt::format("`{}`, {}", text, expected);
  const std::string& kind = steps.front();
  bool is_read = false;
  if (kind == "rocks") is_read = measure.read_rocks(steps, fault);
  if (kind == "gate" || kind == "barrier" || kind == "exposure")
    is_read = measure.read_crossing(steps, fault);
  if (!is_read) return std::nullopt;
  fault.clear();
  return measure;
}

bool TrialMeasure::read_rocks(const std::vector<std::string>& steps, std::string& fault) {
  const std::vector<std::string> groups = names_in(scenario_->rocks);
  std::size_t next = 1;
  if (steps.size() == 4) {
    group_ = index_in(groups, steps[next++], "rocks", fault);
    if (group_ < 0) return false;
  }
  if (steps.size() != next + 2) return false;
  quantity_ = find_rock_statistic(steps[next]);
  if (quantity_ == rock_statistics.size()) {
    std::vector<std::string> names;
    for (const RockStatistic& known : rock_statistics) names.emplace_back(known.name());
    fault = fmt::format("rocks have no number `{}`{}", steps[next], did_you_mean(steps[next], names));
    return false;
  }
  const std::string& of = steps[next + 1];
  unit_ = rock_statistics[quantity_].column.unit;
  if (unit_.empty()) unit_ = "1";
  if (of == "mean") return kind_ = Kind::mean, true;
  if (of == "max") return kind_ = Kind::greatest, true;
  if (of == "p95") return kind_ = Kind::p95, true;
  if (!of.starts_with("beyond[") || !of.ends_with(']')) return false;
  const auto limit = parse_quantity(of.substr(7, of.size() - 8));
  const Dimension dimension = parse_unit(unit_).value_or(Unit{}).dimension;
  if (!limit || limit->unit.dimension != dimension) {
    fault = fmt::format("`{}`: expected a limit in {}, as beyond[300 m]", of, unit_);
    return false;
  }
  limit_ = limit->si();
  unit_ = "1";
  kind_ = Kind::beyond;
  return true;
}

bool TrialMeasure::read_crossing(const std::vector<std::string>& steps, std::string& fault) {
  if (steps.size() < 3) return false;
  const std::string& kind = steps[0];
  if (kind == "gate") {
    if (steps.back() != "per_trial" || steps.size() > 4 || (steps.size() == 4 && steps[2] != "passed"))
      return false;
    kind_ = Kind::gate;
    place_ = index_in(names_in(scenario_->gates), steps[1], "gate", fault);
  } else if (kind == "barrier") {
    if (steps.size() != 4 || steps[3] != "per_trial") return false;
    const auto outcome = std::find(barrier_share_names.begin(), barrier_share_names.end(), steps[2]);
    if (outcome == barrier_share_names.end()) return false;
    outcome_ = static_cast<int>(outcome - barrier_share_names.begin());
    kind_ = Kind::barrier;
    place_ = index_in(names_in(scenario_->barriers), steps[1], "barrier", fault);
  } else {
    if (steps.size() != 3 || steps[2] != "per_blast") return false;
    kind_ = Kind::exposure;
    place_ = index_in(names_in(scenario_->exposures), steps[1], "exposure", fault);
  }
  return place_ >= 0;
}

std::string TrialMeasure::words() const {
  const std::string who =
      group_ < 0 ? "all rocks" : fmt::format("`{}`", scenario_->rocks[static_cast<std::size_t>(group_)].name);
  const auto quantity = [&] {
    std::string name(rock_statistics[quantity_].name());
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
  };
  const auto place = static_cast<std::size_t>(std::max(0, place_));
  switch (kind_) {
    case Kind::mean:
      return fmt::format("the mean {} of {}", quantity(), who);
    case Kind::greatest:
      return fmt::format("the greatest {} of {}", quantity(), who);
    case Kind::p95:
      return fmt::format("the p95 of the {} of {}", quantity(), who);
    case Kind::beyond: {
      const std::string unit = rock_statistics[quantity_].column.unit;
      return fmt::format("the share of {} with a {} beyond {}{}", who, quantity(), three_digits(limit_),
                         unit == "1" ? "" : " " + unit);
    }
    case Kind::gate:
      return fmt::format("whether a rock of a trial passes gate `{}`", scenario_->gates[place].name);
    case Kind::barrier:
      return fmt::format("whether a rock of a trial is `{}` at barrier `{}`",
                         barrier_share_names[static_cast<std::size_t>(outcome_)],
                         scenario_->barriers[place].name);
    case Kind::exposure:
      return fmt::format("the probability that a blast hits `{}`", scenario_->exposures[place].name);
  }
  return {};
}

void TrialMeasure::add(const TrialRecords& chunk, std::vector<double>& of_trial) const {
  std::size_t first = 0, gates = 0, barriers = 0;
  while (first < chunk.rocks.size()) {
    const std::uint64_t trial = chunk.rocks[first].trial;
    std::size_t end = first;
    while (end < chunk.rocks.size() && chunk.rocks[end].trial == trial) ++end;
    const Rocks rocks{chunk, std::span(chunk.rocks).subspan(first, end - first), gates, barriers};
    double value = unknown;
    if (kind_ == Kind::gate || kind_ == Kind::barrier)
      value = of_crossings(rocks);
    else if (kind_ == Kind::exposure)
      value = of_exposure(rocks);
    else
      value = of_rocks(rocks);
    of_trial.at(trial) = value;
    while (gates < chunk.gates.size() && chunk.gates[gates].trial == trial) ++gates;
    while (barriers < chunk.barriers.size() && chunk.barriers[barriers].trial == trial) ++barriers;
    first = end;
  }
}

double TrialMeasure::of_rocks(const Rocks& rocks) const {
  std::vector<Weighted> values;
  double sum = 0, weight = 0, beyond = 0;
  for (const RockRecord& rock : rocks.rocks) {
    if (group_ >= 0 && rock.group != group_) continue;
    if (is_fault(rock.reason)) return unknown;
    const Bounded number = bounded(rock, rock_statistics[quantity_]);
    if (std::isnan(number.value)) continue;
    if (number.censored && !(kind_ == Kind::beyond && number.value > limit_)) return unknown;
    sum += rock.weight * number.value;
    weight += rock.weight;
    if (number.value > limit_) beyond += rock.weight;
    values.push_back({number.value, rock.weight});
  }
  if (kind_ == Kind::beyond) return weight > 0 ? beyond / weight : 0;
  if (values.empty()) return unknown;
  if (kind_ == Kind::mean) return sum / weight;
  if (kind_ == Kind::p95) return values.size() < least_rocks_for_p95 ? unknown : quantile_of(values, 0.95);
  return std::max_element(values.begin(), values.end(),
                          [](const Weighted& a, const Weighted& b) { return a.value < b.value; })
      ->value;
}

double TrialMeasure::of_crossings(const Rocks& rocks) const {
  std::size_t gate = rocks.gates, barrier = rocks.barriers;
  bool is_open = false;
  const auto place = static_cast<std::size_t>(place_);
  for (const RockRecord& rock : rocks.rocks) {
    const auto passages = rows_of_rock(rocks.chunk.gates, gate, rock);
    const auto hits = rows_of_rock(rocks.chunk.barriers, barrier, rock);
    bool has_arrived = false;
    if (kind_ == Kind::gate) {
      for (const GateRecord& row : passages) has_arrived |= row.passage.gate == place_;
      if (has_arrived) return 1;
      is_open |= may_still_arrive(rock, rock.decided_gates, place);
    } else {
      for (const BarrierRecord& row : hits) {
        if (row.hit.barrier != place_) continue;
        has_arrived = true;
        const auto share = static_cast<BarrierShare>(outcome_);
        const bool is_caught = row.hit.outcome == BarrierOutcome::caught;
        if (share == BarrierShare::reached || (share == BarrierShare::past && !is_caught) ||
            static_cast<int>(row.hit.outcome) == outcome_)
          return 1;
      }
      is_open |= !has_arrived && may_still_arrive(rock, rock.decided_barriers, place);
    }
    is_open |= is_fault(rock.reason);
  }
  return is_open ? unknown : 0;
}

double TrialMeasure::of_exposure(const Rocks& rocks) const {
  const ExposurePlan& plan = scenario_->exposures[static_cast<std::size_t>(place_)];
  const ExposureKernel kernel(plan, scenario_->dimension);
  double log_missed = 0;
  std::vector<StoneOnRoad> stones;
  for (const RockRecord& rock : rocks.rocks) {
    if (is_fault(rock.reason) || rock.censored) return unknown;
    if (rock.reason != StopReason::stopped || rock.end_energy < plan.energy) continue;
    if (kernel.distance(landing_of(rock)) > radius_) continue;
    const double way = kernel.distance(release_of(rock));
    log_missed += rock.weight * std::log1p(-kernel.chance(landing_of(rock), way, radius_));
    if (!plan.has_traffic()) continue;
    if (const auto stone = kernel.on_road(landing_of(rock), radius_))
      stones.push_back({stone->at, carried(stone->chance, rock.weight)});
  }
  if (!plan.has_traffic()) return -std::expm1(log_missed);
  std::stable_sort(stones.begin(), stones.end(),
                   [](const StoneOnRoad& a, const StoneOnRoad& b) { return a.at < b.at; });
  return vehicle_hits(stones, plan.length, plan.vehicles_per_metre()).chance;
}

}  // namespace flyrock
