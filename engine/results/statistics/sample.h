#pragma once
// A sample of numbers, some of them censored: its quantiles, its mean and their confidence intervals. The
// numbers are not kept; they are shown in passes, see results/statistics/selection.h. The numbers of one
// trial depend on each other: where a trial has several, intervals take the trial as their unit
// (results/statistics/design_effect.h).
//
// Where the weights of the numbers differ, a mean is sum w x / sum w, and the quantile p is the least number
// for which the numbers up to it have more than p of the weight; intervals take the trial as their unit.

#include <cstdint>
#include <limits>
#include <vector>

#include "results/statistics/design_effect.h"
#include "results/statistics/selection.h"
#include "results/statistics/unknown.h"

namespace flyrock {

/// A number that may be affected by censored rocks. It is then a lower bound (a standard deviation is then
/// only unknown). NaN if there are too few rocks.
struct Bounded {
  double value = 0;
  bool censored = false;
};

/// The confidence of all intervals of a summary.
inline constexpr double stated_confidence = 0.95;

/// A confidence interval. An end is NaN if the sample does not give it: the sample is too small, or censored
/// values reach this end.
struct Interval {
  double lower = 0, upper = 0;
  double design_effect = 1;         ///< results/statistics/design_effect.h
  std::uint64_t trials_needed = 0;  ///< too few trials lie beyond the number: about how many it takes
};

inline constexpr Bounded unknown_number{unknown, false};
inline constexpr Interval unknown_interval{unknown, unknown, unknown, 0};

/// Mean and standard deviation of the sample, sqrt(sum (x - mean)^2 / (n - 1)); with weights
/// sqrt(n / (n - 1) sum w (x - mean)^2 / sum w). NaN if there are too few numbers.
struct Moments {
  double mean = 0, sd = 0;
};

/// The questions that a sample must answer. They are needed in advance, because the passes look only for the
/// order statistics of these questions.
struct Questions {
  struct IntervalOf {
    double p, confidence;
  };
  std::vector<double> quantiles;      ///< p from 0 to 1
  std::vector<IntervalOf> intervals;  ///< of quantiles
  /// The trials are replicates of a design (random/sampling.h): their scatter is the error of the mean, also
  /// where it is less than that of independent numbers.
  bool are_replicates = false;
};

/// x_0 <= ... <= x_{n-1}. Among equal values, known ones come before censored ones.
class Sample {
 public:
  explicit Sample(Questions questions = {}) : questions_(std::move(questions)) {}
  /// Other questions, before the first pass ends.
  void ask(Questions questions) { questions_ = std::move(questions); }

  /// Adds a number of a trial. Every pass needs the same order, because sums depend on it; the numbers of a
  /// trial follow each other.
  void add(const Bounded& value, std::uint64_t trial, double weight = 1);
  /// Ends a pass. Returns whether the sample needs another one.
  bool needs_another_pass();

  std::uint64_t size() const { return count_; }
  /// The least and the greatest number, after the first pass; infinite without any.
  double least() const { return least_; }
  double greatest() const { return greatest_; }
  bool any_censored() const { return least_censored_ < none; }
  Moments moments() const;

  /// Linear interpolation between the order statistics at h = (n - 1) p, as in NumPy and PERCENTILE.INC of
  /// spreadsheets: x_floor(h) + (h - floor(h)) (x_floor(h)+1 - x_floor(h)). Exact if every censored bound
  /// comes later in the order than the order statistics used here, because then the true values of censored
  /// rocks cannot change them. Otherwise a lower bound. NaN for an empty sample.
  Bounded quantile(double p) const;

