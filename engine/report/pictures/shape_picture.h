#pragma once
// Pictures of rocks, for the reference.

#include <string>
#include <vector>

#include "record/scenery.h"

namespace flyrock {

/// A rock at its attitude in the world frame, about its centre of mass [m].
struct PicturedRock {
  std::string name;
  std::vector<SurfaceCorner> corners;  ///< record/scenery.h, turned to the world
};

/// The rocks next to each other as a self-contained SVG picture, each with its name and a bar of round
/// length. In 3D they are seen from the front, the right and above, without perspective; faces are the
/// lighter the more they look up. `title` is for readers that cannot see it.
std::string svg_of_rocks(const std::string& title, const std::vector<PicturedRock>& rocks, int dimension);

}  // namespace flyrock
