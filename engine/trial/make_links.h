#pragma once
// The links of a scenario between the bodies of a world.

#include "scenario/scenario.h"
#include "world/world.h"

namespace flyrock {

/// Gives the world, whose bodies are those of the scenario in their places, its links: their ends go with the
/// bodies. Throws ScenarioError for a link of a deformable body. Instantiated for D = 2, 3.
template <int D>
void make_links(const Scenario& scenario, World<D>& world);

}  // namespace flyrock
