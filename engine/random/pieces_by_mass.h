#pragma once
// How many pieces there are of each size, where a distribution says how much mass there is.

#include <string>

#include "random/distribution.h"

namespace flyrock {

/// The distribution of the number of pieces over their size x, of which `mass` is the distribution of their
/// mass: dN is as dM / x^3, from the least to the greatest size of `mass`. A `sieve` with the sizes of `mass`
/// if that is one, and exact at them; else with 2001 sizes, and to 1e-4 of the density. `mass` has no fault
/// and no by_mass_fault.
Distribution pieces_by_mass(const Distribution& mass);

/// Why the pieces of a mass cannot be counted, or an empty text: their number has no bound if there is no
/// least size.
std::string by_mass_fault(const Distribution& mass);

}  // namespace flyrock
