#pragma once
// A comparison of launch models, for tables and pictures.

#include <nlohmann/json_fwd.hpp>

#include "results/measured/reach.h"

namespace flyrock {

/// [{ group, model, height_m, mass_kg, drag_1_m, speeds: [{ of, speed_m_s, elevation_deg, range_m }] }]:
/// summary.json, `reach`.
nlohmann::ordered_json reach_data(const Scenario& scenario, const std::vector<LaunchReach>& reaches);

/// [{ group, of, x, y }]: the shrouds of each group's speeds, in metres of the terrain. `group` counts from
/// 0.
nlohmann::ordered_json shroud_data(const std::vector<LaunchReach>& reaches);

}  // namespace flyrock
