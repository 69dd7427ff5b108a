#pragma once
// Random heights with a given spectrum, for rough surfaces.

#include <vector>

#include "random/stream.h"

namespace flyrock {

/// The spectrum of a rough surface: its power falls as (1 + (k length)^2)^-(hurst + d/2), where k is the
/// wave number [rad/m] and d is the number of directions in which the heights are given: 1 on a line, 2 on a
/// surface. Below 1/length it is flat: heights farther apart than `length` are independent.
struct RoughSpectrum {
  double length = 1;   ///< m
  double hurst = 0.8;  ///< from 0 (jagged) to 1 (smooth)
  double cell = 0.25;  ///< m, between neighbouring heights
};

/// Gaussian heights of mean 0 and standard deviation 1, over all draws, at rows x columns places, row by row.
/// One row gives a line (d = 1). The field repeats itself only beyond four lengths outside of these places,
/// so that its opposite ends are independent. It takes two numbers from `rng` for each wave, and is the same
/// on every processor (docs/determinism.md).
std::vector<double> gaussian_field(int rows, int columns, const RoughSpectrum& spectrum, RandomStream& rng);

}  // namespace flyrock
