#pragma once
// Paired differences between the points of a sweep and point 0.
//
// The points have the same random numbers. So rock j of a group in trial t at point k and at point 0 are the
// same rock, and the mean of x_k - x_0 over such pairs scatters far less than the difference of two means. A
// trial is the unit of its interval: trial t has n_t pairs with the sum S_t of differences, and the interval
// of the mean d is d -+ t sqrt(m / (m - 1) sum (S_t - d n_t)^2) / n, with Student's t of m - 1 degrees of
// freedom, m trials and n pairs.

#include <string>
#include <vector>

#include "record/rows.h"
#include "results/measured/measures.h"

namespace flyrock {

struct Plan;

/// What the censored pairs make of a mean difference: the true one is exactly it, at least it, at most it, or
/// anything.
enum class DifferenceBound { none, at_least, at_most, not_known };

/// The largest share of censored pairs with which a mean difference has an interval.
inline constexpr double most_censored_pairs = 0.05;

/// The mean difference of one number.
struct Difference {
  std::uint64_t pairs = 0;      ///< in the mean: with a difference, or a bound of it
  std::uint64_t censored = 0;   ///< pairs of which at least one number is a bound
  std::uint64_t left_out = 0;   ///< of these, the ones without a bound: in no mean
  std::uint64_t differing = 0;  ///< trials in which some pair differs
  DifferenceBound bound = DifferenceBound::none;
  double mean = unknown;                ///< NaN also where `bound` is not_known
  Interval interval{unknown, unknown};  ///< none with more than most_censored_pairs

  bool has_many_censored() const {
    return static_cast<double>(censored) > most_censored_pairs * static_cast<double>(pairs + left_out);
  }
};

/// The difference of the runout in words: "+3.2 m (95 % interval 2.9 to 3.5 m)", ">= +7.5 m (66 of 200 pairs
/// are censored ...)", "not known: ..."; empty without pairs.
std::string difference_text(const Difference& difference);

/// A number of rocks of which there are differences.
struct ComparedNumber {
  std::string name;  ///< as in measures: "runout", "gate.road.passed", "barrier.fence.caught"
  std::string unit;  ///< SI; empty: a share
};
/// The statistics of rocks, then the shares of all rocks of gates and barriers.
std::vector<ComparedNumber> compared_numbers(const Scenario& scenario);

/// The differences of a point from point 0.
struct PointDifferences {
  struct Group {
    std::string name;                 ///< empty: all rocks
    std::uint64_t unpaired = 0;       ///< rocks of the two points without a partner, or with one that failed
    std::vector<Difference> numbers;  ///< in the order of compared_numbers()
  };
  std::size_t point = 0;
  std::vector<Group> groups;  ///< all rocks, then each group if there is more than one
  std::string reason;         ///< why there are none: "lost", "rows"; then there are no groups
};

/// The differences of all points after point 0, in two or more passes over their rows.
std::vector<PointDifferences> make_differences(const Plan& plan, const std::vector<PointResult>& points,
                                               const std::vector<Rows>& rows);

}  // namespace flyrock
