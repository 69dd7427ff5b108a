#pragma once
// Says which bodies of a scenario have contacts that are less exact (geometry/form.h, Tier).

#include <string>

#include "world/world.h"

namespace flyrock {

/// The greatest tier of the contactors of a body; c for a pneumatic or deformable one.
template <int D>
Tier tier_of(const Body<D>& body);

/// One line about the bodies of a world whose tier counts there: those of tier C, and of tier B those that
/// can meet another body while one of the two moves. Empty if there are none.
template <int D>
std::string tier_note(const World<D>& world);

}  // namespace flyrock
