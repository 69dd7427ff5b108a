#pragma once
// A rock that moves, as a part of an SVG picture.

#include <string>

#include "report/pictures/stage.h"

namespace flyrock {

/// In 2D a rock is drawn once and moves by transformations; in 3D each face has its corners in each frame. A
/// rock that would be too small to see is a dot.
std::string animated_rock(const Actor& actor, const Stage& stage, int dimension);

}  // namespace flyrock