  /// The interval of the quantile p from order statistics; it holds for any distribution of the values. The
  /// number of values below the quantile is binomial B(n, p). Therefore [x_(l), x_(u)], counted from 1,
  /// contains the quantile with at least this confidence, with the greatest l for which P(B < l) <= (1 -
  /// confidence) / 2 and the least u for which P(B >= u) <= (1 - confidence) / 2. Source: David and Nagaraja
  /// 2003, Order Statistics, 7.1. A censored bound is valid as the lower end, because it is below the true
  /// value; as the upper end it is not.
  ///
  /// Where trials have several numbers, or weights, the interval is that of Woodruff: the quantiles at the
  /// ends of the interval of Clopper and Pearson for the share p of as many independent numbers as say the
  /// same, effective_size(). It needs least_trials trials with a number beyond the quantile. Source: Woodruff
  /// 1952, Confidence intervals for medians and other position measures.
  Interval quantile_interval(double p, double confidence) const;

  /// The interval of the mean: mean -+ t sd / sqrt(n), Student's t with n - 1 degrees of freedom. It is valid
  /// for many values; fewer suffice if the tails are light. Not given for one value, or if any value is
  /// censored. Where trials have several numbers, mean -+ t sqrt(m / (m - 1) sum (S_t - mean n_t)^2) / n with
  /// m - 1 degrees of freedom, of least_trials trials or more; trial t has n_t numbers of sum S_t. With
  /// weights n_t and n are sums of weights, S_t of w x, and the degrees of freedom are those of m' trials of
  /// equal weight, m' = n^2 / sum n_t^2 (Kish).
  Interval mean_interval(double confidence) const;

 private:
  static constexpr double none = std::numeric_limits<double>::infinity();

  /// The passes of each stage see all numbers.
  enum class Stage {
    first,      ///< number, sum and range: one pass
    quantiles,  ///< order statistics of the quantiles, and squares: until they are found
    shares,     ///< how many numbers of each trial do not exceed a quantile: one pass
    ends,       ///< order statistics of the ends of intervals
    done
  };

  /// An interval that is asked for. In clustered samples `quantile` splits the numbers of each trial.
  struct Asked {
    double quantile = 0;
    bool upper_tail = true;       ///< the numbers beyond are those not less than it; else those not greater
    TrialCounts before;           ///< numbers less than the quantile; in the lower tail those not greater
    Weighed in_trial;             ///< of the open trial
    double lower = 0, upper = 0;  ///< ranks of the ends, from 0
    double design_effect = 1;
    std::uint64_t trials_needed = 0;
  };

  void add_first(const Bounded& value, double weight);
  void add_square(const Bounded& value, double weight);
  void end_trial();
  bool is_by_trial() const { return is_clustered_ || is_weighted_; }
  /// Number of the sample, or the sum of its weights.
  double total() const { return is_weighted_ ? weight_ : static_cast<double>(count_); }
  /// Ranks of the order statistics that a quantile needs: x_low, and this share of the way to x_low+1.
  struct Rank {
    double low, share;
  };
  Rank rank_of(double p) const;
  std::vector<double> quantile_ranks() const;
  std::vector<double> end_ranks() const;
  void find_exact_ends();
  void find_clustered_ends();

  Questions questions_;
  Stage stage_ = Stage::first;
  bool squared_ = false;  ///< the first pass after `first` is done
  // Found in the first pass:
  std::uint64_t count_ = 0, trials_ = 0;
  bool is_clustered_ = false;  ///< some trial has several numbers
  bool is_weighted_ = false;   ///< their weights differ
  WeightRange weights_;
  double weight_ = 0;  ///< of all
  double sum_ = 0, weighted_sum_ = 0, least_ = none, greatest_ = -none, least_censored_ = none;
  // Found in the second pass:
  double squares_ = 0;         ///< of the deviations from the mean
  double trial_squares_ = 0;   ///< of their sums over each trial
  double weight_squares_ = 0;  ///< of the weights of each trial
  double first_censored_ = 0;  ///< its rank
  // The open trial:
  std::uint64_t trial_ = 0;
  Weighed in_trial_;
  double deviation_ = 0;

  std::vector<Asked> asked_;  ///< of questions_.intervals
  Selection quantiles_, ends_;
};

/// A sample of numbers that are already in memory, each of a trial of its own.
Sample sample_of(const std::vector<Bounded>& values, const Questions& questions);

}  // namespace flyrock
