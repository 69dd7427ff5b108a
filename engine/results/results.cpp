#include "results/results.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "load/hard_contacts.h"
#include "math/sphere.h"
#include "results/measured/measure_tally.h"
#include "results/measured/outer.h"
#include "results/say/alarms.h"
#include "scenario/normalise.h"
#include "scenario/plan.h"

namespace flyrock {

namespace {

constexpr std::size_t faults_kept = 20;

}  // namespace

/// Computes the results of one sweep point.
class PointTally {
 public:
  PointTally(const Scenario& scenario, int point)
      : scenario_(scenario),
        point_(point),
        measures_(scenario),
        risk_(scenario),
        azimuths_(scenario.dimension == 3 && scenario.bodies.empty() ? 1 + scenario.rocks.size() : 0),
        seeks_azimuths_(!azimuths_.empty()) {
    if (scenario.observed) simulated_.emplace(scenario);
  }

  /// Takes the rows of the first pass. Their faults go into `results`.
  void see_first(const TrialRecords& chunk, Results& results) {
    result_.totals.add(chunk.totals);
    if (scenario_.dimension == 3) result_.reach.add(chunk);
    if (simulated_) simulated_->add(chunk);
    keep_series(chunk);
    for (const RockRecord& rock : chunk.rocks) {
      if (result_.first_trial.empty() || rock.trial == result_.first_trial.front().trial)
        result_.first_trial.push_back(rock);
      censored_.add(rock);
      if (!is_fault(rock.reason)) continue;
      ++results.fault_count;
      if (results.faults.size() < faults_kept)
        results.faults.push_back({point_, rock.trial, rock.rock, rock.reason, rock.fault});
    }
    add(chunk);
  }

  /// Keeps the series of the first trial, for measures and pictures.
  void keep_series(const TrialRecords& chunk) {
    for (const auto& [trial, row] : chunk.series_links)
      if (trial == chunk.series_links.front().trial && !series_is_known_) result_.series.links.push_back(row);
    for (const auto& [trial, row] : chunk.series_regions)
      if (trial == chunk.series_regions.front().trial && !series_is_known_)
        result_.series.regions.push_back(row);
    for (const auto& [trial, row] : chunk.series_contacts)
      if (trial == chunk.series_contacts.front().trial && !series_is_known_)
        result_.series.contacts.push_back(row);
    for (const auto& [trial, row] : chunk.series_solves)
      if (trial == chunk.series_solves.front().trial && !series_is_known_)
        result_.series.solves.push_back(row);
    for (const auto& [trial, row] : chunk.series_stress)
      if (trial == chunk.series_stress.front().trial && !series_is_known_)
        result_.series.stresses.push_back(row);
    if (!series_is_known_) result_.stressed = most_stressed(chunk);
    series_is_known_ = series_is_known_ || !chunk.series_solves.empty();
  }

  void add(const TrialRecords& chunk) {
    measures_.add(chunk);
    risk_.add(chunk);
    if (!seeks_azimuths_) return;
    for (const RockRecord& rock : chunk.rocks) {
      if (is_fault(rock.reason)) continue;
      diameters_.add({2 * sphere_radius(rock.volume), false}, rock.trial, rock.weight);
      const std::optional<std::size_t> sector = azimuth_sector_of(rock);
      azimuths_.front().add(rock, sector);
      azimuths_.at(1 + static_cast<std::size_t>(rock.group)).add(rock, sector);
    }
  }

  std::vector<RunoutExtent> runout_extents() const { return measures_.runout_extents(); }

  bool needs_another_pass() {
    bool more = measures_.needs_another_pass();
    more |= risk_.needs_another_pass(measures_.clearance_distances());
    if (!seeks_azimuths_) return more;
    seeks_azimuths_ = diameters_.needs_another_pass();
    for (AzimuthTally& azimuths : azimuths_) seeks_azimuths_ |= azimuths.needs_another_pass();
    return more || seeks_azimuths_;
  }

  /// The first pass has ended. Rasters take less memory than the histograms that they are made of.
  void end_first() {
    if (result_.totals.maps.grid().empty()) return;
    result_.maps = rasters_of(result_.totals.maps);
    result_.totals.maps = {};
  }

