#pragma once
// The data that the scripts of the page draw, as JSON. Lengths are whole millimetres, times whole
// milliseconds, and growing series are stored as differences, because this keeps the page small.

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "load/load.h"
#include "report/page/deposits.h"
#include "report/page/sensitivity.h"
#include "report/page/tracks.h"
#include "report/pictures/ground_pictures.h"
#include "results/results.h"

namespace flyrock {

/// Collects the data: in a first pass over all rows, which may take place during the run, and in further
/// passes.
class ReportData {
 public:
  explicit ReportData(const LoadedScenario& scenario);
  ~ReportData();

  /// Takes the chunks of all points in order, with all their rows. `first`: the rows of the chunk for paths
  /// and inputs, all of them unless `output.rocks` is false.
  void add(int point, const TrialRecords& chunk, const TrialRecords& first);

  /// Thins the paths and sorts the inputs, after the last chunk. It takes a while; other work can run at the
  /// same time. If it is not called, finish() does the same.
  void close();

  /// The reader of the further passes over the rows of a point; finish() needs what it has read of each.
  RowReader* reader(std::size_t point, const std::vector<RunoutExtent>& runouts);

  /// Samples the laws of the scenario (call it in the thread of its session).
  /// { summary, source: { sha256, plugins, files }, scenario, groups, units, map_units, axes: [{ path, unit,
  /// per_si }], expectation_units: [{ unit, per_si }], inputs (input_data.h), drawn, grounds, points: [{
  /// terrain, ground, section, deposits, tracks, cell, azimuths, runout, convergence, envelopes, map,
  /// sensitivity, laws, bodies }] }. `terrain` is the profile (no points in 3D); `ground` the index into
  /// `grounds`, -1 in 2D; `deposits` is null in 2D. A value in SI times per_si is in the unit shown to
  /// readers. `laws` is null if it equals that of point 0.
  nlohmann::ordered_json finish(const Results& results, const GroundPictures& grounds);

 private:
  /// The point whose chunks are being shown. Only this point keeps rows.
  struct Open {
    Tracks tracks;
    Sensitivity sensitivity;
    Deposits deposits;
  };
  struct Closed {
    nlohmann::ordered_json tracks, sensitivity, deposits;
  };
  class Runouts;  ///< of one point
  void open_point();
  void close_point();

  const LoadedScenario& scenario_;
  std::vector<Closed> closed_;  ///< finished points
  std::vector<std::unique_ptr<Runouts>> runouts_;
  std::optional<Open> open_;
};

}  // namespace flyrock
