#pragma once
// Envelopes along x as rows, for the database, and as JSON, for the page.

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "results/measures.h"

namespace flyrock {

/// What is told of each quantity of an envelope: shares of the rocks that do not exceed it.
inline constexpr std::array<std::pair<const char*, double>, 3> envelope_levels = {
    {{"p50", 0.5}, {"p95", 0.95}, {"max", 1}}};

/// The rocks that passed one bin.
struct EnvelopeRow {
  double x = 0;  ///< the left end of the bin [m]
  std::uint64_t rocks = 0;
  std::array<std::array<double, envelope_levels.size()>, envelope_quantity_names.size()>
      levels{};  ///< to 1 %
};

/// Bins in order, those that rocks passed: of all rocks, then of each group where there is more than one,
/// which is the order of PointResult::groups.
std::vector<std::vector<EnvelopeRow>> envelope_rows(const PointResult& point);

/// The width of the bins of a point [m]; 0 where it has no terrain.
double envelope_width(const PointResult& point);

/// { width, groups: [{ x, count, height: { p50, p95, max }, speed, energy }] }, with the same order of
/// groups.
nlohmann::ordered_json envelope_data(const PointResult& point);

}  // namespace flyrock
