#pragma once
// Fixed and driven bodies of a trial, which pictures of the motion show beside the rocks.

#include "record/scenery.h"
#include "world/world.h"

namespace flyrock {

/// A body that is not dynamic, at its start. Instantiated for D = 2, 3.
template <int D>
Fixture fixture_of(const World<D>& world, const Body<D>& body);

}  // namespace flyrock
