#pragma once
// How a run compares with what was measured: distributions, bias, energy distance, bands of single rocks.

#include <cstdint>
#include <string>
#include <vector>

#include "results/compare/simulated_rows.h"
#include "results/compare/throws.h"
#include "results/statistics/energy_distance.h"
#include "results/statistics/sample.h"
#include "results/statistics/unknown.h"

namespace flyrock {

/// The levels of the quantiles that are compared.
inline constexpr std::array<double, 7> compared_levels = {0.05, 0.1, 0.25, 0.5, 0.75, 0.9, 0.95};

/// One measured rock and its own trials. Numbers [m] as in ObservationSummary.
struct ObservedRock {
  std::string name, group;
  double observed = unknown;
  double p5 = unknown, p50 = unknown, p95 = unknown;  ///< of its own trials; NaN: too few, or it has none
  bool is_inside = false;                             ///< p5 to p95; false where they are NaN
  std::uint64_t trials = 0, censored = 0;             ///< of its own; rocks that left are in no other number
};

/// The numbers that are compared: runouts or distances; for places the component along the way from the
/// mean start to the mean of the measured places, counted from this start.
struct ObservationSummary {
  std::size_t rows = 0;          ///< measured
  std::uint64_t values = 0;      ///< of the model, of rocks that came to rest
  std::uint64_t censored = 0;    ///< rocks that left the domain or still moved: only in `with_censored`
  std::uint64_t lost = 0;        ///< rocks that failed
  bool is_paired = false;        ///< each row has a rock of its own
  bool has_scatter = true;       ///< trials differ
  SortedSample observed, model;  ///< in the plane: components along the way
  double bias = unknown, bias_error = unknown;      ///< model - observed, with its standard error
  double across = unknown, across_error = unknown;  ///< of places: the bias to the left of the way
  double energy = unknown;
  /// The same with censored rocks, which count where they were last seen, as in a fit. Their distances are
  /// lower bounds, so a bias of distances is one too.
  struct WithCensored {
    double bias = unknown, bias_error = unknown, energy = unknown;
  } with_censored;
  double energy_noise = unknown, energy_noise_p90 = unknown;  ///< of as many draws of the model itself
  std::size_t inside = 0, with_band = 0;  ///< rows inside their own 90 % band, of those that have one
  Interval inside_interval;               ///< of the share, exact, 95 %
  double constant = unknown;              ///< the best constant: the median measured (of places the mean one)
  double constant_energy = unknown;       ///< its energy distance
  std::vector<ObservedRock> rocks;
  std::optional<ThrowSummary> throws;  ///< where each row is the farthest rock of a hole
};

/// Compares the rows with these indices. Their order decides nothing. `seed`: of the draws of the noise.
ObservationSummary compare(const ObservedPlan& plan, const SimulatedRows& simulated,
                           const std::vector<std::size_t>& rows, std::uint64_t seed);
/// Compares all rows.
ObservationSummary compare(const ObservedPlan& plan, const SimulatedRows& simulated, std::uint64_t seed);

/// What was measured of all rows, as ObservationSummary::observed. `simulated` needs starts only
/// (starts_of()).
SortedSample measured(const ObservedPlan& plan, const SimulatedRows& simulated);
/// "2 rows, runout 40 to 50 m, median 45 m"
std::string measured_text(const ObservedPlan& plan, const SortedSample& measured);

/// What was measured of each row, in the terms of SimulatedValue.
std::vector<Vec2> observed_values(const ObservedPlan& plan, const SimulatedRows& simulated);

/// "The model runs 2.1 m (standard error 1.8 m) too far ..." for the answer of the run.
std::string observation_text(const ObservedPlan& plan, const ObservationSummary& summary);

}  // namespace flyrock
