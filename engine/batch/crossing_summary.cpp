#include "batch/crossing_summary.h"

#include <limits>
#include <map>

namespace flyrock {

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// The rocks that count, and who of them is censored.
class Rocks {
 public:
  explicit Rocks(const std::vector<RockRecord>& rocks) {
    for (const RockRecord& rock : rocks) {
      if (is_fault(rock.reason)) continue;
      censored_[{rock.trial, rock.rock}] = rock.censored;
      censored_count_ += rock.censored;
    }
  }
  bool counts(std::uint64_t trial, int rock) const { return censored_.contains({trial, rock}); }
  bool censored(std::uint64_t trial, int rock) const { return censored_.at({trial, rock}); }
  std::uint64_t censored_count() const { return censored_count_; }
  double share(std::uint64_t count) const {
    return censored_.empty() ? unknown : static_cast<double>(count) / static_cast<double>(censored_.size());
  }

 private:
  std::map<std::pair<std::uint64_t, int>, bool> censored_;
  std::uint64_t censored_count_ = 0;
};

/// The arrivals at one gate or barrier.
struct Arrivals {
  std::vector<Bounded> speed, energy, height;
  std::uint64_t censored = 0;  ///< rocks that arrived and were lost later

  template <class Arrival>
  void add(const Arrival& arrival, bool is_censored) {
    speed.push_back({arrival.speed, false});
    energy.push_back({arrival.kinetic_energy, false});
    height.push_back({arrival.height, false});
    censored += is_censored;
  }
};

Statistics bounded(std::vector<Bounded> values, bool open) {
  Statistics statistics = statistics_of(std::move(values));
  for (Bounded& number : statistics) number.censored = open;
  return statistics;
}

}  // namespace

std::vector<GateSummary> summarise_gates(const TrialRecords& records, std::size_t gates) {
  if (gates == 0) return {};
  const Rocks rocks(records.rocks);
  std::vector<Arrivals> arrivals(gates);
  for (const GateRecord& row : records.gates)
    if (rocks.counts(row.trial, row.rock))
      arrivals.at(row.passage.gate).add(row.passage, rocks.censored(row.trial, row.rock));
  std::vector<GateSummary> summaries;
  for (Arrivals& at : arrivals) {
    const bool open = at.censored < rocks.censored_count();
    GateSummary summary;
    summary.passed = at.speed.size();
    summary.share = {rocks.share(summary.passed), open};
    summary.speed = bounded(std::move(at.speed), open);
    summary.energy = bounded(std::move(at.energy), open);
    summary.height = bounded(std::move(at.height), open);
    summaries.push_back(summary);
  }
  return summaries;
}

std::vector<BarrierSummary> summarise_barriers(const TrialRecords& records, std::size_t barriers) {
  if (barriers == 0) return {};
  const Rocks rocks(records.rocks);
  std::vector<Arrivals> arrivals(barriers);
  std::vector<BarrierSummary> summaries(barriers);
  for (const BarrierRecord& row : records.barriers) {
    if (!rocks.counts(row.trial, row.rock)) continue;
    arrivals.at(row.hit.barrier).add(row.hit, rocks.censored(row.trial, row.rock));
    ++summaries[row.hit.barrier].outcomes[static_cast<int>(row.hit.outcome)];
  }
  for (std::size_t b = 0; b < barriers; ++b) {
    const bool open = arrivals[b].censored < rocks.censored_count();
    BarrierSummary& summary = summaries[b];
    summary.reached = {rocks.share(arrivals[b].speed.size()), open};
    for (std::size_t o = 0; o < summary.outcomes.size(); ++o)
      summary.shares[o] = {rocks.share(summary.outcomes[o]), open};
    summary.energy = bounded(std::move(arrivals[b].energy), open);
    summary.height = bounded(std::move(arrivals[b].height), open);
  }
  return summaries;
}

}  // namespace flyrock
