#pragma once
// The rules that every plugin must keep, tested with parameters and states sampled from its manifest.

#include <string>
#include <vector>

#include "plugin/registry.h"

namespace flyrock {

/// Tests a plugin in its dimensions and returns what is wrong with it, or nothing:
///  - with some of its optional parameters it can be made, and then reads every parameter that it declares;
///  - shapes are convex with positive area and inertia, profiles without fault, launches finite,
///    laws in range at 1000 states, and the same everywhere where they say that they are constant;
///  - the same parameters and random numbers give the same answer;
///  - each parameter, where it can be given, changes the answer of at least one trial.
/// Parameters of type text and file cannot be sampled and are left out. A plugin that requires one is not
/// tested. The tests stop after 5 s of processor time; `whole`, if given, reports whether all tests were
/// made.
std::vector<std::string> conformance_faults(const Plugin& plugin, bool* whole = nullptr);

}  // namespace flyrock
