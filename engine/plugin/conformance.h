#pragma once
// The rules that every plugin must keep, tested with parameters and states sampled from its manifest.

#include <string>
#include <vector>

#include "plugin/registry.h"

namespace flyrock {

/// What the tests of a plugin found.
struct Conformance {
  std::vector<std::string> faults;  ///< what is wrong with it
  /// What could not be called, each with the reason: the plugin itself, a dimension, or a parameter. Nothing
  /// is known about it.
  std::vector<std::string> not_called;
  bool whole = true;  ///< false: the tests took so long that only some of them were made
};

/// Tests a plugin in its dimensions:
///  - with some of its optional parameters it can be made, and then reads every parameter that it declares;
///  - shapes are convex with positive area and inertia, profiles without fault, launches finite,
///    laws in range at 1000 states, and the same everywhere where they say that they are constant;
///  - the same parameters and random numbers give the same answer;
///  - each parameter, where it can be given, changes the answer of at least one trial.
/// A plugin that no sample of its parameters can make is at fault. Parameters of type text, file and shapes
/// cannot be sampled: they are left out, and a plugin that requires one is not called. The tests stop after
/// 5 s of processor time. `given`, where it is not empty, has an entry for each parameter: those that are
/// given keep their values, and are called with even if they could not be sampled.
Conformance conformance(const Plugin& plugin, const std::vector<ParamValue>& given = {});

}  // namespace flyrock
