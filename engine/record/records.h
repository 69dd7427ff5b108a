#pragma once
// The records of a trial. Chunks, tables and the report are made of them.

#include <cstdint>
#include <string>
#include <vector>

#include "record/block_row.h"
#include "record/envelope.h"
#include "record/last_state.h"
#include "record/maps.h"
#include "record/material_use.h"
#include "record/observe.h"
#include "record/phase_times.h"
#include "record/scenery.h"
#include "record/series.h"

namespace flyrock {

/// One rock (or one moving body of `bodies`), as in rocks.csv. docs/results.md describes the columns.
struct RockRecord {
  std::uint64_t trial = 0;
  int rock = 0;       ///< number in its trial, from 0
  int group = 0;      ///< index into the groups of the scenario (or its moving bodies)
  int hole = 0;       ///< from 0, in the blast; 0 without a blast
  int branch = 0;     ///< what became of its hole or blast, index into branch_names(); 0: regular
  double weight = 1;  ///< the number of real rocks that it stands for
  double mass = 0, volume = 0;
  double launch_speed = 0, launch_elevation = 0;  ///< m/s, rad
  StopReason reason = StopReason::timed_out;
  bool censored = false;  ///< left_domain or timed_out: its distances are lower bounds
  /// The gates and barriers, a bit for each, at which it can no longer arrive although it is censored
  /// (flight/decided.h).
  std::uint64_t decided_gates = 0, decided_barriers = 0;
  double start_x = 0, start_y = 0;  ///< centre of mass at its release
  double runout = 0;                ///< |x_stop - x_release|
  double max_distance = 0;
  double stop_x = 0, stop_y = 0, stop_z = 0;
  double end_energy = 0;  ///< kinetic, J, with which its path ends
  int end_part = -1;      ///< timed_out: the part of the terrain that it was on; -1: it was in the air
  bool landed = false;    ///< it flew and has touched the terrain since: its flight range is known
  double flight_range = 0;
  double bounce_height = 0;
  double max_speed = 0;
  double max_energy = 0;  ///< kinetic, J
  int impacts = 0;
  double time = 0;    ///< s, from its start until it came to rest or its path ended
  Travel travel;      ///< path in that time, by mode of motion
  std::string fault;  ///< why the rock failed; empty if it did not
};

bool is_fault(StopReason reason);

/// What begins a row that belongs to a rock.
struct OfRock {
  std::uint64_t trial = 0;
  int rock = 0;
};

/// One drawn number of one rock. `input` is its index in the list of batch/inputs.h.
struct InputRecord : OfRock {
  int input = 0;
  int impact = 0;  ///< for which it was drawn, as in the rock's impacts; 0: for the rock
  double value = 0;
};

struct ImpactRecord : OfRock {
  Impact impact;
};

struct TrajectoryRecord : OfRock {
  TrajectoryPoint point;
};

/// A corner of the surface of a rock with a stored trajectory.
struct ShapeRecord : OfRock {
  SurfaceCorner corner;
};

struct GateRecord : OfRock {
  Passage passage;
};

struct BarrierRecord : OfRock {
  BarrierHit hit;
};

struct TreeRecord : OfRock {
  TreeHit hit;
};

struct LastStateRecord : OfRock {
  int group = 0;  ///< as in its RockRecord
  LastState last;
};

/// A row of a trial: BlockRow, BlockRegionRow, BlockCorner, Fixture, FixtureCorner, SeriesBody,
/// SeriesContact, SeriesLink, SeriesRegion, SeriesSolve, SeriesStress, SeriesNode or SeriesCell.
template <class Row>
struct TrialRow {
  std::uint64_t trial = 0;
  Row row;
};

/// Counts and sums over trials. They take no more memory for many trials than for one.
struct TrialTotals {
  std::vector<MaterialUse> materials;  ///< in the order of Scenario::materials
  Envelopes envelopes;                 ///< of rocks without faults
  Maps maps;                           ///< 3D, of rocks without faults
  SolverQuality quality;
  PhaseTimes times;
  std::vector<std::string> notes;   ///< distinct notes of launches ("v0^2 < 0: ..."), at most 20
  std::vector<BodyHistory> bodies;  ///< `bodies` scenarios: the last trial's histories, for measures

  /// Adds the totals of later trials.
  void add(const TrialTotals& later);
  void add_note(const std::string& note);
};

/// All records of consecutive trials of one point: rows, in the order of trials and rocks, and totals.
struct TrialRecords {
  std::vector<RockRecord> rocks;
  std::vector<InputRecord> inputs;
  std::vector<ImpactRecord> impacts;
  std::vector<TrajectoryRecord> trajectories;
  std::vector<ShapeRecord> shapes;
  std::vector<GateRecord> gates;
  std::vector<BarrierRecord> barriers;
  std::vector<TreeRecord> trees;
  std::vector<LastStateRecord> last_states;  ///< of `bodies` scenarios
  std::vector<TrialRow<BlockRow>> blocks;
  std::vector<TrialRow<BlockRegionRow>> block_regions;
  std::vector<TrialRow<BlockCorner>> block_corners;
  std::vector<TrialRow<DrawnLink>> links;
  std::vector<TrialRow<Fixture>> fixtures;
  std::vector<TrialRow<FixtureCorner>> fixture_shapes;
  std::vector<TrialRow<SeriesBody>> series_bodies;
  std::vector<TrialRow<SeriesContact>> series_contacts;
  std::vector<TrialRow<SeriesLink>> series_links;
  std::vector<TrialRow<SeriesRegion>> series_regions;
  std::vector<TrialRow<SeriesSolve>> series_solves;
  std::vector<TrialRow<SeriesStress>> series_stress;
  std::vector<TrialRow<SeriesNode>> series_nodes;
  std::vector<TrialRow<SeriesCell>> series_cells;
  TrialTotals totals;
};

}  // namespace flyrock
