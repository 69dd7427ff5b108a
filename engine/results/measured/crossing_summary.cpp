#include "results/measured/crossing_summary.h"

#include <cmath>
#include <utility>

#include "results/measured/rows_of_rock.h"

namespace flyrock {

namespace {

/// `open`: more rocks may still arrive.
Statistics lower_bounds(const Sample& sample, bool open) {
  Statistics statistics = statistics_of(sample);
  for (Bounded& number : statistics) number.censored = open;
  return statistics;
}

}  // namespace

void TreeTally::add(const TrialRecords& chunk) {
  std::size_t row = 0;
  for (const RockRecord& rock : chunk.rocks) {
    const auto hits = rows_of_rock(chunk.trees, row, rock);
    if (is_fault(rock.reason)) continue;
    const bool stopped =
        rock.reason == StopReason::caught && !hits.empty() && hits.back().hit.energy_after == 0;
    hits_ += hits.size();
    weighted_hits_ += rock.weight * static_cast<double>(hits.size());
    weight_ += rock.weight;
    shares_.add(rock.trial, rock.weight);
    for (const auto& [share, counts] : {std::pair{hit, !hits.empty()}, std::pair{stops, stopped}}) {
      if (counts)
        shares_.count(share);
      else if (rock.reason == StopReason::timed_out)
        shares_.leave_open(share);
    }
  }
}

TreeSummary TreeTally::summary(Told told) {
  shares_.close();
  TreeSummary summary;
  summary.hits = hits_;
  summary.hit = shares_.counted(hit);
  summary.stopped = shares_.counted(stops);
  if (told == Told::counts) return summary;
  summary.hit_share = shares_.of_rocks(hit);
  summary.stopped_share = shares_.of_rocks(stops);
  summary.mean_hits = weighted_hits_ / weight_;
  return summary;
}

void CrossingTally::leave_open(const RockRecord& rock, std::vector<Arrivals>& places, std::uint64_t decided) {
  for (std::size_t i = 0; i < places.size(); ++i)
    if (!places[i].has_arrived && may_still_arrive(rock, decided, i)) places[i].of_all.leave_all_open();
}

CrossingTally::CrossingTally(std::size_t gates, std::size_t barriers)
    : gates_(gates, Arrivals(1)), barriers_(barriers, Arrivals(barrier_share_names.size())) {}

void CrossingTally::add(const RockRecord& rock, std::span<const GateRecord> gates,
                        std::span<const BarrierRecord> barriers) {
  if (!counted_) count(rock, gates, barriers);
  for (const GateRecord& row : gates)
    gates_.at(static_cast<std::size_t>(row.passage.gate)).add(row.passage, rock);
  for (const BarrierRecord& row : barriers)
    barriers_.at(static_cast<std::size_t>(row.hit.barrier)).add(row.hit, rock);
}

/// In the first pass: a rock at all places, also at those that it does not reach.
void CrossingTally::count(const RockRecord& rock, std::span<const GateRecord> gates,
                          std::span<const BarrierRecord> barriers) {
  for (std::vector<Arrivals>* places : {&gates_, &barriers_})
    for (Arrivals& at : *places) {
      at.of_all.add(rock.trial, rock.weight);
      at.has_arrived = false;
    }
  for (const GateRecord& row : gates) {
    Arrivals& at = gates_.at(static_cast<std::size_t>(row.passage.gate));
    at.count(rock, {0});
    at.along[static_cast<int>(std::floor(row.passage.along / bin_along))] += rock.weight;
  }
  caught_.add(rock.trial, rock.weight);
  for (const BarrierRecord& row : barriers) {
    const bool is_caught = row.hit.outcome == BarrierOutcome::caught;
    Arrivals& at = barriers_.at(static_cast<std::size_t>(row.hit.barrier));
    const auto outcome = static_cast<std::size_t>(row.hit.outcome);
    const auto past = static_cast<std::size_t>(BarrierShare::past),
               reached = static_cast<std::size_t>(BarrierShare::reached);
    if (is_caught) {
      caught_.count();
      at.count(rock, {outcome, reached});
    } else {
      at.count(rock, {outcome, past, reached});
    }
  }
  leave_open(rock, gates_, rock.decided_gates);
  leave_open(rock, barriers_, rock.decided_barriers);
}

void CrossingTally::Arrivals::count(const RockRecord& rock, std::initializer_list<std::size_t> shares) {
  has_arrived = true;
  of_arriving.add(rock.trial, rock.weight);
  for (const std::size_t share : shares) {
    of_all.count(share);
    of_arriving.count(share);
  }
}

void CrossingTally::Arrivals::add(const Arrival& arrival, const RockRecord& rock) {
  speed.add({arrival.speed, false}, rock.trial, rock.weight);
  energy.add({arrival.kinetic_energy, false}, rock.trial, rock.weight);
  height.add({arrival.height, false}, rock.trial, rock.weight);
}

bool CrossingTally::Arrivals::needs_another_pass() {
  of_all.close();
  of_arriving.close();
  bool more = false;
  for (Sample* sample : {&speed, &energy, &height}) more |= sample->needs_another_pass();
  return more;
}

/// h_i is 1 or 0, so that S is the product too.
SimulatedBlasts CrossingTally::Arrivals::blasts(std::size_t share, std::uint64_t trials) const {
  const Share simulated = of_all.per_trial(share, trials);
  return {simulated.value,    simulated.interval, simulated.value,
          simulated.interval, of_all.weights(),   of_all.weights(share)};
}

Shares CrossingTally::Arrivals::shares(std::size_t share, const std::vector<const Arrivals*>& groups) const {
  const std::uint64_t trials = of_all.trials();
  Shares shares{of_all.of_rocks(share), of_arriving.of_rocks(share), of_all.per_trial(share),
                bounds_of(blasts(share, trials))};
  if (of_all.weights().differ()) {
    std::vector<BlastBounds> of_groups;
    for (const Arrivals* group : groups) of_groups.push_back(bounds_of(group->blasts(share, trials)));
    shares.blast = over_groups(shares.blast, of_groups);
  }
  shares.per_trial.value = shares.blast.upper;
  shares.per_trial.interval = shares.blast.interval;
  return shares;
}

bool CrossingTally::needs_another_pass() {
  counted_ = true;
  caught_.close();
  bool more = false;
  for (auto* places : {&gates_, &barriers_})
    for (Arrivals& at : *places) more |= at.needs_another_pass();
  return more;
}

std::vector<const CrossingTally::Arrivals*> CrossingTally::at_place(
    std::span<const CrossingTally> groups, std::vector<Arrivals> CrossingTally::*places, std::size_t i) {
  std::vector<const Arrivals*> list;
  for (const CrossingTally& group : groups) list.push_back(&(group.*places)[i]);
  return list;
}

CrossingSummary CrossingTally::summary(Told told, std::span<const CrossingTally> groups) const {
  CrossingSummary summary;
  for (const Arrivals& at : gates_) {
    const auto of_groups = at_place(groups, &CrossingTally::gates_, summary.gates.size());
    GateSummary& gate = summary.gates.emplace_back();
    gate.passed = at.of_all.counted();
    if (told == Told::counts) continue;
    const bool open = at.of_all.open() > 0;
    gate.shares = at.shares(0, of_groups);
    gate.speed = lower_bounds(at.speed, open);
    gate.energy = lower_bounds(at.energy, open);
    gate.height = lower_bounds(at.height, open);
    gate.speed_intervals = intervals_of(at.speed);
    gate.energy_intervals = intervals_of(at.energy);
    gate.height_intervals = intervals_of(at.height);
    gate.along = at.along;
  }
  for (const Arrivals& at : barriers_) {
    const auto of_groups = at_place(groups, &CrossingTally::barriers_, summary.barriers.size());
    BarrierSummary& barrier = summary.barriers.emplace_back();
    for (std::size_t s = 0; s < barrier.counts.size(); ++s) barrier.counts[s] = at.of_all.counted(s);
    barrier.not_reached = at.of_all.rocks() - barrier.count(BarrierShare::reached);
    if (told == Told::counts) continue;
    for (std::size_t s = 0; s < barrier.shares.size(); ++s) barrier.shares[s] = at.shares(s, of_groups);
    const bool open = at.of_all.open() > 0;
    barrier.energy = lower_bounds(at.energy, open);
    barrier.height = lower_bounds(at.height, open);
    barrier.energy_intervals = intervals_of(at.energy);
    barrier.height_intervals = intervals_of(at.height);
  }
  if (told == Told::all) summary.caught = caught_.of_rocks();
  return summary;
}

CrossingTallies::CrossingTallies(const Scenario& scenario)
    : is_empty_(scenario.gates.empty() && scenario.barriers.empty()) {
  const std::size_t groups = group_names(scenario).size();
  tallies_.assign(groups > 1 ? 1 + groups : 1, {scenario.gates.size(), scenario.barriers.size()});
}

void CrossingTallies::add(const TrialRecords& chunk) {
  if (is_empty_) return;
  std::size_t gate = 0, barrier = 0;
  for (const RockRecord& rock : chunk.rocks) {
    const auto gates = rows_of_rock(chunk.gates, gate, rock);
    const auto barriers = rows_of_rock(chunk.barriers, barrier, rock);
    if (is_fault(rock.reason)) continue;
    tallies_.front().add(rock, gates, barriers);
    if (tallies_.size() > 1) tallies_.at(1 + static_cast<std::size_t>(rock.group)).add(rock, gates, barriers);
  }
}

bool CrossingTallies::needs_another_pass() {
  bool more = false;
  for (CrossingTally& tally : tallies_) more |= tally.needs_another_pass();
  return more;
}

std::vector<CrossingSummary> CrossingTallies::summaries(Told told) const {
  std::vector<CrossingSummary> summaries;
  const std::span groups = std::span(tallies_).subspan(1);
  summaries.push_back(tallies_.front().summary(told, groups));
  for (const CrossingTally& group : groups) summaries.push_back(group.summary(told));
  return summaries;
}

}  // namespace flyrock
