#pragma once
// How far the launch speeds of a run reach at their best angle: models side by side.

#include <optional>
#include <vector>

#include "flight/shroud.h"
#include "results/statistics.h"

namespace flyrock {

/// What a group of rocks launches with, and how far its speeds reach over level ground at their best angle,
/// upwards and towards +x, from where its first rock of trial 0 starts and through the air that this rock
/// meets.
struct Reach {
  struct OfSpeed {
    Statistic statistic;  ///< of the launch speeds of the group
    double speed = 0;     ///< m/s
    Farthest farthest;    ///< 0 where the speed is
  };
  int group = 0;                ///< index into Scenario::rocks
  std::string model;            ///< "richards_moore (cratering, k 27)"
  Vec2 origin;                  ///< m, of the first rock: x, and its height (y in 2D, z in 3D)
  double height = 0;            ///< m, of its start above the lowest ground; in 3D above the ground below it
  double mass = 0;              ///< kg, of that rock
  Forces<2> forces;             ///< in the vertical plane of x
  double longest = 0;           ///< s, of a flight: stop.time
  std::vector<OfSpeed> speeds;  ///< p50, p95 and the greatest
};

/// One entry for each group with a launch whose first rock could be built. `groups` as RockTally gives them.
std::vector<Reach> reaches_of(const Scenario& scenario, const std::vector<GroupSummary>& groups);

}  // namespace flyrock
