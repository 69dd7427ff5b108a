#pragma once
// Who is hit: the probability that at least one rock of a blast lands on a person, a vehicle or a roof.
//
// So small an area is hit in none of a thousand trials. So each landing is spread over a disc of radius R
// about it, with Epanechnikov's kernel K(s) = 2 / (pi R^2) (1 - s^2 / R^2). A rock then hits the area A at
// the distance s with the probability q = A K(s); on a line, A times the mean of K along it. In 2D a rock
// lands at the distance x from its release, somewhere on an arc of `spread` about it: q = A K1(s) / (spread
// x), with K1(s) = 3 / (4 R) (1 - s^2 / R^2). A blast hits with the mean over the trials of 1 - prod (1 -
// q_i) over their rocks; with weights between the bounds of results/statistics/blast_bounds.h, with h_i =
// q_i. Of a road with traffic, a blast hits a vehicle with the mean over the trials of the probability of
// results/risk/traffic.h.
//
// R is chosen as the distance of the 100th nearest landing, at most a tenth of the way from the mean release:
// the kernel then blurs a density that falls off over a third of the way by 1 % (R^2 / 12 times its
// Laplacian).

#include <cstdint>
#include <optional>
#include <vector>

#include "record/records.h"
#include "results/risk/traffic.h"
#include "results/statistics/blast_bounds.h"
#include "results/statistics/unknown.h"
#include "scenario/scenario.h"

namespace flyrock {

struct ExposureSummary {
  double radius = unknown;       ///< m
  std::uint64_t landings = 0;    ///< within the radius, with the energy that counts
  std::uint64_t trials = 0;      ///< with such a landing
  double hits_per_m2 = unknown;  ///< mean over the trials; of a line anywhere on it
  /// That at least one rock of a blast hits (`upper`, with the interval of rare_interval()): if someone is
  /// always there; with traffic a vehicle.
  BlastBounds per_blast = unknown_bounds;
  double road_hit = unknown;           ///< with traffic: that a rock lands on the strip of the vehicles
  double expected_vehicles = unknown;  ///< with traffic: the mean number of vehicles that a blast hits
  /// 1 - (1 - per_blast x occupied)^blasts_per_year; with traffic without `occupied`
  double per_year = unknown;
  Interval per_year_interval{unknown, unknown};
};

/// The interval of the mean of probabilities that are near 0 in most trials: that of a weighted sum of
/// Poisson counts, by gamma distributions (Fay and Feuer 1997), with the variance between trials. `sum` and
/// `squares` are sums of the probabilities over n trials, `greatest` the greatest that one event may add.
/// Without an event, the upper end is 3.0 greatest / n, of 95 % on one side.
Interval rare_interval(double sum, double squares, double greatest, std::uint64_t n, double confidence);

/// Computes the exposures of a scenario from rocks that are shown in passes; see read_in_passes().
class ExposureTally {
 public:
  explicit ExposureTally(const Scenario& scenario);
  void add(const TrialRecords& chunk);
  bool needs_another_pass();
  /// In the order of Scenario::exposures; `trials`: all of the run, also those without rocks.
  std::vector<ExposureSummary> summaries(std::uint64_t trials, Told told = Told::all) const;

 private:
  /// Sums of a probability over trials.
  struct Chances {
    double sum = 0, squares = 0;
    double greatest = 0;  ///< of a trial, or of the greatest event: a rock in the middle of the kernel
    void add(double chance);
  };
  /// Sums over the simulated rocks, and with the weights of the rocks: 1 - prod (1 - q)^w.
  struct Hits {
    Chances simulated, weighted;
    void add(double of_simulated, double of_weighted);
    SimulatedBlasts blasts(std::uint64_t trials, const WeightRange& weights, const WeightRange& near) const;
  };
  /// Some rocks: all of them, or those of a group.
  struct RockSet {
    WeightRange weights, near;           ///< of all that landed, and of those near enough to hit
    Hits place, vehicle;                 ///< of the place or the road, and of traffic
    double covered = 0;                  ///< m, sum of VehicleHits::covered
    std::vector<CoveredRoad> road = {};  ///< with traffic: one, else none
    // Sums over the open trial:
    double log_missed = 0, weighted_log_missed = 0;  ///< sums of ln(1 - q) and of w ln(1 - q)
    bool has_landing = false;
    std::vector<StoneOnRoad> stones = {}, weighted_stones = {};
  };
  struct Exposed {
    ExposurePlan plan;
    double radius = 0;                 ///< m; 0: not known yet
    std::vector<double> nearest = {};  ///< m, a heap of the distances of the nearest landings
    std::uint64_t landings = 0, trials = 0;
    double density = 0;              ///< sum of w q / A
    std::vector<RockSet> sets = {};  ///< all rocks, then each group if there are several
  };

  void search(const RockRecord& rock);
  void count(const RockRecord& rock);
  static void count(RockSet& set, const RockRecord& rock, double chance,
                    const std::optional<StoneOnRoad>& on_road);
  void close_trial();
  static void close_trial(const ExposurePlan& plan, RockSet& set);
  void choose_radii();
  static BlastBounds vehicle_bounds(const ExposurePlan& plan, const RockSet& set, std::uint64_t trials);
  static void put_bounds(const Exposed& exposed, std::uint64_t trials, ExposureSummary& summary);

  int dimension_;
  std::vector<Exposed> exposed_;
  Vec2 releases_ = Vec2::Zero();  ///< m, sum over the landings
  std::uint64_t landings_ = 0;
  double heaviest_ = 1;      ///< weight of a rock
  std::uint64_t trial_ = 0;  ///< the open one
  enum class Stage { search, count, done } stage_ = Stage::search;
};

}  // namespace flyrock
