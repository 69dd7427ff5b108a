#pragma once
// Who is hit, in summary.json.

#include <nlohmann/json_fwd.hpp>

#include "results/risk/exposure.h"

namespace flyrock {

/// { share, lower, upper, interval, telling_weight: null where the bounds tell }; share is the upper bound.
nlohmann::ordered_json bounds_data(const BlastBounds& bounds);

/// [{ exposure, at | line, area_m2, energy_J, occupied, blasts_per_year, radius_m, landings, trials,
/// hits_per_m2, per_blast: bounds_data(), per_year, per_year_interval }], with null for numbers of no
/// landing; with traffic also vehicle_hit, vehicle_hit_interval, expected_vehicles, road_hit.
nlohmann::ordered_json exposures_data(const Scenario& scenario,
                                      const std::vector<ExposureSummary>& exposures);

}  // namespace flyrock
