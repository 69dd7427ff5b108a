#pragma once
// Measures: named numbers that expectations can be about.

#include <string>
#include <vector>

#include "batch/terrain_picture.h"
#include "results/compare/observation.h"
#include "results/measured/block_summary.h"
#include "results/measured/censored.h"
#include "results/measured/clearance.h"
#include "results/measured/contact_measure.h"
#include "results/measured/crossing_summary.h"
#include "results/measured/link_measure.h"
#include "results/measured/plan_reach.h"
#include "results/measured/reach.h"
#include "results/measured/region_measure.h"
#include "results/measured/runout_by_azimuth.h"
#include "results/measured/stressed_block.h"
#include "results/risk/exposure.h"
#include "results/risk/risk.h"

namespace flyrock {

struct OuterSummary;

/// Percentiles of the diameters of rocks [m], of the sphere with the rock's volume; NaN without rocks.
struct Diameters {
  double p5 = unknown, p50 = unknown;
};

/// The results of one sweep point as numbers. Its rows are read in passes (record/rows.h).
struct PointResult {
  std::uint64_t trials = 0;
  TerrainPicture terrain;                  ///< of its first trial, for pictures
  Diameters diameters;                     ///< 3D, of rocks of all groups
  PlanReach reach;                         ///< 3D: where its rocks were
  std::vector<RockRecord> first_trial;     ///< rocks of the first trial of this run
  Series series;                           ///< of the first trial of this run, without meshes
  std::vector<StressedBlock> stressed;     ///< the deformable bodies of that trial
  TrialTotals totals;                      ///< without maps
  MapRasters maps;                         ///< 3D
  std::vector<GroupSummary> groups;        ///< all rocks first, then the groups; see RockTally
  std::vector<CrossingSummary> crossings;  ///< in the order of `groups`
  std::optional<TreeSummary> trees;        ///< with a forest
  std::optional<BlockSummary> blocks;      ///< of rock that joints have cut
  std::shared_ptr<const Forest> forest;    ///< its stems, counted from the origin; null: none
  std::vector<ClearanceSummary> clearances;
  std::vector<ExposureSummary> exposures;
  RiskSummary risk;                               ///< with measured holes or branches
  std::vector<LaunchReach> reaches;               ///< only with the method ballistic
  std::vector<RunoutByAzimuth> azimuths;          ///< 3D, of rocks: in the order of `groups`
  std::optional<ObservationSummary> observation;  ///< where the scenario has `observed`
  std::vector<CensoredPlace> censored;            ///< places of censored rocks, most rocks first
  std::shared_ptr<const OuterSummary> outer;      ///< with several runs; null: one run
};

struct Measured {
  double value = 0;
  bool censored = false;  ///< a lower bound, because censored rocks fall into it
  std::string fault;      ///< why there is no value: "never came to rest"
};

/// One measure of a scenario, given by its name: body.<name>.final.x, body.<name>.impact[2].vn_after,
/// body.<name>.tension_1pct.max, contact.<a>.<b>.rn.max, energy.total.relative_change, solver.max_residual,
/// rocks[.<group>].runout.p95, rocks[.<group>].count, gate.<name>.passed, barrier.<name>.caught,
/// trees.stopped, clearance.<name>.distance, exposure.<name>.per_blast. scenario/measure.h holds the grammar;
/// docs/results.md describes each measure.
class Measure {
 public:
  /// `name` must be a measure of `scenario`; the decoder has checked it.
  Measure(const std::string& name, const Scenario& scenario);

  /// Whether it needs the full number of trials, as statistics of rocks do.
  bool of_rocks() const {
    return kind_ != Kind::body && kind_ != Kind::stress && kind_ != Kind::assembly &&
           kind_ != Kind::contact && kind_ != Kind::link && kind_ != Kind::region && kind_ != Kind::energy &&
           kind_ != Kind::solver;
  }
  Measured value(const PointResult& result) const;
  /// The interval beside the value; NaN if there is none.
  Interval interval(const PointResult& result) const;

 private:
  enum class Kind {
    statistic,
    count,
    censored,
    gate,
    barrier,
    trees,
    clearance,
    exposure,
    body,
    stress,
    assembly,
    contact,
    link,
    region,
    energy,
    solver
  };

  void read_rocks(const std::vector<std::string>& words, const Scenario& scenario);
  void read_share(const std::vector<std::string>& words);
  void read_body(const std::vector<std::string>& words, const Scenario& scenario);
  void read_contact(const std::vector<std::string>& words);
  void read_link(const std::vector<std::string>& words);
  void read_region(const std::vector<std::string>& words);
  static Measured solver_value(const PointResult& result, const std::string& field);
  Measured gate_value(const GateSummary& gate) const;
  Measured barrier_value(const BarrierSummary& barrier) const;
  static Measured trees_value(const TreeSummary& trees, const std::string& field);
  static Measured clearance_value(const ClearanceSummary& clearance, const std::string& field);
  static Measured exposure_value(const ExposureSummary& exposure, const std::string& field);
  Measured body_value(const BodyHistory& body) const;
  double assembly_value(const TrialTotals& totals) const;
  double state_value(const BodyHistory& body) const;
  double value_of(const BodyState& state) const;
  Measured stress_value(const std::vector<SeriesStress>& rows) const;

  Kind kind_ = Kind::statistic;
  int index_ = 0;   ///< of the group (0: all rocks), gate, barrier, clearance, exposure or body
  int number_ = 0;  ///< of an impact or apex, from 1
  int dimension_ = 2;
  std::string body_;   ///< of a stress: its name
  std::string table_;  ///< body: final, max, min, stop_time, contact_time, impact, apex
  std::string field_;  ///< x, vn_before, max_residual
  ContactMeasure contact_;
  LinkMeasure link_;
  RegionMeasure region_;
  std::size_t quantity_ = 0;  ///< of rock_statistics
  Statistic statistic_ = Statistic::mean;
  std::vector<bool> moves_;                 ///< of an assembly: which bodies of the scenario
  Share Shares::*sense_ = &Shares::of_all;  ///< of a gate or barrier
};

}  // namespace flyrock
