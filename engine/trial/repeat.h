#pragma once
// Trials whose rocks start alike. They are built once; each further trial only gets keys of its own for what
// is drawn later: at impacts, for the laws of materials, and for orientations.

#include "scenario/scenario.h"

namespace flyrock {

/// Whether neither a plugin nor the shapes that it is made of are in Lua. One in Lua is asked for each rock,
/// because it may print.
bool is_native(const PluginUse& use);

/// Whether the rocks of all trials start alike unless a plugin draws: they are points that do not meet, their
/// plugins are native, and each distribution is drawn once a run or belongs to a material.
bool may_repeat(const Scenario& scenario);

}  // namespace flyrock
