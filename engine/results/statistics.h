#pragma once
// Statistics of the rocks of one point, with what is censored kept apart from what is known.

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

/// What is counted of a rock, under its name in measures and summary.json.
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
/// but for its launch speed and the flight range of a rock that had landed.
Bounded quantity_of(const RockRecord& rock, RockQuantity quantity);

/// Intervals of the mean and of the percentiles; NaN for the other statistics. The values are taken as
/// independent.
using Intervals = std::array<Interval, statistic_names.size()>;

/// What a sample is asked for its statistics and their intervals.
Questions stated_questions();
Statistics statistics_of(const Sample& sample);
Intervals intervals_of(const Sample& sample);

/// The rocks of one group, or of all.
struct GroupSummary {
  std::string name;          ///< empty: all rocks
  std::uint64_t count = 0;   ///< rocks, those with faults included
  std::uint64_t faults = 0;  ///< rocks that failed: in no statistic
  std::uint64_t censored = 0;
  std::array<std::uint64_t, stop_reasons> reasons{};  ///< indexed by StopReason
  std::array<Statistics, quantity_names.size()> statistics{};
  std::array<Intervals, quantity_names.size()> intervals{};

  /// Of all rocks without faults together, indexed by TravelMode; NaN where none has moved.
  std::array<double, travel_mode_names.size()> time_share{}, distance_share{};

  const Bounded& at(RockQuantity quantity, Statistic statistic) const {
    return statistics[static_cast<int>(quantity)][static_cast<int>(statistic)];
  }
  /// Share of the rocks without faults that are censored; 0 where there are none.
  double censored_share() const;
  Interval censored_interval() const { return share_interval(censored, count - faults, stated_confidence); }
};

/// Summarises the rocks of one group, shown in passes.
class GroupTally {
 public:
  explicit GroupTally(const std::string& name);
  void add(const RockRecord& rock);
  bool again();
  GroupSummary summary() const;

 private:
  bool counted_ = false;  ///< in the first pass
  GroupSummary counts_;
  Travel travel_;
  std::vector<Sample> samples_;  ///< of each quantity
};

/// Summarises rocks: all of them first, then each group where there is more than one. See read_in_passes().
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