  /// `trials`: all that ran.
  PointResult result(std::uint64_t trials) {
    end_first();
    if (scenario_.method == Method::ballistic) result_.maps.find_hit_density(trials);
    const Told told = measures_.told();
    measures_.put(result_, trials);
    result_.risk = risk_.summary();
    result_.censored = censored_.places();
    if (simulated_)
      result_.observation = compare(*scenario_.observed, simulated_->result(), scenario_.streams.seed);
    if (diameters_.size() > 0)
      result_.diameters = {diameters_.quantile(0.05).value, diameters_.quantile(0.5).value};
    for (std::size_t g = 0; g < result_.groups.size() && g < azimuths_.size(); ++g)
      result_.azimuths.push_back(azimuths_[g].summary(told));
    if (scenario_.method == Method::ballistic && told == Told::all)
      result_.reaches = reaches_of(scenario_, result_.groups);
    return std::move(result_);
  }

 private:
  const Scenario& scenario_;
  int point_;
  PointResult result_;
  bool series_is_known_ = false;
  MeasureTally measures_;
  RiskTally risk_;
  Sample diameters_{Questions{{0.05, 0.5}, {}}};
  std::vector<AzimuthTally> azimuths_;  ///< of all rocks, then of each group
  bool seeks_azimuths_;                 ///< they, or diameters_, need another pass
  std::optional<SimulatedTally> simulated_;
  CensoredTally censored_;
};

namespace {

constexpr double most_sunk = 0.1;  ///< share of the size

/// The size of the smallest rock of all points [m]; infinite if there is none.
double least_size_of_all(const std::vector<PointResult>& points) {
  double least = infinite;
  for (const PointResult& point : points) least = std::min(least, least_size(point));
  return least;
}

std::vector<std::string> solver_warnings(const Plan& plan, const std::vector<PointResult>& points) {
  std::vector<std::string> warnings;
  SolverQuality quality;
  for (const PointResult& point : points) quality.add(point.totals.quality);
  if (quality.not_converged > 0)
    warnings.push_back(
        fmt::format("solver: {} of {} contact problems did not converge; relative to the approach speed "
                    "their greatest residual is {:.2g}, solver.tolerance is {:.2g}",
                    quality.not_converged, quality.problems, quality.not_converged_residual,
                    plan.points.front().solver.tolerance));
  if (quality.energy_gains > 0)
    warnings.push_back(fmt::format("solver: {} impact{} or step{} gained energy, {:.3g} J together",
                                   quality.energy_gains, quality.energy_gains == 1 ? "" : "s",
                                   quality.energy_gains == 1 ? "" : "s", quality.energy_gained));
  if (quality.gains_by_slip > 0)
    warnings.push_back(
        fmt::format("solver: {} impact{} gained energy because slip ended or reversed, {:.3g} J together: "
                    "a property of the "
                    "form `newton` with friction; `poisson`, `energy` and `newton_mean` do not gain",
                    quality.gains_by_slip, quality.gains_by_slip == 1 ? "" : "s", quality.gained_by_slip));
  if (quality.endless_impacts > 0)
    warnings.push_back(fmt::format(
        "solver: {} instant{} had more than 1,000 impacts; after them the bodies that touched there "
        "had no restitution (e = 0)",
        quality.endless_impacts, quality.endless_impacts == 1 ? "" : "s"));
  if (quality.shocks > 0)
    warnings.push_back(
        fmt::format("solver: {} shock{} without collision: a sliding contact jammed and its velocity jumped "
                    "within one step (Painlevé's paradox); each has a row among the impacts",
                    quality.shocks, quality.shocks == 1 ? "" : "s"));
  if (const double size = least_size_of_all(points); quality.max_penetration > most_sunk * size)
    warnings.push_back(
        fmt::format("solver: a rock sank {:.3g} m into the ground or into another rock; the smallest rock is "
                    "{:.3g} m across. "
                    "Use a shorter solver.time_step, or a stiffer spring (`penalty`)",
                    quality.max_penetration, size));
  if (quality.max_spring_angle > inaccurate_spring)
    warnings.push_back(fmt::format(
        "solver: a spring (`penalty`) swings by {:.4g} deg in a step: bounces are inaccurate above {:.3g} "
        "and gain energy above {:.3g}. Use a shorter solver.time_step or a softer spring",
        quality.max_spring_angle * 180 / pi, inaccurate_spring * 180 / pi, unstable_spring * 180 / pi));
  return warnings;
}

/// The notes of launches, each once, because a launch may have the same problem at every point.
std::vector<std::string> launch_notes(const std::vector<PointResult>& points) {
  std::vector<std::string> list;
  std::set<std::string> notes;
  for (const PointResult& point : points)
    for (const std::string& note : point.totals.notes)
      if (notes.insert(note).second) list.push_back(note);
  return list;
}

}  // namespace

std::uint64_t Results::rocks() const {
  std::uint64_t sum = 0;
  for (const PointResult& point : points) sum += point.groups.front().count;
  return sum;
}

int Results::count(Judgement judgement) const {
  return static_cast<int>(std::count_if(verdicts.begin(), verdicts.end(), [&](const Verdict& verdict) {
    return verdict.judgement == judgement;
  }));
}

namespace {

/// The tally of a point after its first pass, and another reader, which has seen nothing yet.
class Together {
 public:
  Together(std::size_t point, PointTally& tally, const ReaderOfPoint& reader)
      : tally_(tally),
        tally_is_open_(tally.needs_another_pass()),
        other_(reader ? reader(point, tally.runout_extents()) : nullptr) {}

