#pragma once
// A ditch and a bund on any profile of 2D.

#include <optional>
#include <stdexcept>

#include "geometry/profile.h"

namespace flyrock {

/// From its near edge the ground goes down by `slope` to a level bottom, then up by `slope` to the ground.
struct GroundDitch {
  double x = 0;      ///< m, of the near edge
  double width = 0;  ///< m, of the bottom
  double depth = 0;  ///< m, of the bottom below the ground at the near edge
  double slope = 0;  ///< rad, of both sides
};

/// A bank: from its near foot up by `slope` to a level top, then down by `slope` to the ground.
struct GroundBund {
  std::optional<double> x;  ///< m, of the near foot; otherwise `distance` from the far edge of the ditch
  double distance = 0;      ///< m
  double height = 0;        ///< m, of the top above the ground at the near foot
  double top = 0;           ///< m, width of the top
  double slope = 0;         ///< rad, of both sides
};

struct Earthworks {
  std::optional<GroundDitch> ditch;
  std::optional<GroundBund> bund;
};

/// Earthworks do not fit on the ground.
struct EarthworksError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The profile with a ditch, then a bund, as parts `ditch` and `bund`. One that begins within 1 cm of a
/// point of the profile begins at it, because places are rounded. At an upright face the ground at x is that
/// to its right. Throws EarthworksError where one begins beside the profile, does not come back to the
/// ground before it ends, or crosses the ground in between, as the bottom of a ditch on a steep slope does.
Profile with_earthworks(Profile profile, const Earthworks& works);

}  // namespace flyrock
