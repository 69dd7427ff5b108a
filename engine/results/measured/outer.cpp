#include "results/measured/outer.h"

#include <algorithm>
#include <cmath>

#include "results/measured/lost.h"
#include "results/measured/measure_tally.h"

namespace flyrock {

namespace {

/// The numbers of one run, from passes over its rows.
PointResult result_of_run(const Scenario& scenario, const Rows& rows, std::uint64_t trials) {
  MeasureTally tally(scenario);
  read_in_passes(rows, tally);
  PointResult result;
  tally.put(result, trials);
  return result;
}

/// All runs have the same kernels, so that their exposures differ by their landings alone.
Scenario with_kernels(Scenario scenario, const std::vector<ExposureSummary>& exposures) {
  for (std::size_t e = 0; e < exposures.size(); ++e)
    if (exposures[e].radius > 0) scenario.exposures[e].radius = exposures[e].radius;
  return scenario;
}

OuterNumber over_runs(const std::string& measure, const std::string& unit,
                      const std::vector<Bounded>& values) {
  OuterNumber number{.measure = measure, .unit = unit};
  number.runs = values.size();
  number.lower_bounds = static_cast<std::uint64_t>(
      std::count_if(values.begin(), values.end(), [](const Bounded& value) { return value.censored; }));
  const Sample sample = sample_of(values, {.quantiles = {0, 0.05, 0.5, 0.95, 1}, .intervals = {}});
  const Moments moments = sample.moments();
  number.mean = {moments.mean, sample.any_censored()};
  number.sd = {moments.sd, sample.any_censored()};
  number.min = sample.quantile(0);
  number.p5 = sample.quantile(0.05);
  number.p50 = sample.quantile(0.5);
  number.p95 = sample.quantile(0.95);
  number.max = sample.quantile(1);
  return number;
}

}  // namespace

const OuterNumber* OuterSummary::find(const std::string& measure) const {
  const auto found = std::find_if(numbers.begin(), numbers.end(),
                                  [&](const OuterNumber& number) { return number.measure == measure; });
  return found == numbers.end() ? nullptr : &*found;
}

OuterSummary make_outer(const Scenario& scenario, const MeasureNames& names, const Rows& rows,
                        const std::vector<ExposureSummary>& exposures) {
  const std::uint64_t trials = scenario.trials_of_run();
  OuterSummary summary{.runs = scenario.outer, .trials = trials};
  const Scenario of_run = with_kernels(scenario, exposures);
  const std::vector<std::string> measures = measures_of_rocks(names);
  std::vector<Measure> readers;
  for (const std::string& measure : measures) readers.emplace_back(measure, scenario);

  std::vector<std::vector<Bounded>> values(measures.size());
  for (std::uint64_t run = 0; run < summary.runs; ++run) {
    const PointResult result = result_of_run(of_run, rows.within({run * trials, (run + 1) * trials}), trials);
    if (has_lost(scenario, result)) {
      ++summary.lost;
      continue;
    }
    for (std::size_t m = 0; m < readers.size(); ++m)
      if (const Measured number = readers[m].value(result); number.fault.empty() && !std::isnan(number.value))
        values[m].push_back({number.value, number.censored});
  }
  for (std::size_t m = 0; m < measures.size(); ++m)
    summary.numbers.push_back(
        over_runs(measures[m], si_unit(check_measure(measures[m], names).dimension), values[m]));
  return summary;
}

}  // namespace flyrock
