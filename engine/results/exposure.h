#pragma once
// Who is hit: the probability that at least one rock of a blast lands on a person, a vehicle or a roof.
//
// So small an area is hit in none of a thousand trials. So each landing is spread over a disc of radius R
// about it, with Epanechnikov's kernel K(s) = 2 / (pi R^2) (1 - s^2 / R^2). A rock then hits the area A at
// the distance s with the probability q = A K(s); on a line, A times the mean of K along it. In 2D a rock
// lands at the distance x from its release, somewhere on an arc of `spread` about it: q = A K1(s) / (spread
// x), with K1(s) = 3 / (4 R) (1 - s^2 / R^2). A trial hits with P = 1 - prod (1 - q_i)^w_i over its rocks,
// w_i their weights, and a blast with the mean of P over the trials.
//
// R is chosen as the distance of the 100th nearest landing, at most a tenth of the way from the mean release:
// the kernel then blurs a density that falls off over a third of the way by 1 % (R^2 / 12 times its
// Laplacian).

#include <cstdint>
#include <vector>

#include "record/records.h"
#include "results/sample.h"
#include "results/unknown.h"
#include "scenario/scenario.h"

namespace flyrock {

struct ExposureSummary {
  double radius = unknown;       ///< m
  std::uint64_t landings = 0;    ///< within the radius, with the energy that counts
  std::uint64_t trials = 0;      ///< with such a landing
  double hits_per_m2 = unknown;  ///< mean over the trials
  /// That at least one rock of a blast hits, if someone is always there, with the interval of
  /// rare_interval().
  double per_blast = unknown;
  Interval interval{unknown, unknown};
  /// 1 - (1 - per_blast x occupied)^blasts_per_year
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
  std::vector<ExposureSummary> summaries(std::uint64_t trials) const;

 private:
  struct Exposed {
    ExposurePlan plan;
    double radius = 0;                 ///< m; 0: not known yet
    std::vector<double> nearest = {};  ///< m, a heap of the distances of the nearest landings
    std::uint64_t landings = 0, trials = 0;
    double density = 0;           ///< sum of w q / A
    double log_missed = 0;        ///< of the open trial: sum of w ln(1 - q)
    bool has_landing = false;     ///< the open trial
    double sum = 0, squares = 0;  ///< of P over trials
    double greatest = 0;          ///< P, or that of the heaviest rock in the middle of the kernel
  };

  /// From a place in plan [m].
  double distance(const ExposurePlan& plan, const Vec2& place) const;
  /// q over the kernel: A, on a line A over its length [m], in 2D A over the arc at the distance `way` [m].
  double part_of_area(const ExposurePlan& plan, double way) const;
  /// K, its integral along the line, or K1.
  double kernel_at(const Exposed& exposed, const Vec2& landing) const;
  double kernel_peak(const Exposed& exposed) const;
  void search(const RockRecord& rock);
  void count(const RockRecord& rock);
  void close_trial();
  void choose_radii();

  int dimension_;
  std::vector<Exposed> exposed_;
  Vec2 releases_ = Vec2::Zero();  ///< m, sum over the landings
  std::uint64_t landings_ = 0;
  double heaviest_ = 1;      ///< weight of a rock
  std::uint64_t trial_ = 0;  ///< the open one
  enum class Stage { search, count, done } stage_ = Stage::search;
};

}  // namespace flyrock
