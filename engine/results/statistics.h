#pragma once
// Statistics of the rocks of one sweep point. Censored values are kept apart from known ones.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "batch/records.h"
#include "results/sample.h"
#include "results/share.h"
#include "scenario/scenario.h"

namespace flyrock {

/// The quantities of a rock, with their names in measures and summary.json.
enum class RockQuantity {
  runout,
  max_distance,
  flight_range,
  bounce_height,
  speed,
  energy,
  impacts,
  time,
  launch_speed
};
inline constexpr std::array<std::string_view, 9> quantity_names = {
    "runout", "max_distance", "flight_range", "bounce_height", "speed",
    "energy", "impacts",      "time",         "launch_speed"};
inline constexpr std::array<std::string_view, 9> quantity_units = {"m", "m", "m", "m",  "m/s",
                                                                   "J", "",  "s", "m/s"};

enum class Statistic { mean, sd, min, max, p50, p90, p95, p99 };
inline constexpr std::array<std::string_view, 8> statistic_names = {"mean", "sd",  "min", "max",
                                                                    "p50",  "p90", "p95", "p99"};

using Statistics = std::array<Bounded, statistic_names.size()>;  ///< indexed by Statistic

/// A number of one rock. The path of a censored rock was cut short, so each of its numbers is a lower bound,
/// except its launch speed, and its flight range if it had landed.
Bounded quantity_of(const RockRecord& rock, RockQuantity quantity);

/// Intervals of the mean and of the percentiles; NaN for the other statistics. The values are assumed
/// independent.
using Intervals = std::array<Interval, statistic_names.size()>;

/// The quantiles that a Sample must be asked for, so that statistics_of() and intervals_of() can read them.
Questions stated_questions();
Statistics statistics_of(const Sample& sample);
Intervals intervals_of(const Sample& sample);

/// The rocks of one group, or all rocks.
struct GroupSummary {
  std::string name;          ///< empty: all rocks
  std::uint64_t count = 0;   ///< rocks, including those with faults
  std::uint64_t faults = 0;  ///< rocks that failed; they are in no statistic
  std::uint64_t censored = 0;
  std::array<std::uint64_t, stop_reasons> reasons{};  ///< indexed by StopReason
  std::array<Statistics, quantity_names.size()> statistics{};
  std::array<Intervals, quantity_names.size()> intervals{};

  /// Shares of all rocks without faults together, indexed by TravelMode; NaN if none has moved.
  std::array<double, travel_mode_names.size()> time_share{}, distance_share{};

  const Bounded& at(RockQuantity quantity, Statistic statistic) const {
    return statistics[static_cast<int>(quantity)][static_cast<int>(statistic)];
  }
  /// Share of censored rocks among the rocks without faults; 0 if there are none.
  double censored_share() const;
  Interval censored_interval() const { return share_interval(censored, count - faults, stated_confidence); }
};

/// Summarises the rocks of one group from passes.
class GroupTally {
 public:
  explicit GroupTally(const std::string& name);
  void add(const RockRecord& rock);
  bool again();
  GroupSummary summary() const;

 private:
  bool counted_ = false;  ///< first pass is done
  GroupSummary counts_;
  Travel travel_;
  std::vector<Sample> samples_;  ///< one for each quantity
};

/// Summarises rocks: all of them first, then each group if there is more than one. See read_in_passes().
class RockTally {
 public:
  explicit RockTally(const std::vector<std::string>& groups);
  void see(const TrialRecords& chunk);
  bool again();
  std::vector<GroupSummary> summaries() const;

 private:
  std::vector<GroupTally> tallies_;
};

}  // namespace flyrock
