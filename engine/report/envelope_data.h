#pragma once
// Envelopes along x as JSON.

#include <nlohmann/json.hpp>

#include "batch/measures.h"

namespace flyrock {

/// Of all rocks, then of each group where there is more than one: the order of PointResult::groups.
/// { width, groups: [{ x, count, height: { p50, p95, max }, speed, energy }] }: x is the left end of each bin that rocks
/// passed, count how many passed it. Numbers are rounded to 1 %.
nlohmann::ordered_json envelope_data(const PointResult& point);

}  // namespace flyrock
