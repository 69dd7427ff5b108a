#pragma once
// The maps of a 3D run as JSON for the page.

#include <nlohmann/json_fwd.hpp>

#include "results/measured/measures.h"

namespace flyrock {

/// The most cells of all maps in one page; each takes some 60 bytes.
inline constexpr std::size_t most_page_cells = 40'000;

/// { x, y, cell, columns, rows, index, <raster>: [...] }: the south-western corner and the side of the cells
/// [m]; `index` holds differences of the indices of the cells with data; for each of map_names a value of
/// each of these. Null if no rock passed a cell, or if there are more than `room` cells, of which those used
/// are taken.
nlohmann::ordered_json map_data(const MapRasters& maps, std::size_t& room);

/// { name: unit } of the rasters, in their order.
nlohmann::ordered_json map_unit_data();

}  // namespace flyrock
