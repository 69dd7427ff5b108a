#pragma once
// Runs the trials of one point of a plan.

#include <cstdint>
#include <filesystem>

#include "batch/explain.h"
#include "batch/terrain_picture.h"
#include "flight/run.h"
#include "record/records.h"
#include "trial/build_trial.h"

namespace flyrock {

/// Owns the instances of the plugins. Threads must not share it.
class TrialRunner {
 public:
  /// Makes the plugins. Throws ScenarioError if one of them, or the ground of trial 0, cannot be made.
  explicit TrialRunner(const Scenario& scenario);

  /// Appends one trial. A rock that fails is a row with its reason and never an exception.
  void run(std::uint64_t trial, TrialRecords& out) { of_dimension_->run(trial, out); }

  /// Trials throw Interrupted as soon as `interrupted` returns true.
  void stop_when(bool (*interrupted)()) { of_dimension_->interrupted = interrupted; }

  /// Where trials say how far they are.
  void report_to(TrialWatch& watch) { of_dimension_->watch = &watch; }

  /// The folder for problems that did not converge, if output.hard_problems asks for them: at most ten for
  /// each trial, as trial-<t>-<n>.hdf5. The folder is made when it is needed.
  void keep_hard_problems(const std::filesystem::path& folder) { of_dimension_->hard_problems = folder; }

  /// Runs a trial for the explanation of one of its contact problems.
  void explain(std::uint64_t trial, Explainer& explainer);

  /// The terrain of a trial for pictures.
  TerrainPicture picture_of(std::uint64_t trial) { return of_dimension_->picture_of(trial); }

 private:
  struct OfDimension {
    std::filesystem::path hard_problems;  ///< empty: none are kept
    bool (*interrupted)() = [] { return false; };
    Explainer* explainer = nullptr;
    TrialWatch* watch = nullptr;
    virtual ~OfDimension() = default;
    virtual void run(std::uint64_t trial, TrialRecords& out) = 0;
    virtual TerrainPicture picture_of(std::uint64_t trial) = 0;
  };
  template <int D>
  class Trials;

  std::unique_ptr<OfDimension> of_dimension_;
};

}  // namespace flyrock
