#pragma once
// The corners of the blocks of a trial, for pictures.

#include <vector>

#include "trial/build_trial.h"

namespace flyrock {

/// Those of all blocks that joints have cut, before they move, in the coordinates of the scenario. Corners at
/// one place have one vertex.
template <int D>
std::vector<BlockCorner> block_corners(const Trial<D>& trial);

}  // namespace flyrock
