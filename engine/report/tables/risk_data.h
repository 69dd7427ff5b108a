#pragma once
// The measured holes and the branches of a blast in summary.json.

#include <nlohmann/json_fwd.hpp>

#include "results/risk/risk.h"

namespace flyrock {

/// Adds to the data of a blast, where it has measured holes:
/// measured: [{ hole, row, x, y, z, time_s, burden_m, stemming_m, charge_kg, charge_kg_per_m, charge_to_mass,
/// rock_m3, powder_factor_kg_m3 }], with the medians of distributions,
/// risk: [{ of, distance_m, rocks, holes: [{ hole, rocks, share }] }], the holes with such rocks, most first,
/// and with a surveyed face face: { noise_m, error_m, burdens: [{ hole, charge_m: [from, to], depth_m: [...],
/// burden_m: [...], known: [...] }] }.
void add_hole_data(nlohmann::ordered_json& data, const BlastPlan& plan, const std::vector<Risk>& risks);

/// [{ branch, per, probability, units, share, interval, rocks, runout: { p50, p95, p99, max }, risk: [{ of,
/// distance_m, rocks, units, share, interval }] }]; the share of a risk is that of the units of the branch
/// with such a rock, with its exact binomial interval.
nlohmann::ordered_json branches_data(const Scenario& scenario, const RiskSummary& summary);

}  // namespace flyrock
