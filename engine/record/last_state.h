#pragma once
// How a body ends a trial, for a run that begins there (`start`).

#include <array>
#include <string>

#include "record/observe.h"

namespace flyrock {

/// The last state of a body that is neither fixed nor driven, in SI units and the coordinates of the
/// scenario.
struct LastState {
  double mass = 0;                            ///< kg
  std::string shape;                          ///< shape_code() of its contactors (trial/shape_code.h)
  BodyState state;                            ///< at the end of the trial
  std::array<double, 4> turn = {1, 0, 0, 0};  ///< 3D: attitude, as in TrajectoryPoint
};

}  // namespace flyrock
