#pragma once
// What the scripts of the page draw, as JSON. Lengths are whole millimetres, times whole milliseconds, which keeps the
// page small; series that grow are stored as differences.

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "batch/load.h"
#include "batch/results.h"
#include "report/sensitivity.h"
#include "report/tracks.h"

namespace flyrock {

/// Collects it: in a first pass over all rows, which may be while the run goes on, and in further ones.
class ReportData {
 public:
  explicit ReportData(const LoadedScenario& scenario);

  /// The chunks of all points in order, with all their rows.
  void see(int point, const TrialRecords& chunk);

  /// Reads `rows` of each point in passes and samples the laws of the scenario (call it in the thread of its session).
  /// { summary, source: { sha256, plugins }, scenario, groups, units, drawn, points: [{ terrain, tracks, runout,
  /// convergence, envelopes, sensitivity, laws, bodies }] }. `laws` is null where it is that of point 0.
  nlohmann::ordered_json finish(const Results& results, const std::vector<Rows>& rows);

 private:
  /// Of one point.
  struct Point {
    Tracks tracks;
    nlohmann::ordered_json sensitivity;
  };
  void close_point();

  const LoadedScenario& scenario_;
  std::vector<Point> points_;
  std::size_t open_ = 0;                     ///< point whose chunks are shown
  std::optional<Sensitivity> sensitivity_;   ///< of that point: it keeps rows
};

}  // namespace flyrock
