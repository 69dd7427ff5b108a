#pragma once
// A share: k of n rocks, with its confidence interval.

#include <cstdint>

#include "results/statistics/sample.h"

namespace flyrock {

/// The exact interval of a binomial share. At its lower end, k or more of n have the probability (1 -
/// confidence) / 2; at its upper end, k or fewer have it. It contains the true share with at least this
/// confidence. For k = 0 the lower end is 0 and the upper end is 1 - ((1 - confidence) / 2)^(1/n). NaN for n
/// = 0. Source: Clopper and Pearson 1934. k and n may be parts of rocks, of an effective_size().
Interval share_interval(double k, double n, double confidence);

/// A number of rocks divided by the number of all of them (NaN for 0 of 0), and its interval with
/// stated_confidence.
struct Share : Bounded {
  Interval interval;
};
inline constexpr Share unknown_share{unknown_number, unknown_interval};

/// The share k of n. `open` more rocks may still count. The share is then a lower bound, and the upper end of
/// the interval is that of k + open.
Share share_of(std::uint64_t k, std::uint64_t n, std::uint64_t open = 0);

/// The share of the rocks that count. Where trials have several rocks, the interval is that of Clopper and
/// Pearson for k and n divided by the design effect (Korn and Graubard 1998), and it needs least_trials
/// trials with a rock that counts. Of none that counts, the upper end is that of the share of trials.
/// `or_open` also counts the rocks that may still do so.
Share share_of(const TrialCounts& counts, const TrialCounts& or_open);

/// Counts the rocks of one or several shares of the same rocks. Rocks of one trial follow each other.
class ShareTally {
 public:
  explicit ShareTally(std::size_t shares = 1) : shares_(shares) {}

  /// A rock, of which count() and leave_open() then speak.
  void add(std::uint64_t trial, double weight = 1);
  /// It counts for a share.
  void count(std::size_t share = 0) {
    shares_[share].weights.add(weight_);
    shares_[share].counted.add(weight_);
    shares_[share].or_open_now.add(weight_);
  }
  /// It does not count, but might have if its path had not been cut short.
  void leave_open(std::size_t share = 0) { shares_[share].or_open_now.add(weight_); }
  /// The same for all shares.
  void leave_all_open() {
    for (std::size_t share = 0; share < shares_.size(); ++share) leave_open(share);
  }
  /// After the last rock.
  void close();

  /// Weights of all rocks, and of those that count.
  const WeightRange& weights() const { return weights_; }
  const WeightRange& weights(std::size_t share) const { return shares_[share].weights; }

  std::uint64_t rocks() const { return rocks_; }
  std::uint64_t counted(std::size_t share = 0) const { return shares_[share].counts.counted(); }
  std::uint64_t open(std::size_t share = 0) const {
    return shares_[share].or_open.counted() - counted(share);
  }
  /// The share of the rocks, or of their weights.
  Share of_rocks(std::size_t share = 0) const {
    return share_of(shares_[share].counts, shares_[share].or_open);
  }
  std::uint64_t trials() const { return shares_.front().counts.trials(); }  ///< with a rock
  /// The share of `trials`, by default those with a rock, in which at least one counts, whatever its weight.
  Share per_trial(std::size_t share, std::uint64_t trials) const;
  Share per_trial(std::size_t share = 0) const { return per_trial(share, trials()); }

 private:
  struct Sums {
    TrialCounts counts, or_open;
    WeightRange weights;           ///< of those that count
    Weighed counted, or_open_now;  ///< of the open trial
  };

  std::vector<Sums> shares_;
  std::uint64_t rocks_ = 0;
  WeightRange weights_;
  double weight_ = 1;        ///< of the rock
  std::uint64_t trial_ = 0;  ///< the open trial
  Weighed in_trial_;         ///< its rocks
};

/// The share of the other rocks. Where `share` is a lower bound, that of the others is an upper bound.
struct Complement {
  double value;
  bool is_upper_bound;
  Interval interval;
};
Complement complement_of(const Share& share);

}  // namespace flyrock
