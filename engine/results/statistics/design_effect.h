#pragma once
// What rocks of one trial have in common. They share its draws, so n rocks say less than n independent ones.
//
// The design effect of a number is its variance, with the trial as the unit, over that of as many independent
// rocks. Of m trials, trial t has n_t rocks of which k_t count: the share p = sum k_t / sum n_t has the
// variance m / (m - 1) sum (k_t - p n_t)^2 / N^2 with N = sum n_t (linearised ratio), and independent rocks
// p (1 - p) / N. Sources: Kish 1965, Survey Sampling; Korn and Graubard 1998, Confidence intervals for
// proportions with small expected number of positive counts estimated from survey data.
//
// Rocks may have weights, the number of real rocks that each stands for. n_t and k_t are then sums of
// weights, and unequal weights add to the design effect: n rocks of one trial each say as much as (sum w)^2 /
// sum w^2 of equal weight (Kish). Equal weights change nothing.

#include <algorithm>
#include <cstdint>
#include <limits>

namespace flyrock {

/// An interval needs so many trials beyond its number.
inline constexpr std::uint64_t least_trials = 10;

/// Rocks and the sum of their weights.
struct Weighed {
  std::uint64_t count = 0;
  double weight = 0;

  void add(double w) {
    ++count;
    weight += w;
  }
};

/// The least and the greatest weight of some rocks.
class WeightRange {
 public:
  void add(double weight) {
    least_ = std::min(least_, weight);
    greatest_ = std::max(greatest_, weight);
  }
  bool any_rock() const { return least_ <= greatest_; }
  double least() const { return least_; }  ///< infinite without a rock
  double greatest() const { return greatest_; }
  bool differ() const { return least_ < greatest_; }
  /// Whether a rock stands for more or less than itself.
  bool any() const { return differ() || (least_ == greatest_ && least_ != 1); }

 private:
  double least_ = std::numeric_limits<double>::infinity(), greatest_ = -least_;
};

/// Sums over trials. Those of counts have the same value in any order.
class TrialCounts {
 public:
  /// A trial with n rocks, of which k count.
  void add(const Weighed& n, const Weighed& k);
  void add(std::uint64_t n, std::uint64_t k) {
    add(Weighed{n, static_cast<double>(n)}, Weighed{k, static_cast<double>(k)});
  }
  /// From now on its numbers are those of weights. To be called where the weights differ.
  void weigh() { is_weighted_ = true; }

  std::uint64_t rocks() const { return n_; }
  std::uint64_t counted() const { return k_; }
  std::uint64_t trials() const { return trials_; }     ///< with at least one rock
  std::uint64_t trials_with() const { return with_; }  ///< with at least one rock that counts
  /// The trials with a rock that counts, and with one that does not; with weights at most as many as trials
  /// of equal weight that say as much.
  double evidence_with() const;
  double evidence_without() const;
  /// The same of all trials.
  double effective_trials() const;
  /// Some trial has several rocks, or their weights differ.
  bool is_by_trial() const { return n_ > trials_ || is_weighted_; }
  double share() const { return sums().k / sums().n; }

  /// The design effect of the share, at least 1. Where fewer than least_trials trials have a rock that
  /// counts, or one that does not, they cannot show what rocks have in common: then that of trials whose
  /// rocks all do the same, N / m.
  double design_effect() const;
  /// The number of independent rocks that say as much: rocks / design effect, times the squared ratio of
  /// Student's t at this confidence with rocks - 1 and d - 1 degrees of freedom. d is the number of trials
  /// with a rock that counts, or with one that does not, whichever is less: the others say nothing about how
  /// rocks go together.
  double effective_size(double confidence) const;

 private:
  /// Sums over trials of n_t, k_t, n_t^2, k_t n_t, k_t^2.
  struct Sums {
    double n = 0, k = 0, nn = 0, kn = 0, kk = 0;
    void add(double n_t, double k_t);
  };
  const Sums& sums() const { return is_weighted_ ? weights_ : counts_; }

  std::uint64_t n_ = 0, k_ = 0, trials_ = 0, with_ = 0, without_ = 0;
  Sums counts_, weights_;
  bool is_weighted_ = false;
};

/// The trials that it takes until least_trials of them have what `with` of `trials` have; 0 if they have.
std::uint64_t trials_needed(double with, std::uint64_t trials);

}  // namespace flyrock
