#pragma once
// What passed the gates and barriers of one sweep point.

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "results/statistics/blast_bounds.h"
#include "results/statistics/share.h"
#include "results/statistics/statistics.h"

namespace flyrock {

/// A share in its three senses.
struct Shares {
  Share of_all = unknown_share;       ///< of all rocks
  Share of_arriving = unknown_share;  ///< of the rocks that arrive; of a gate all pass
  /// The share of trials with at least one such rock; with weights `blast.upper`.
  Share per_trial = unknown_share;
  BlastBounds blast = unknown_bounds;  ///< that at least one such real rock comes with a blast
};

/// The rocks without faults of one sweep point, or of one of its groups, at one place. A censored rock that
/// has not arrived might have arrived later, unless it is decided (flight/decided.h). If there is such a
/// rock, the numbers of the place are lower bounds.
struct GateSummary {
  std::uint64_t passed = 0;  ///< rocks
  Shares shares;
  /// Arrivals of the rocks that passed the gate.
  Statistics speed = unknown_statistics, energy = unknown_statistics, height = unknown_statistics;
  Intervals speed_intervals = unknown_intervals, energy_intervals = unknown_intervals,
            height_intervals = unknown_intervals;
  std::map<int, double> along = {};  ///< rocks (or their weights) that passed, by bin along the line
};

/// The width of the bins along the line of a gate [m]. Bin i starts at i times that.
inline constexpr double bin_along = 5;

/// What may happen to rocks at a barrier: the outcomes of BarrierOutcome, then `past`, over the top or
/// through, and `reached`.
inline constexpr std::array<std::string_view, 5> barrier_share_names = {"caught", "over_top", "over_energy",
                                                                        "past", "reached"};
enum class BarrierShare { caught, over_top, over_energy, past, reached };

struct BarrierSummary {
  std::array<std::uint64_t, barrier_share_names.size()> counts{};  ///< rocks, indexed by BarrierShare
  std::uint64_t not_reached = 0;                                   ///< rocks that did not arrive
  std::array<Shares, barrier_share_names.size()> shares{};         ///< indexed by BarrierShare
  /// Arrivals of rocks, before the barrier acts.
  Statistics energy = unknown_statistics, height = unknown_statistics;
  Intervals energy_intervals = unknown_intervals, height_intervals = unknown_intervals;

  std::uint64_t count(BarrierShare what) const { return counts[static_cast<std::size_t>(what)]; }
  const Shares& share(BarrierShare what) const { return shares[static_cast<std::size_t>(what)]; }
};

/// What the rocks of a group, or all rocks, did at gates and barriers.
struct CrossingSummary {
  std::vector<GateSummary> gates;        ///< in the order of Scenario::gates
  std::vector<BarrierSummary> barriers;  ///< in the order of Scenario::barriers
  Share caught = unknown_share;          ///< by any barrier, of all rocks
};

/// The rocks without faults of one sweep point and the trees. A rock that left the domain hits no more trees,
/// because they stand on its ground.
struct TreeSummary {
  std::uint64_t hits = 0;     ///< of all rocks
  std::uint64_t hit = 0;      ///< rocks that hit at least one
  std::uint64_t stopped = 0;  ///< rocks that a tree stopped
  Share hit_share = unknown_share, stopped_share = unknown_share;
  double mean_hits = unknown;  ///< of a rock; a lower bound where `stopped_share` is one
};

/// Counts the hits of trees, in one pass.
class TreeTally {
 public:
  void add(const TrialRecords& chunk);
  TreeSummary summary(Told told = Told::all);

 private:
  static constexpr std::size_t hit = 0, stops = 1;  ///< shares
  ShareTally shares_{2};
  std::uint64_t hits_ = 0;
  double weighted_hits_ = 0, weight_ = 0;  ///< of the rocks
};

/// Summarises the arrivals of some rocks at gates and barriers, in passes.
class CrossingTally {
 public:
  CrossingTally(std::size_t gates, std::size_t barriers);
  /// A rock without a fault, with its arrivals.
  void add(const RockRecord& rock, std::span<const GateRecord> gates,
           std::span<const BarrierRecord> barriers);
  bool needs_another_pass();
  /// `groups`: the tallies of the groups of these rocks, if there are several.
  CrossingSummary summary(Told told, std::span<const CrossingTally> groups = {}) const;

 private:
  /// The arrivals at one place.
  struct Arrivals {
    explicit Arrivals(std::size_t shares) : of_all(shares), of_arriving(shares) {}
    ShareTally of_all, of_arriving;  ///< gates: passed; barriers: BarrierShare
    Sample speed{stated_questions()}, energy{stated_questions()}, height{stated_questions()};

    std::map<int, double> along;  ///< of gates: arrivals by bin

    bool has_arrived = false;  ///< the rock that is being counted

    void count(const RockRecord& rock, std::initializer_list<std::size_t> shares);
    void add(const Arrival& arrival, const RockRecord& rock);
    /// `groups`: the arrivals of each group at the same place.
    Shares shares(std::size_t share, const std::vector<const Arrivals*>& groups) const;
    SimulatedBlasts blasts(std::size_t share, std::uint64_t trials) const;
    bool needs_another_pass();
  };

  void count(const RockRecord& rock, std::span<const GateRecord> gates,
             std::span<const BarrierRecord> barriers);
  /// The arrivals of groups at one of their places.
  static std::vector<const Arrivals*> at_place(std::span<const CrossingTally> groups,
                                               std::vector<Arrivals> CrossingTally::*places, std::size_t i);
  static void leave_open(const RockRecord& rock, std::vector<Arrivals>& places, std::uint64_t decided);

  bool counted_ = false;  ///< first pass is done
  std::vector<Arrivals> gates_, barriers_;
  ShareTally caught_;
};

/// CrossingSummary of all rocks, then of each group if there is more than one. See read_in_passes().
class CrossingTallies {
 public:
  CrossingTallies(const Scenario& scenario);
  void add(const TrialRecords& chunk);
  bool needs_another_pass();
  std::vector<CrossingSummary> summaries(Told told = Told::all) const;

 private:
  std::vector<CrossingTally> tallies_;
  bool is_empty_;  ///< no gates, no barriers
};

}  // namespace flyrock
