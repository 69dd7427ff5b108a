#pragma once
// Runs a world: free flight in closed form, impacts without duration, contact phases in steps.

#include <functional>
#include <vector>

#include "flight/any_run.h"
#include "flight/loads.h"
#include "flight/series_recorder.h"
#include "record/plan_cells.h"

namespace flyrock {

struct RunSettings : AnyRun {
  bool exact_flight = true;    ///< false: fixed steps throughout, for comparison with the literature
  std::span<PlanCells> cells;  ///< of each body, where its path is recorded for maps; empty: for none
  const SeriesRequest* series = nullptr;  ///< null: no rows over time
  const LoadTables* loads = nullptr;      ///< null: they do not change
  /// Called after each step with its length [s], and after each impact with 0. May be empty.
  std::function<void(double step)> advanced;
  std::span<const DrawKey> keys;  ///< of the draws of each body, for trees
};

/// Runs the world until every dynamic body has stopped or left the terrain, or the time is up. With exact
/// flight:
///   - While nothing is in contact, all bodies jump to the next touch: parabola and free rotation. If two
///     moving bodies may meet in between, they advance in steps.
///   - At a touch, the impact problem of all closed contacts is solved. If all separate, the flight goes on.
///   - Otherwise steps of the scheme follow. Each step is cut at the first touch of a pair that is not in
///     contact.
/// A flight ends at a barrier or a tree as at a touch. A step is also cut there, to a hundredth of a step.
/// A body whose state is not finite ends as `diverged`. All bodies end as `diverged` if time stands still for
/// too many steps or too much work, because their contacts cannot all hold at once (flight/jam.h), or if a
/// driven body presses another one so that no motion satisfies its contacts (world/pressed.cpp,
/// flight/jam.h). Throws TrialError and Interrupted. Instantiated for D = 2, 3.
template <int D>
void run(World<D>& world, const RunSettings& settings, std::vector<BodyHistory>& histories);

}  // namespace flyrock
