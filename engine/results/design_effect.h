#pragma once
// What rocks of one trial have in common. They share its draws, so n rocks say less than n independent ones.
//
// The design effect of a number is its variance, with the trial as the unit, over that of as many independent
// rocks. Of m trials, trial t has n_t rocks of which k_t count: the share p = sum k_t / sum n_t has the
// variance m / (m - 1) sum (k_t - p n_t)^2 / N^2 with N = sum n_t (linearised ratio), and independent rocks
// p (1 - p) / N. Sources: Kish 1965, Survey Sampling; Korn and Graubard 1998, Confidence intervals for
// proportions with small expected number of positive counts estimated from survey data.

#include <cstdint>

namespace flyrock {

/// An interval needs so many trials beyond its number.
inline constexpr std::uint64_t least_trials = 10;

/// Sums over trials of whole numbers, which have the same value in any order.
class TrialCounts {
 public:
  /// A trial with n rocks, of which k count.
  void add(std::uint64_t n, std::uint64_t k);

  std::uint64_t rocks() const { return n_; }
  std::uint64_t counted() const { return k_; }
  std::uint64_t trials() const { return trials_; }           ///< with at least one rock
  std::uint64_t trials_with() const { return with_; }        ///< with at least one rock that counts
  std::uint64_t trials_without() const { return without_; }  ///< with at least one rock that does not
  bool is_clustered() const { return n_ > trials_; }         ///< some trial has several rocks
  double share() const { return static_cast<double>(k_) / static_cast<double>(n_); }

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
  std::uint64_t n_ = 0, k_ = 0, trials_ = 0, with_ = 0, without_ = 0;
  std::uint64_t nn_ = 0, kn_ = 0, kk_ = 0;  ///< sums of n_t^2, k_t n_t, k_t^2
};

/// The trials that it takes until least_trials of them have what `with` of `trials` have; 0 if they have.
std::uint64_t trials_needed(std::uint64_t with, std::uint64_t trials);

}  // namespace flyrock
