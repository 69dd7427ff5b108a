#pragma once
// The trees of a scenario: of its file, or drawn.

#include <memory>

#include "geometry/forest.h"
#include "scenario/scenario.h"

namespace flyrock {

class Ground3;

/// The forest of a scenario in 3D, counted from its origin [m]; nullptr if it has none. Drawn once a run: all
/// trials, points with the same terrain and forest, and threads share it.
///
/// Tree i of drawn trees stands at a place that is uniform in the box of its zone in plan: density times the
/// area of the box of them, of which those stay that have ground of the zone below. Tree i is the same for
/// every density. `ground` is that of the first trial. Throws ScenarioError if the box has no ends, or if
/// there are more than 2,000,000 trees.
std::shared_ptr<const Forest> make_forest(const Scenario& scenario, const Ground3& ground);

/// "3 of 120 trees have no ground below them, ..."; empty if all stand on the ground. Of a file only: drawn
/// trees do. Throws ScenarioError if none of the trees of a file stands on the ground.
std::string trees_off_ground(const Scenario& scenario, const Forest& forest, const Ground3& ground);

}  // namespace flyrock
