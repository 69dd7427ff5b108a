#pragma once
// Fills the small voids of a grid.

#include "geometry/height_grid.h"

namespace flyrock {

struct FilledVoids {
  int count = 0, cells = 0;
};

/// Fills the voids that lie in a square of `most` x `most` cells and do not touch the outline of the grid. A
/// void is cells without data that touch at sides or corners. Its heights solve Laplace's equation, as a
/// membrane over its edge does: each is the mean of its four neighbours, to 0.1 mm.
FilledVoids fill_voids(HeightGrid& grid, int most);

}  // namespace flyrock
