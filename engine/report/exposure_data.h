#pragma once
// Who is hit, in summary.json.

#include <nlohmann/json_fwd.hpp>

#include "results/exposure.h"

namespace flyrock {

/// [{ exposure, at | line, area_m2, energy_J, occupied, blasts_per_year, radius_m, landings, trials,
/// hits_per_m2, per_blast, interval, per_year, per_year_interval }], with null for numbers of no landing.
nlohmann::ordered_json exposures_data(const Scenario& scenario,
                                      const std::vector<ExposureSummary>& exposures);

}  // namespace flyrock
