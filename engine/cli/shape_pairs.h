#pragma once
// Which shapes touch which and how exactly, for the reference.

#include <string>
#include <vector>

#include "plugin/spec.h"

namespace flyrock::cli {

/// Two tables, of 2D and 3D, and one of the tiers (geometry/form.h). Each shape with an example against each
/// other one and the ground. The engine is asked: both shapes of a pair are put at one place, where all that
/// can touch each other have contacts. The shapes are those of the examples, whose names count from `folder`.
std::string shape_pairs(const std::vector<const PluginSpec*>& shapes, const std::string& folder);

}  // namespace flyrock::cli
