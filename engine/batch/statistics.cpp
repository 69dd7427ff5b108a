#include "batch/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flyrock {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// `sorted` by value, and at equal values the known before the censored; `first_censored` is the index of the
/// first censored one.
Bounded quantile(const std::vector<Bounded>& sorted, std::size_t first_censored, std::size_t percent) {
  // h = (n - 1) percent / 100 in whole numbers: the rank does not depend on rounding.
  const std::size_t hundredths = (sorted.size() - 1) * percent;
  const std::size_t low = hundredths / 100;
  const double share = static_cast<double>(hundredths % 100) / 100;
  const std::size_t high = share > 0 ? low + 1 : low;
  const double value = sorted[low].value + share * (sorted[high].value - sorted[low].value);
  return {value, first_censored <= high};
}

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
    summary.statistics[q] = statistics_of(std::move(values));
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

Statistics statistics_of(std::vector<Bounded> values) {
  Statistics result;
  result.fill({unknown, false});
  if (values.empty()) return result;
  const auto n = static_cast<double>(values.size());

  double sum = 0;
  for (const Bounded& v : values) sum += v.value;
  const double mean = sum / n;
  double squares = 0;
  for (const Bounded& v : values) squares += (v.value - mean) * (v.value - mean);

  std::sort(values.begin(), values.end(), [](const Bounded& a, const Bounded& b) {
    return a.value != b.value ? a.value < b.value : a.censored < b.censored;
  });
  const auto is_censored = [](const Bounded& v) { return v.censored; };
  const auto first = std::find_if(values.begin(), values.end(), is_censored);
  const auto first_censored = static_cast<std::size_t>(first - values.begin());
  const bool any = first != values.end();

  const auto set = [&](Statistic which, Bounded value) { result[static_cast<int>(which)] = value; };
  set(Statistic::mean, {mean, any});
  if (values.size() > 1) set(Statistic::sd, {std::sqrt(squares / (n - 1)), any});
  set(Statistic::min, quantile(values, first_censored, 0));
  set(Statistic::max, quantile(values, first_censored, 100));
  set(Statistic::p50, quantile(values, first_censored, 50));
  set(Statistic::p90, quantile(values, first_censored, 90));
  set(Statistic::p95, quantile(values, first_censored, 95));
  set(Statistic::p99, quantile(values, first_censored, 99));
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
