#pragma once
// The cells of a ground in 3D beside the diameters of the rocks on it.

#include <optional>
#include <string>
#include <vector>

#include "results/measured/measures.h"

namespace flyrock {

/// Larger cells hide bumps of the size of the rocks, smaller ones cost time: docs/your-own-terrain.md.
inline constexpr double most_diameters_a_cell = 5, least_diameters_a_cell = 0.2;

/// All in metres. A diameter is that of the sphere with the rock's volume.
struct CellSize {
  double cell;     ///< Ground3::cell
  double p5, p50;  ///< diameters of the rocks of all groups
};

/// Nothing in 2D, without rocks, and for a ground without cells: a plane, or benches, which are designed.
std::optional<CellSize> cell_size(const PointResult& point);

/// What is wrong with the cells, each message once.
std::vector<std::string> cell_warnings(const std::vector<PointResult>& points);

}  // namespace flyrock
