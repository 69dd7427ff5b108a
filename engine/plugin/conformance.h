#pragma once
// What every plugin must keep, whoever wrote it: tried on parameters and states sampled from its manifest.

#include <string>
#include <vector>

#include "plugin/registry.h"

namespace flyrock {

/// Tries a plugin in the dimensions that it has and returns what is wrong with it, or nothing:
///  - with some of its optional parameters it can be made, and then reads every parameter that it declares;
///  - shapes are convex with positive area and inertia, profiles without fault, launches finite,
///    laws in range at 1000 states, and the same everywhere where they say that they are constant;
///  - the same parameters and random numbers give the same answer;
///  - each parameter, where it can be given, changes the answer of at least one trial.
/// Parameters of type text and file cannot be sampled and are left out; a plugin that requires one is not
/// tried. After 5 s of the processor no more is tried: `whole`, where given, says whether all was.
std::vector<std::string> conformance_faults(const Plugin& plugin, bool* whole = nullptr);

}  // namespace flyrock
