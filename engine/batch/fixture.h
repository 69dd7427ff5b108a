#pragma once
// Fixed and driven bodies of a trial, which pictures of the motion show beside the rocks.

#include <vector>

#include "math/over_time.h"
#include "record/scenery.h"
#include "world/world.h"

namespace flyrock {

/// A body that is not dynamic, at its start. Instantiated for D = 2, 3.
template <int D>
Fixture fixture_of(const World<D>& world, const Body<D>& body);

/// The motion of a body whose velocity changes over time, in pieces with a constant acceleration each: a
/// fixture is where the body is at the start of its piece. Null: it is one piece.
std::vector<Fixture> pieces_of(Fixture first, const OverTime* velocity);

}  // namespace flyrock
