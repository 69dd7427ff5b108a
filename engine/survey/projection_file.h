#pragma once
// Coordinate systems in files beside grids.

#include <string>

namespace flyrock {

/// What a file .prj says: well-known text (WKT 1 and 2, with a system of heights inside or after it), or the
/// keywords of ArcInfo (`Units FEET`).
struct Projection {
  std::string plan_unit;    ///< m, ft or us_ft; empty: not said, or degrees
  std::string height_unit;  ///< of a system of heights; empty: not said
  std::string crs;          ///< "EPSG:2056", of the system in plan; empty: the file has no number
  bool is_geographic = false;
  std::string fault;  ///< why it is not understood; empty if it is
};

/// Reads a projection from its text.
Projection projection_of(const std::string& text);

/// Reads the file of the name of `grid` with the ending .prj, in any case of its letters; nothing is known
/// where there is none.
Projection projection_beside(const std::string& grid);

}  // namespace flyrock
