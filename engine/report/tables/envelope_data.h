#pragma once
// Envelopes along x, as rows for the database and as JSON for the page.

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "results/measured/measures.h"

namespace flyrock {

/// The values of each quantity of an envelope, each with the share of rocks that do not exceed it.
inline constexpr std::array<std::pair<const char*, double>, 3> envelope_levels = {
    {{"p50", 0.5}, {"p95", 0.95}, {"max", 1}}};

/// The rocks that passed one bin.
struct EnvelopeRow {
  double x = 0;      ///< left end of the bin [m]
  double rocks = 0;  ///< or the sum of their weights
  std::array<std::array<double, envelope_levels.size()>, envelope_quantity_names.size()>
      levels{};  ///< to 1 %
};

/// The bins that rocks passed, in order: first of all rocks, then of each group if there is more than one.
/// This is the order of PointResult::groups.
std::vector<std::vector<EnvelopeRow>> envelope_rows(const PointResult& point);

/// The width of the bins of a point [m]; 0 if it has no terrain.
double envelope_width(const PointResult& point);

/// { width, groups: [{ x, count, height: { p50, p95, max }, speed, energy }] }, groups in the same order.
nlohmann::ordered_json envelope_data(const PointResult& point);

}  // namespace flyrock
