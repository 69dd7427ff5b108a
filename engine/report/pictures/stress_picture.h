#pragma once
// A deformable body as it is stressed most, as a picture.

#include <string>

#include "results/measured/stressed_block.h"

namespace flyrock {

/// By what displacements are drawn greater, so that the greatest is about 5 % of the body: 1, 2 or 5 times a
/// power of ten; 1 where nothing is displaced.
double drawn_displacement(const StressedBlock& block);

/// A self-contained SVG picture of the cells in 2D, at their nodes displaced drawn_displacement times. A
/// darker red is a greater principal tension, up to the one that 1 % of the volume exceeds. Empty without
/// cells and in 3D.
std::string stress_svg(const StressedBlock& block);

}  // namespace flyrock
