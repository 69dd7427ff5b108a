#pragma once
// What changed between two runs: their inputs, and the numbers that both have.

#include <nlohmann/json_fwd.hpp>

namespace flyrock {

/// A finished run: its manifest.json and its summary.json.
struct RunData {
  const nlohmann::ordered_json& manifest;
  const nlohmann::ordered_json& summary;
};

/// { title (of the other run), inputs: [{ path, before, now }], numbers: [{ what, unit, before, now, apart }]
/// }. Inputs are those of the resolved scenarios, as texts in SI units, null where a run does not have one;
/// elements of lists are called by their names. `before` and `now` of a number are { value, interval,
/// lower_bound }, those of sweep point 0; shares have no unit. `apart`: the intervals do not meet.
nlohmann::ordered_json against_data(const RunData& other, const RunData& now);

}  // namespace flyrock
