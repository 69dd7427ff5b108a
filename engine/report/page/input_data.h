#pragma once
// All inputs of a scenario with their units and where they are from, for the page that is signed.

#include <nlohmann/json_fwd.hpp>

#include "load/load.h"

namespace flyrock {

/// [{ path, value, from }]: each input as it is written, a bare number with its SI unit. `from` is the line
/// of the scenario (or of another source), or null for a default, whose value is in SI units and degrees.
/// Beside the `type` of a plugin stands its `source`, the publication. Keys that change no number are left
/// out: titles, output, expectations.
nlohmann::ordered_json input_data(const LoadedScenario& scenario);

}  // namespace flyrock
