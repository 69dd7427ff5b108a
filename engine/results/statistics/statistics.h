#pragma once
// Statistics of the rocks of one sweep point. Censored values are kept apart from known ones.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "record/rock_statistics.h"
#include "results/statistics/sample.h"
#include "results/statistics/share.h"
#include "scenario/scenario.h"

namespace flyrock {

enum class Statistic { mean, sd, min, max, p50, p90, p95, p99 };
inline constexpr std::array<std::string_view, 8> statistic_names = {"mean", "sd",  "min", "max",
                                                                    "p50",  "p90", "p95", "p99"};

using Statistics = std::array<Bounded, statistic_names.size()>;  ///< indexed by Statistic

/// A number of one rock: a lower bound if its path was cut short before the number was known.
Bounded bounded(const RockRecord& rock, const RockStatistic& number);

/// Intervals of the mean and of the percentiles; NaN for the other statistics.
using Intervals = std::array<Interval, statistic_names.size()>;

inline constexpr Statistics unknown_statistics = each<statistic_names.size()>(unknown_number);
inline constexpr Intervals unknown_intervals = each<statistic_names.size()>(unknown_interval);

/// The quantiles that a Sample must be asked for, so that statistics_of() and intervals_of() can read them.
Questions stated_questions();
Statistics statistics_of(const Sample& sample);
Intervals intervals_of(const Sample& sample);

/// The rocks of one group, or all rocks. What is not told (Told::counts) is unknown.
struct GroupSummary {
  std::string name;          ///< empty: all rocks
  std::uint64_t count = 0;   ///< rocks, including those with faults
  std::uint64_t faults = 0;  ///< rocks that failed; they are in no statistic
  std::uint64_t censored = 0;
  double weight = unknown;                            ///< of the rocks without faults
  WeightRange weights;                                ///< of all rocks
  std::array<std::uint64_t, stop_reasons> reasons{};  ///< indexed by StopReason
  std::array<Share, stop_reasons> reason_shares = each<stop_reasons>(unknown_share);  ///< of all rocks
  Share censored_share = unknown_share;  ///< of the rocks without faults; 0 without any
  // indexed by rock_statistics
  std::array<Statistics, rock_statistic_count> statistics = each<rock_statistic_count>(unknown_statistics);
  std::array<Intervals, rock_statistic_count> intervals = each<rock_statistic_count>(unknown_intervals);

  /// Shares of all rocks without faults together, indexed by TravelMode; NaN if none has moved.
  std::array<double, travel_mode_names.size()> time_share = each<travel_mode_names.size()>(unknown),
                                               distance_share = time_share;

  /// `number`: rock_statistic("runout")
  const Bounded& at(std::size_t number, Statistic statistic) const {
    return statistics[number][static_cast<std::size_t>(statistic)];
  }
  const Interval& interval(std::size_t number, Statistic statistic) const {
    return intervals[number][static_cast<std::size_t>(statistic)];
  }
};

/// What the first pass tells of the runouts of a group: of its rocks without faults.
struct RunoutExtent {
  std::uint64_t count = 0;
  bool is_weighted = false;  ///< their weights differ
  double weight = 0;         ///< of all
  double least = 0, greatest = 0;
};

/// Summarises the rocks of one group from passes.
class GroupTally {
 public:
  /// `unit`: the trials that are one independent unit of a number; more than one: a replicate of a design.
  explicit GroupTally(const std::string& name, std::uint64_t unit = 1);
  void add(const RockRecord& rock);
  bool needs_another_pass();
  /// After the first pass.
  RunoutExtent runout_extent() const;
  GroupSummary summary(Told told = Told::all) const;

 private:
  bool counted_ = false;  ///< first pass is done
  std::string name_;
  std::uint64_t unit_;
  WeightRange weights_;
  double weight_ = 0;                 ///< of the rocks without faults
  ShareTally reasons_{stop_reasons};  ///< of all rocks
  ShareTally censored_;               ///< of the rocks without faults
  Travel travel_;
  std::vector<Sample> samples_;  ///< of rock_statistics
};

/// Summarises rocks: all of them first, then each group if there is more than one. See read_in_passes().
class RockTally {
 public:
  explicit RockTally(const std::vector<std::string>& groups, std::uint64_t unit = 1);
  void add(const TrialRecords& chunk);
  bool needs_another_pass();
  /// In the order of summaries(), after the first pass.
  std::vector<RunoutExtent> runout_extents() const;
  /// The counts of all rocks.
  GroupSummary counts() const { return tallies_.front().summary(Told::counts); }
  std::vector<GroupSummary> summaries(Told told = Told::all) const;

 private:
  std::vector<GroupTally> tallies_;
};

}  // namespace flyrock