  bool is_open() const { return tally_is_open_ || other_; }
  void add(const TrialRecords& chunk) {
    if (tally_is_open_) tally_.add(chunk);
    if (other_) other_->add(chunk);
  }
  bool needs_another_pass() {
    tally_is_open_ = tally_is_open_ && tally_.needs_another_pass();
    if (other_ && !other_->needs_another_pass()) other_ = nullptr;
    return is_open();
  }

 private:
  PointTally& tally_;
  bool tally_is_open_;
  RowReader* other_;
};

}  // namespace

ResultTally::ResultTally(const Plan& plan) : plan_(plan) {
  for (const Scenario& point : plan.points) tallies_.emplace_back(point, static_cast<int>(tallies_.size()));
}

ResultTally::~ResultTally() = default;

void ResultTally::add(int point, const TrialRecords& chunk) {
  const auto at = static_cast<std::size_t>(point);
  if (at > 0) tallies_.at(at - 1).end_first();
  tallies_.at(at).see_first(chunk, results_);
}

Results ResultTally::finish(const std::vector<Rows>& rows, const RunFacts& facts,
                            const ReaderOfPoint& reader) {
  for (std::size_t p = 0; p < tallies_.size(); ++p) {
    Together together(p, tallies_[p], reader);
    if (together.is_open()) read_in_passes(rows.at(p), together);
    results_.points.push_back(tallies_[p].result(facts.trials.at(p)));
    PointResult& point = results_.points.back();
    const Scenario& scenario = plan_.points[p];
    if (scenario.outer > 1 && point.trials == scenario.trials)
      point.outer = std::make_shared<const OuterSummary>(
          make_outer(scenario, measure_names(Node::root(plan_.resolved), scenario.dimension), rows.at(p),
                     point.exposures));
  }
  results_.verdicts = judge(plan_, results_.points, facts.full && facts.ended_early.empty());
  results_.differences = make_differences(plan_, results_.points, rows);
  if (plan_.points.front().answer) results_.best = find_best_point(plan_, results_.points);
  results_.warnings = solver_warnings(plan_, results_.points);
  for (const std::vector<std::string>& list : {facts.warnings, launch_notes(results_.points)})
    results_.warnings.insert(results_.warnings.end(), list.begin(), list.end());
  if (!plan_.all_end_at_landing()) results_.not_asked = laws_never_asked(plan_, results_.points);
  results_.ended_early = facts.ended_early;
  return std::move(results_);
}

Results make_results(const Plan& plan, const std::vector<Rows>& rows, const RunFacts& facts,
                     const ReaderOfPoint& reader) {
  ResultTally tally(plan);
  for (std::size_t p = 0; p < rows.size(); ++p)
    rows[p](Part::whole, [&](const TrialRecords& chunk) { tally.add(static_cast<int>(p), chunk); });
  return tally.finish(rows, facts, reader);
}

std::vector<std::string> laws_never_asked(const Plan& plan, const std::vector<PointResult>& points) {
  std::vector<std::string> warnings;
  const std::vector<Material>& materials = plan.points.front().materials;
  for (std::size_t m = 0; m < materials.size(); ++m) {
    MaterialUse use;
    for (const PointResult& point : points)
      if (m < point.totals.materials.size()) use.add(point.totals.materials[m]);
    if (use.contacts == 0) {
      warnings.push_back(
          fmt::format("material {}: nothing touched it, none of its laws was asked", materials[m].name));
      continue;
    }
    const auto note = [&](const std::optional<PluginUse>& law, std::uint64_t asked, std::string_view kind) {
      if (law && asked == 0)
        warnings.push_back(fmt::format("material {}: its {} {} was never asked", materials[m].name, kind,
                                       law->plugin->spec.name));
    };
    note(materials[m].restitution, use.restitution, "restitution");
    note(materials[m].friction, use.friction, "friction");
    note(materials[m].rolling, use.rolling, "rolling");
    note(materials[m].unilateral, use.unilateral, "unilateral");
  }
  return warnings;
}

}  // namespace flyrock
