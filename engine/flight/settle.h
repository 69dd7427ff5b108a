#pragma once
// Lets the bodies of a world settle before time 0.

#include "flight/any_run.h"
#include "flight/loads.h"
#include "world/world.h"

namespace flyrock {

struct SettleSettings {
  double until = 0;                   ///< m/s, see AnyRun::stop_speed: all bodies are at rest below it
  double at_most = 0;                 ///< s
  const LoadTables* loads = nullptr;  ///< null: they do not change
  TrialWatch* watch = nullptr;
  bool (*interrupted)() = [] { return false; };
};

/// Runs the world until all bodies are at rest, at most for the time at_most, and then sets its time back to
/// 0. Meanwhile no contact bounces, laws and loads see time 0, and driven bodies and those that are held
/// (Body::hold) stand. Impacts are counted from 0 afterwards. Throws TrialError if a body ends with a fault,
/// and Interrupted.
template <int D>
void settle(World<D>& world, const SettleSettings& settings);

}  // namespace flyrock
