#pragma once
// The ground of a 3D run and where its rocks ended, for the page.

#include <nlohmann/json_fwd.hpp>

#include "report/pictures/ground_pictures.h"

namespace flyrock {

/// Each ground as { x, y, z, triangles, part, parts, lattice, cell }. x, y, z are differences in
/// thousandths, `triangles` differences of the indices of three vertices each, `part` alternates between a
/// number of triangles and the index of their part, `lattice` is 0 or as in GroundSurface.
nlohmann::ordered_json grounds_data(const GroundPictures& pictures);

/// { x, y, dx, dy, from, to, lines: [{ s, z }] }: the mean line of the rocks of a point with the ground under
/// it, thinned; s and z are differences in thousandths. null in 2D and without rocks.
nlohmann::ordered_json section_data(const PointResult& point);

/// { x, y, foot, height, diameter, count }: the first trees of a point in the coordinates of the scenario, as
/// differences in thousandths, and how many there are. null without a forest.
nlohmann::ordered_json stems_data(const PointResult& point, std::size_t most);

}  // namespace flyrock
