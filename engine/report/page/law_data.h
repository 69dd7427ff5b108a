#pragma once
// Law graphs as JSON.

#include <nlohmann/json_fwd.hpp>

#include "results/measured/material_graphs.h"

namespace flyrock {

/// { mass, radius, graphs: [{ material, kind, law, doc, source, x, y, speed, curves, drawn, fault }] }. A
/// curve is { name, middle }, with { low, high } in addition if parameters are drawn.
nlohmann::ordered_json law_data(const Scenario& scenario, const LawSubject& subject);

}  // namespace flyrock
