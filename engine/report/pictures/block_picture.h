#pragma once
// The blocks between joints as a picture: in 2D the section, in 3D a view from the front.

#include <string>

#include "results/measured/block_summary.h"

namespace flyrock {

/// A self-contained SVG picture of the blocks of one trial, coloured by mode and factor (block_colour); the
/// title of each block has its numbers. Empty without corners.
std::string blocks_svg(const FirstBlocks& blocks, int dimension);

/// What a block is drawn in, and the classes of the legend: falls; factor below 1, below 1.3, from 1.3 on; a
/// mode without a factor; held; locked.
struct BlockColour {
  const char* name;
  const char* colour;
};
const BlockColour& block_colour(const BlockRow& block);

}  // namespace flyrock
