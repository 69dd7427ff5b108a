#include "results/crossing_summary.h"

#include <algorithm>
#include <utility>

namespace flyrock {

namespace {

/// The rock of a row; nullptr if it failed. The rows of a chunk are sorted.
template <class Row>
const RockRecord* rock_of(const Row& row, const std::vector<RockRecord>& rocks) {
  const auto found = std::lower_bound(
      rocks.begin(), rocks.end(), std::pair(row.trial, row.rock),
      [](const RockRecord& rock, const auto& key) { return std::pair(rock.trial, rock.rock) < key; });
  return is_fault(found->reason) ? nullptr : &*found;
}

Statistics bounded(const Sample& sample, bool open) {
  Statistics statistics = statistics_of(sample);
  for (Bounded& number : statistics) number.censored = open;
  return statistics;
}

}  // namespace

void TreeTally::add(const TrialRecords& chunk) {
  auto row = chunk.trees.begin();  // sorted as the rocks are
  for (const RockRecord& rock : chunk.rocks) {
    std::uint64_t hits = 0;
    bool stopped = false;
    for (; row != chunk.trees.end() && row->trial == rock.trial && row->rock == rock.rock; ++row) {
      ++hits;
      stopped = rock.reason == StopReason::caught && row->hit.energy_after == 0;
    }
    if (is_fault(rock.reason)) continue;
    ++rocks_;
    counts_.hits += hits;
    counts_.hit += hits > 0;
    counts_.stopped += stopped;
    not_hit_ += rock.censored && hits == 0;
    not_stopped_ += rock.censored && !stopped;
  }
}

TreeSummary TreeTally::summary() const {
  TreeSummary summary = counts_;
  summary.hit_share = share_of(summary.hit, rocks_, not_hit_);
  summary.stopped_share = share_of(summary.stopped, rocks_, not_stopped_);
  summary.mean_hits = static_cast<double>(summary.hits) / static_cast<double>(rocks_);
  return summary;
}

CrossingTally::CrossingTally(std::size_t gates, std::size_t barriers) : gates_(gates), barriers_(barriers) {}

void CrossingTally::add(const TrialRecords& chunk) {
  if (gates_.empty() && barriers_.empty()) return;
  for (const RockRecord& rock : chunk.rocks) {
    if (counted_ || is_fault(rock.reason)) continue;
    ++rocks_;
    censored_ += rock.censored;
  }
  for (const GateRecord& row : chunk.gates)
    if (const RockRecord* rock = rock_of(row, chunk.rocks))
      add(gates_.at(static_cast<std::size_t>(row.passage.gate)), row.passage, *rock);
  for (const BarrierRecord& row : chunk.barriers)
    if (const RockRecord* rock = rock_of(row, chunk.rocks)) {
      Arrivals& at = barriers_.at(static_cast<std::size_t>(row.hit.barrier));
      add(at, row.hit, *rock);
      if (!counted_) ++at.outcomes[static_cast<std::size_t>(row.hit.outcome)];
    }
}

template <class Arrival>
void CrossingTally::add(Arrivals& at, const Arrival& arrival, const RockRecord& rock) {
  if (!counted_) at.censored += rock.censored;
  at.speed.add({arrival.speed, false});
  at.energy.add({arrival.kinetic_energy, false});
  at.height.add({arrival.height, false});
}

bool CrossingTally::Arrivals::needs_another_pass() {
  bool more = false;
  for (Sample* sample : {&speed, &energy, &height}) more |= sample->needs_another_pass();
  return more;
}

bool CrossingTally::needs_another_pass() {
  counted_ = true;
  bool more = false;
  for (auto* places : {&gates_, &barriers_})
    for (Arrivals& at : *places) more |= at.needs_another_pass();
  return more;
}

std::vector<GateSummary> CrossingTally::gates() const {
  std::vector<GateSummary> summaries;
  for (const Arrivals& at : gates_)
    summaries.push_back({at.speed.size(), share(at.speed.size(), at), bounded(at.speed, open(at) > 0),
                         bounded(at.energy, open(at) > 0), bounded(at.height, open(at) > 0)});
  return summaries;
}

std::vector<BarrierSummary> CrossingTally::barriers() const {
  std::vector<BarrierSummary> summaries;
  for (const Arrivals& at : barriers_) {
    BarrierSummary summary;
    summary.outcomes = at.outcomes;
    summary.not_reached = rocks_ - at.speed.size();
    summary.reached = share(at.speed.size(), at);
    for (std::size_t o = 0; o < at.outcomes.size(); ++o) summary.shares[o] = share(at.outcomes[o], at);
    summary.past = share(at.speed.size() - at.outcomes[static_cast<std::size_t>(BarrierOutcome::caught)], at);
    summary.energy = bounded(at.energy, open(at) > 0);
    summary.height = bounded(at.height, open(at) > 0);
    summaries.push_back(summary);
  }
  return summaries;
}

}  // namespace flyrock
