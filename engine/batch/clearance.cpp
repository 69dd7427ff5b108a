#include "batch/clearance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "scenario/build_trial.h"
#include "scenario/node.h"

namespace flyrock {

namespace {

constexpr double beyond = 10;  // rocks that must be expected farther than a clearance

/// The distances of rocks, or of the farthest rock of each trial, that a clearance is of. Returns how many rocks they are of.
std::uint64_t add_distances(const std::vector<RockRecord>& rocks, const ClearancePlan& plan, Sample& sample) {
  const RockQuantity quantity = plan.of_max_distance ? RockQuantity::max_distance : RockQuantity::runout;
  std::uint64_t count = 0;
  std::optional<Bounded> farthest;  // of the trial
  for (std::size_t i = 0; i < rocks.size(); ++i) {
    if (!is_fault(rocks[i].reason) && plan.counts(rocks[i].group)) {
      ++count;
      const Bounded value = quantity_of(rocks[i], quantity);
      if (!plan.per_blast) sample.add(value);
      // A censored rock may have gone farther than the farthest known one.
      farthest = farthest ? Bounded{std::max(farthest->value, value.value), farthest->censored || value.censored} : value;
    }
    if (i + 1 < rocks.size() && rocks[i + 1].trial == rocks[i].trial) continue;
    if (plan.per_blast && farthest) sample.add(*farthest);
    farthest.reset();
  }
  return count;
}

/// Why the trials of a scenario are too few, or an empty text.
std::string too_few(const ClearancePlan& plan, std::uint64_t trials, std::uint64_t rocks_per_trial) {
  const std::uint64_t each = plan.per_blast ? 1 : rocks_per_trial;
  const std::uint64_t needed = needed_for(plan.probability);
  if (each == 0 || trials * each >= needed) return {};
  const std::uint64_t enough = (needed + each - 1) / each;
  return fmt::format(
      "only {:.3g} of {} {} would be beyond the distance, at least {} must be: expected at least {} {}, {}",
      plan.probability * static_cast<double>(trials * each), trials * each, plan.per_blast ? "blasts" : "rocks", beyond,
      needed, plan.per_blast ? "blasts" : "rocks",
      enough <= most_trials ? fmt::format("that is `trials: {}`", enough) : "more than a run may have");
}

/// With sectors the distance is that of the polygon where it reaches farthest. Where another sector is a lower bound, it may reach
/// farther still.
void take_farthest(ClearanceSummary& summary) {
  const SectorSummary* farthest = summary.area.farthest();
  if (!farthest) return;
  summary.distance = farthest->reach();
  summary.interval = farthest->interval;
  for (const SectorSummary& sector : summary.area.sectors) summary.distance.censored |= sector.count > 0 && sector.reach().censored;
}

}  // namespace

std::uint64_t needed_for(double probability) {
  // 10 / 0.07 * 0.07 may be a little less than 10; of a tiny probability it is more than a count can be.
  const double needed = std::ceil(beyond / probability * (1 - 1e-12));
  constexpr auto most = std::uint64_t{1} << 62;
  return needed < static_cast<double>(most) ? static_cast<std::uint64_t>(needed) : most;
}

ClearanceTally::ClearanceTally(const std::vector<ClearancePlan>& plans) : plans_(plans) {
  for (const ClearancePlan& plan : plans_) {
    const double p = 1 - plan.probability;
    samples_.emplace_back(Questions{{p}, {{p, plan.confidence}}});
    rocks_.push_back(0);
    sectors_.emplace_back(plan);
  }
}

void ClearanceTally::see(const TrialRecords& chunk) {
  for (std::size_t c = 0; c < plans_.size(); ++c) {
    const std::uint64_t rocks = add_distances(chunk.rocks, plans_[c], samples_[c]);
    if (!counted_) rocks_[c] += rocks;
    if (plans_[c].sectors > 0) sectors_[c].see(chunk);
  }
}

bool ClearanceTally::again() {
  counted_ = true;
  bool more = false;
  for (Sample& sample : samples_) more |= sample.again();
  for (SectorTally& sectors : sectors_) more |= sectors.again();
  return more;
}

std::vector<ClearanceSummary> ClearanceTally::summaries() const {
  std::vector<ClearanceSummary> summaries;
  for (std::size_t c = 0; c < plans_.size(); ++c) {
    const ClearancePlan& plan = plans_[c];
    ClearanceSummary& summary = summaries.emplace_back();
    summary.count = samples_[c].size();
    summary.rocks = rocks_[c];
    summary.needed = needed_for(plan.probability);
    summary.area = sectors_[c].summary(summary.needed);
    if (!summary.enough()) continue;
    if (plan.sectors > 0) {
      take_farthest(summary);
    } else {
      summary.distance = samples_[c].quantile(1 - plan.probability);
      summary.interval = samples_[c].quantile_interval(1 - plan.probability, plan.confidence);
    }
    if (plan.factor) summary.with_factor = *plan.factor * summary.distance.value;
  }
  return summaries;
}

namespace {

/// How many rocks of each group a trial has; the first stands for all.
std::vector<std::uint64_t> rocks_of_a_trial(const Scenario& scenario) {
  std::vector<std::uint64_t> counts(scenario.rocks.size(), 0);
  const auto count = [&](const auto& trial) {
    for (const TrialRock& rock : trial.rocks) ++counts.at(static_cast<std::size_t>(rock.group));
  };
  if (scenario.dimension == 2)
    count(TrialBuilder<2>(scenario).build(0));
  else
    count(TrialBuilder<3>(scenario).build(0));
  return counts;
}

std::uint64_t rocks_of(const ClearancePlan& plan, const std::vector<std::uint64_t>& groups) {
  if (plan.group >= 0) return groups.at(static_cast<std::size_t>(plan.group));
  return std::accumulate(groups.begin(), groups.end(), std::uint64_t{0});
}

/// What is wrong with a clearance of the scenario's tree.
struct Objections {
  std::string error, warning;
};

void object(const ClearancePlan& plan, std::uint64_t trials, std::uint64_t rocks, bool full, Objections& objections) {
  if (full && objections.error.empty()) objections.error = too_few(plan, trials, rocks);
  if (plan.per_blast && rocks < few_rocks_per_blast && objections.warning.empty())
    objections.warning = fmt::format(
        "the farthest rock of a blast is sought among {} rock{} a blast here: a blast throws thousands, and the farthest of more goes "
        "farther; expected at least {}, or `per: rock`",
        rocks, rocks == 1 ? "" : "s", few_rocks_per_blast);
}

}  // namespace

void check_clearances(const Value& root, const Plan& plan, bool full, Diagnostics& diagnostics) {
  const auto list = Node::root(root).find("clearance");
  if (!list) return;
  const std::vector<Node> items = list->items();
  std::vector<Objections> objections(items.size());
  for (const Scenario& scenario : plan.points) {
    try {
      const std::vector<std::uint64_t> rocks = rocks_of_a_trial(scenario);
      for (std::size_t i = 0; i < items.size(); ++i)
        object(scenario.clearances[i], scenario.trials, rocks_of(scenario.clearances[i], rocks), full, objections[i]);
    } catch (const TrialError&) {
      return;
    }
  }
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (!objections[i].error.empty()) items[i].find("probability")->error(diagnostics, objections[i].error);
    if (objections[i].warning.empty()) continue;
    const Node per = *items[i].find("per");
    diagnostics.warning(per.value->at, per.path, objections[i].warning);
  }
}

}  // namespace flyrock
