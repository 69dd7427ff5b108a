#pragma once
// The comparison with what was measured, in summary.json.

#include <nlohmann/json_fwd.hpp>

#include "results/compare/observation.h"

namespace flyrock {

/// { of, per, rows, values, censored, lost, paired, scatter, bias, bias_error, across, across_error,
/// energy_distance, energy_noise, energy_noise_p90, inside_90: { rows, of, share, interval }, constant: {
/// value, energy_distance }, quantiles: [{ level, observed, model }], rocks: [{ name, group, observed, p5,
/// p50, p95, inside, trials, censored }], model: [...], levels: [...] }; the last two draw the distribution
/// of the model: its quantiles at levels. Lengths in m; null: not known.
nlohmann::ordered_json observation_data(const ObservedPlan& plan, const ObservationSummary& summary);

}  // namespace flyrock
