#pragma once
// The runout by azimuth for summary.json and the page.

#include <nlohmann/json_fwd.hpp>

#include "results/measured/measures.h"

namespace flyrock {

/// For all rocks (group null), then for each group: { group, still, least, sectors: [{ from_deg, to_deg,
/// count, share, share_interval, greatest, lower_bound, p50, p95 }] }, of the sectors with rocks. p50 and p95
/// are null with fewer than `least` rocks, else { value, lower_bound, interval }. Empty in 2D and for
/// `bodies`.
nlohmann::ordered_json azimuth_data(const PointResult& point, double north);

}  // namespace flyrock
