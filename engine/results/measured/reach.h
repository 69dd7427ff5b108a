#pragma once
// How far the launch speeds of a run reach at their best angle, for comparing models.

#include <vector>

#include "flight/shroud.h"
#include "results/statistics/statistics.h"

namespace flyrock {

/// How a group of rocks is launched, and how far rocks with its launch speeds fly over level ground if they
/// are launched towards +x at the elevation of the greatest distance. The paths start where the first rock of
/// the group in trial 0 starts, and have the same drag.
struct LaunchReach {
  struct OfSpeed {
    Statistic statistic;  ///< which statistic of the launch speeds of the group
    double speed = 0;     ///< m/s
    Farthest farthest;    ///< 0 if the speed is 0
  };
  int group = 0;       ///< index into Scenario::rocks
  std::string model;   ///< "richards_moore (cratering, k 27)"
  Vec2 origin;         ///< m, of the first rock: x, and its height (y in 2D, z in 3D)
  double height = 0;   ///< m, height of its start above the lowest ground; in 3D above the ground below it
  double mass = 0;     ///< kg, of its first rock
  Forces<2> forces;    ///< in the vertical plane through x
  double longest = 0;  ///< s, longest flight: stop.time
  std::vector<OfSpeed> speeds;  ///< p50, p95 and maximum
};

/// One entry for each group that has a launch and whose first rock could be built. `groups` comes from
/// RockTally.
std::vector<LaunchReach> reaches_of(const Scenario& scenario, const std::vector<GroupSummary>& groups);

}  // namespace flyrock
