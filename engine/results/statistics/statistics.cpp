#include "results/statistics/statistics.h"

#include "results/statistics/unknown.h"

namespace flyrock {

namespace {

std::array<double, 4> shares_of(std::array<double, 4> parts) {
  double sum = 0;
  for (const double part : parts) sum += part;
  for (double& part : parts) part = sum > 0 ? part / sum : unknown;
  return parts;
}

constexpr std::array<std::pair<Statistic, double>, 6> percents = {{{Statistic::min, 0},
                                                                   {Statistic::max, 1},
                                                                   {Statistic::p50, 0.50},
                                                                   {Statistic::p90, 0.90},
                                                                   {Statistic::p95, 0.95},
                                                                   {Statistic::p99, 0.99}}};

/// Minimum and maximum have no interval.
bool has_interval(double p) { return p > 0 && p < 1; }

}  // namespace

Bounded bounded(const RockRecord& rock, const RockStatistic& number) {
  const KnownFrom known = number.column.known;
  const bool is_known = known == KnownFrom::start || (known == KnownFrom::landing && rock.landed) ||
                        (number.column.along_x && rock.stop_x < rock.start_x);
  return {number.of(rock), rock.censored && !is_known};
}

Questions stated_questions() {
  Questions questions;
  for (const auto& [which, p] : percents) {
    questions.quantiles.push_back(p);
    if (has_interval(p)) questions.intervals.push_back({p, stated_confidence});
  }
  return questions;
}

Statistics statistics_of(const Sample& sample) {
  Statistics result;
  const auto [mean, sd] = sample.moments();
  result[static_cast<int>(Statistic::mean)] = {mean, sample.any_censored()};
  result[static_cast<int>(Statistic::sd)] = {sd, sample.any_censored()};
  for (const auto& [which, p] : percents) result[static_cast<int>(which)] = sample.quantile(p);
  return result;
}

Intervals intervals_of(const Sample& sample) {
  Intervals result;
  result.fill({unknown, unknown});
  result[static_cast<int>(Statistic::mean)] = sample.mean_interval(stated_confidence);
  for (const auto& [which, p] : percents)
    if (has_interval(p)) result[static_cast<int>(which)] = sample.quantile_interval(p, stated_confidence);
  return result;
}

GroupTally::GroupTally(const std::string& name, std::uint64_t unit) : name_(name), unit_(unit) {
  Questions questions = stated_questions();
  questions.are_replicates = unit > 1;
  samples_.assign(rock_statistic_count, Sample(questions));
}

void GroupTally::add(const RockRecord& rock) {
  const bool fault = is_fault(rock.reason);
  if (!counted_) {
    weights_.add(rock.weight);
    reasons_.add(rock.trial, rock.weight);
    reasons_.count(static_cast<std::size_t>(rock.reason));
    if (!fault) {
      weight_ += rock.weight;
      censored_.add(rock.trial, rock.weight);
      if (rock.censored) censored_.count();
    }
    for (std::size_t m = 0; m < travel_mode_names.size() && !fault; ++m)
      travel_.add(static_cast<TravelMode>(m), rock.weight * rock.travel.time[m],
                  rock.weight * rock.travel.distance[m]);
  }
  for (std::size_t q = 0; q < samples_.size() && !fault; ++q)
    samples_[q].add(bounded(rock, rock_statistics[q]), rock.trial / unit_, rock.weight);
}

bool GroupTally::needs_another_pass() {
  counted_ = true;
  reasons_.close();
  censored_.close();
  bool more = false;
  for (Sample& sample : samples_) more |= sample.needs_another_pass();
  return more;
}

RunoutExtent GroupTally::runout_extent() const {
  const Sample& runout = samples_[rock_statistic("runout")];
  return {.count = censored_.rocks(),
          .is_weighted = weights_.differ(),
          .weight = weight_,
          .least = runout.least(),
          .greatest = runout.greatest()};
}

GroupSummary GroupTally::summary(Told told) const {
  GroupSummary summary;
  summary.name = name_;
  summary.count = reasons_.rocks();
  summary.faults = reasons_.rocks() - censored_.rocks();
  summary.censored = censored_.counted();
  summary.weights = weights_;
  for (std::size_t r = 0; r < stop_reasons; ++r) summary.reasons[r] = reasons_.counted(r);
  if (told == Told::counts) return summary;
  summary.weight = weight_;
  for (std::size_t r = 0; r < stop_reasons; ++r) summary.reason_shares[r] = reasons_.of_rocks(r);
  summary.censored_share = censored_.of_rocks();
  if (censored_.rocks() == 0) summary.censored_share.value = 0;
  summary.time_share = shares_of(travel_.time);
  summary.distance_share = shares_of(travel_.distance);
  for (std::size_t q = 0; q < samples_.size(); ++q) {
    summary.statistics[q] = statistics_of(samples_[q]);
    summary.intervals[q] = intervals_of(samples_[q]);
  }
  return summary;
}

RockTally::RockTally(const std::vector<std::string>& groups, std::uint64_t unit)
    : tallies_{GroupTally("", unit)} {
  if (groups.size() > 1)
    for (const std::string& group : groups) tallies_.emplace_back(group, unit);
}

void RockTally::add(const TrialRecords& chunk) {
  for (const RockRecord& rock : chunk.rocks) {
    tallies_.front().add(rock);
    if (tallies_.size() > 1) tallies_.at(1 + static_cast<std::size_t>(rock.group)).add(rock);
  }
}

bool RockTally::needs_another_pass() {
  bool more = false;
  for (GroupTally& tally : tallies_) more |= tally.needs_another_pass();
  return more;
}

std::vector<RunoutExtent> RockTally::runout_extents() const {
  std::vector<RunoutExtent> extents;
  for (const GroupTally& tally : tallies_) extents.push_back(tally.runout_extent());
  return extents;
}

std::vector<GroupSummary> RockTally::summaries(Told told) const {
  std::vector<GroupSummary> summaries;
  for (const GroupTally& tally : tallies_) summaries.push_back(tally.summary(told));
  return summaries;
}

}  // namespace flyrock
