#pragma once
// A terrain in 3D given as heights on a square grid.

#include <cstdint>
#include <string>
#include <vector>

#include "math/space.h"

namespace flyrock {

/// Heights at the centres of square cells. Four neighbouring centres make two triangles, cut from south-west
/// to north-east. Where one of the four has no data, there is no ground. The terrain ends at the outermost
/// centres.
struct HeightGrid {
  int columns = 0, rows = 0;
  double cell = 1;                 ///< m
  Vec2 corner = Vec2::Zero();      ///< x, y of the centre of the south-western cell [m]
  std::vector<double> heights;     ///< m, row by row from the south, each from the west; NaN: no data
  std::vector<std::uint8_t> part;  ///< of each cell, in the same order: index into `parts`; empty: all 0
  std::vector<std::string> parts = {""};

  double at(int column, int row) const { return heights[static_cast<std::size_t>(row) * columns + column]; }
};

}  // namespace flyrock
