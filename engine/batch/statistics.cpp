#include "batch/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flyrock {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

std::array<double, 4> shares_of(std::array<double, 4> parts) {
  double sum = 0;
  for (const double part : parts) sum += part;
  for (double& part : parts) part = sum > 0 ? part / sum : unknown;
  return parts;
}

GroupSummary summarise_group(const std::string& name, const std::vector<const RockRecord*>& rocks) {
  GroupSummary summary;
  summary.name = name;
  summary.count = rocks.size();
  for (const RockRecord* rock : rocks) {
    ++summary.reasons[static_cast<int>(rock->reason)];
    summary.faults += is_fault(rock->reason);
    summary.censored += !is_fault(rock->reason) && rock->censored;
  }
  Travel travel;
  for (const RockRecord* rock : rocks)
    for (std::size_t m = 0; m < travel_mode_names.size() && !is_fault(rock->reason); ++m)
      travel.add(static_cast<TravelMode>(m), rock->travel.time[m], rock->travel.distance[m]);
  summary.time_share = shares_of(travel.time);
  summary.distance_share = shares_of(travel.distance);
  for (std::size_t q = 0; q < quantity_names.size(); ++q) {
    std::vector<Bounded> values;
    for (const RockRecord* rock : rocks)
      if (!is_fault(rock->reason)) values.push_back(quantity_of(*rock, static_cast<RockQuantity>(q)));
    summary.statistics[q] = statistics_of(values);
    summary.intervals[q] = intervals_of(std::move(values));
  }
  return summary;
}

}  // namespace

Bounded quantity_of(const RockRecord& rock, RockQuantity quantity) {
  const bool cut = rock.censored;
  switch (quantity) {
    case RockQuantity::runout: return {rock.runout, cut};
    case RockQuantity::max_distance: return {rock.max_distance, cut};
    case RockQuantity::flight_range: return {rock.flight_range, cut && rock.impacts == 0};
    case RockQuantity::bounce_height: return {rock.bounce_height, cut};
    case RockQuantity::speed: return {rock.max_speed, cut};
    case RockQuantity::energy: return {rock.max_energy, cut};
    case RockQuantity::impacts: return {static_cast<double>(rock.impacts), cut};
    case RockQuantity::time: return {rock.time, cut};
  }
  return {};
}

namespace {

constexpr std::array<std::pair<Statistic, std::size_t>, 6> percents = {{{Statistic::min, 0},
                                                                        {Statistic::max, 100},
                                                                        {Statistic::p50, 50},
                                                                        {Statistic::p90, 90},
                                                                        {Statistic::p95, 95},
                                                                        {Statistic::p99, 99}}};

}  // namespace

Statistics statistics_of(std::vector<Bounded> values) {
  Statistics result;
  const Moments moments = moments_of(values);
  const Sample sample(std::move(values));
  result[static_cast<int>(Statistic::mean)] = {moments.mean, sample.any_censored()};
  result[static_cast<int>(Statistic::sd)] = {moments.sd, sample.any_censored()};
  for (const auto& [which, percent] : percents) result[static_cast<int>(which)] = sample.percentile(percent);
  return result;
}

Intervals intervals_of(std::vector<Bounded> values) {
  Intervals result;
  result.fill({unknown, unknown});
  const Sample sample(std::move(values));
  result[static_cast<int>(Statistic::mean)] = sample.mean_interval(stated_confidence);
  for (const auto& [which, percent] : percents)
    if (percent > 0 && percent < 100)
      result[static_cast<int>(which)] = sample.quantile_interval(static_cast<double>(percent) / 100, stated_confidence);
  return result;
}

double GroupSummary::censored_share() const {
  return count > faults ? static_cast<double>(censored) / static_cast<double>(count - faults) : 0;
}

bool is_fault(StopReason reason) { return reason == StopReason::diverged || reason == StopReason::plugin_error; }

std::vector<std::string> group_names(const Scenario& scenario) {
  std::vector<std::string> names;
  for (const RockGroup& group : scenario.rocks) names.push_back(group.name);
  for (const BodyPlan& body : scenario.bodies) names.push_back(body.name);
  return names;
}

std::vector<GroupSummary> summarise(const std::vector<RockRecord>& rocks, const std::vector<std::string>& groups) {
  std::vector<const RockRecord*> all;
  std::vector<std::vector<const RockRecord*>> of_group(groups.size());
  for (const RockRecord& rock : rocks) {
    all.push_back(&rock);
    of_group.at(static_cast<std::size_t>(rock.group)).push_back(&rock);
  }
  std::vector<GroupSummary> summaries = {summarise_group("", all)};
  if (groups.size() > 1)
    for (std::size_t g = 0; g < groups.size(); ++g) summaries.push_back(summarise_group(groups[g], of_group[g]));
  return summaries;
}

}  // namespace flyrock
