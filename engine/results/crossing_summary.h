#pragma once
// What passed the gates and barriers of one sweep point.

#include <array>
#include <cstdint>
#include <vector>

#include "results/share.h"
#include "results/statistics.h"

namespace flyrock {

/// The rocks without faults of one sweep point at one place. A censored rock that has not arrived might have
/// arrived later. If there is such a rock, the numbers of the place are lower bounds.
struct GateSummary {
  std::uint64_t passed = 0;                ///< rocks
  Share share;                             ///< of all rocks
  Statistics speed{}, energy{}, height{};  ///< of the rocks that passed, at the gate
};

struct BarrierSummary {
  std::array<std::uint64_t, 3> outcomes{};  ///< rocks, indexed by BarrierOutcome
  std::uint64_t not_reached = 0;            ///< rocks that did not arrive; with the outcomes, all rocks
  Share reached;                            ///< rocks that arrived, of all rocks
  std::array<Share, 3> shares{};            ///< of all rocks, indexed by BarrierOutcome
  Share past;                               ///< over the top or through, of all rocks
  Statistics energy{}, height{};            ///< of the rocks that arrived, before the barrier acts
};

/// The rocks without faults of one sweep point and the trees.
struct TreeSummary {
  std::uint64_t hits = 0;     ///< of all rocks
  std::uint64_t hit = 0;      ///< rocks that hit at least one
  std::uint64_t stopped = 0;  ///< rocks that a tree stopped
  Share hit_share, stopped_share;
  double mean_hits = 0;  ///< of a rock; a lower bound if there are censored rocks
};

/// Counts the hits of trees, in one pass.
class TreeTally {
 public:
  void add(const TrialRecords& chunk);
  TreeSummary summary() const;

 private:
  std::uint64_t rocks_ = 0;
  std::uint64_t not_hit_ = 0, not_stopped_ = 0;  ///< censored rocks that were not: they might be later
  TreeSummary counts_;
};

/// Summarises the arrivals at gates and barriers. It sees all chunks once per pass (read_in_passes), and
/// needs_another_pass() says whether it needs another pass.
class CrossingTally {
 public:
  CrossingTally(std::size_t gates, std::size_t barriers);
  void add(const TrialRecords& chunk);
  bool needs_another_pass();
  /// In the order of Scenario::gates and Scenario::barriers.
  std::vector<GateSummary> gates() const;
  std::vector<BarrierSummary> barriers() const;

 private:
  /// The arrivals at one place.
  struct Arrivals {
    std::uint64_t censored = 0;  ///< rocks that arrived and were censored later
    std::array<std::uint64_t, 3> outcomes{};
    Sample speed{stated_questions()}, energy{stated_questions()}, height{stated_questions()};

    bool needs_another_pass();
  };

  template <class Arrival>
  void add(Arrivals& at, const Arrival& arrival, const RockRecord& rock);
  /// Censored rocks that had not arrived: they might have arrived later.
  std::uint64_t open(const Arrivals& at) const { return censored_ - at.censored; }
  Share share(std::uint64_t count, const Arrivals& at) const { return share_of(count, rocks_, open(at)); }

  bool counted_ = false;                    ///< first pass is done
  std::uint64_t rocks_ = 0, censored_ = 0;  ///< without faults
  std::vector<Arrivals> gates_, barriers_;
};

}  // namespace flyrock
