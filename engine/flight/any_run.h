#pragma once
// What a run is told, whether it moves bodies (flight/run.h) or one point (flight/point_run.h).

#include <span>

#include "record/trial_watch.h"
#include "world/places.h"
#include "world/tree_law.h"

namespace flyrock {

/// What it refers to outlives the run.
struct AnyRun {
  double stop_time = 60;  ///< s; what starts later is timed out at its start
  /// m/s; what is slower for `rest_time` in contact is at rest (flight/rest.h); 0: never
  double stop_speed = 0.05;
  double trajectory_every = 0;  ///< s between stored points; 0: none
  bool keep_impacts = true;
  double bin_width = 0;  ///< m, of BodyHistory::path; 0: no bins are kept; needs a terrain with ends
  std::span<const Gate> gates;
  std::span<const Barrier> barriers;
  RunForest forest;
  TrialWatch* watch = nullptr;                   ///< null: nobody waits
  bool (*interrupted)() = [] { return false; };  ///< asked again and again; true: throw Interrupted
};

/// Thrown by a run that was interrupted. Its results are incomplete and must not be used.
struct Interrupted {};

}  // namespace flyrock
