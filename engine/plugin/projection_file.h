#pragma once
// Coordinate systems in files beside grids.

#include <string>

namespace flyrock {

/// What a file .prj says, in the well-known text that GIS write.
struct Projection {
  std::string plan_unit;  ///< m, ft or us_ft; empty: another one, or degrees
  std::string crs;        ///< "EPSG:2056"; empty: the file has no number
  bool is_geographic = false;
};

/// Reads the file of the name of `grid` with the ending .prj; nothing is known where there is none.
Projection projection_beside(const std::string& grid);

}  // namespace flyrock
