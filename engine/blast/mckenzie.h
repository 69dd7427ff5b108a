#pragma once
// Fly-rock range from the scaled depth of burial of the charge (McKenzie).

#include "blast/blast.h"

namespace flyrock {

/// The scaled depth of burial [m/kg^(1/3)], D / W^(1/3), of the part of the charge that can throw rock at the
/// collar:
///   L = min(charge length, 10 d) (8 d for holes below 100 mm),  D = stemming + L/2,  W = L W/l.
/// Throws std::invalid_argument that names a field that is not positive. Source: C. K. McKenzie, Flyrock
/// range and fragment size prediction, ISEE 2009, in the form of 2022.
double scaled_depth_of_burial(const Blast& blast);

/// The range [m] of the fragment that flies farthest: 9.74 SDoB^-2.167 d^(2/3), with d in mm. The exponent
/// 2/3 applies to the diameter only.
double mckenzie_range(double depth, double hole_diameter);

/// The size [m] of that fragment: 3 SDoB^-2.167 (2600/rho) d^(2/3) mm, with d in mm. hole_diameter is in m,
/// rock_density in kg/m3.
double mckenzie_fragment(double depth, double hole_diameter, double rock_density);

}  // namespace flyrock
