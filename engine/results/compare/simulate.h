#pragma once
// Runs the trials of a scenario for what is compared with measurements, and keeps nothing else.

#include <string>

#include "load/load.h"
#include "results/compare/simulated_rows.h"

namespace flyrock {

/// A scenario file with what the command line adds to it.
struct SimulatedScenario {
  std::string path;
  Overrides overrides;
};

/// The rows of all trials of the first point, which has `observed`, on so many threads; the same for any
/// number of them. `loaded` is the same scenario, read before: its grounds are shared. Throws FileError if
/// the scenario cannot be read any more, ScenarioError if a plugin or ground cannot be made, and Interrupted.
SimulatedRows simulate(const SimulatedScenario& scenario, const LoadedScenario& loaded, int threads,
                       bool (*interrupted)());

/// Rows as bytes, with a checksum, and back; nothing if the bytes are damaged or of another `key`.
std::string stored(const SimulatedRows& rows, const std::string& key);
std::optional<SimulatedRows> restored(const std::string& bytes, const std::string& key);

}  // namespace flyrock
