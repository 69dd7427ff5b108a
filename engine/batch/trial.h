#pragma once
// Runs the trials of one point of a plan.

#include <cstdint>

#include "batch/records.h"
#include "flight/crossings.h"
#include "scenario/build_trial.h"

namespace flyrock {

/// Owns the instances of the plugins; not shared between threads.
class TrialRunner {
 public:
  /// Makes the plugins and calls each on three sampled states. Throws PluginError: bad input, nothing was run.
  explicit TrialRunner(const Scenario& scenario);

  /// Appends one trial. A rock that fails is a row with its reason, never an exception.
  void run(std::uint64_t trial, TrialRecords& out);

  /// The terrain of a trial, for pictures.
  std::shared_ptr<const Terrain2> terrain_of(std::uint64_t trial) { return builder_.terrain_of(trial); }

 private:
  void sample();
  void fail_trial(std::uint64_t trial, const std::string& fault, TrialRecords& out) const;
  void record(std::uint64_t trial, int index, const TrialRock& rock, const World<2>* world, const BodyHistory& history,
              TrialRecords& out) const;
  void record_inputs(std::uint64_t trial, int index, const TrialRock& rock, TrialRecords& out) const;

  const Scenario& scenario_;
  TrialBuilder builder_;
  std::vector<Gate> gates_;
  std::vector<Barrier> barriers_;
  double bin_width_ = 0;  ///< m, of envelopes; 0 for `bodies`
};

}  // namespace flyrock
