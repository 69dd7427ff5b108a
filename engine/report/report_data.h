#pragma once
// What the scripts of the page draw, as JSON. Lengths are whole millimetres, times whole milliseconds, which
// keeps the page small; series that grow are stored as differences.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "batch/load.h"
#include "report/sensitivity.h"
#include "report/tracks.h"
#include "results/results.h"

namespace flyrock {

/// Collects it: in a first pass over all rows, which may be while the run goes on, and in further ones.
class ReportData {
 public:
  explicit ReportData(const LoadedScenario& scenario);

  /// The chunks of all points in order, with all their rows.
  void see(int point, const TrialRecords& chunk);

  /// Behind the last chunk: thins the paths and sorts the inputs. It takes a while, and other work can be
  /// done beside; else finish() does it.
  void close();

  /// Reads `rows` of each point in passes and samples the laws of the scenario (call it in the thread of its
  /// session). { summary, source: { sha256, plugins, files }, scenario, groups, units, axes: [{ path, unit,
  /// per_si }], expectation_units: [{ unit, per_si }], drawn, points: [{ terrain, tracks, runout,
  /// convergence, envelopes, sensitivity, laws, bodies }] }. A value in SI times per_si is in the unit that
  /// people read. `laws` is null where it is that of point 0.
  nlohmann::ordered_json finish(const Results& results, const std::vector<Rows>& rows);

 private:
  /// The point whose chunks are shown: these keep rows.
  struct Open {
    Tracks tracks;
    Sensitivity sensitivity;
  };
  struct Closed {
    nlohmann::ordered_json tracks, sensitivity;
  };
  void open_point();
  void close_point();

  const LoadedScenario& scenario_;
  std::vector<Closed> closed_;  ///< points
  std::optional<Open> open_;
};

}  // namespace flyrock
