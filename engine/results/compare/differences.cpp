#include "results/compare/differences.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <compare>
#include <map>

#include "results/measured/lost.h"
#include "results/measured/rows_of_rock.h"
#include "results/say/wording.h"
#include "scenario/plan.h"

namespace flyrock {

namespace {

/// Rocks of point 0 that are in memory at a time. A run with more takes more passes.
constexpr std::size_t most_rocks_in_memory = 50'000;

/// Which rock of all points is the same.
struct PairKey {
  std::uint64_t trial = 0;
  int group = 0;
  int in_group = 0;  ///< number in its group and trial
  auto operator<=>(const PairKey&) const = default;
};

/// On which side of a number the true one may lie.
enum class Truth { is_it, is_above, is_below };

/// A rock's number, or of a share 1 or 0. Of a censored rock where it was last seen.
struct ComparedValue {
  double value = 0;
  Truth truth = Truth::is_it;
};

/// The numbers of a rock, in the order of compared_numbers().
struct ComparedRock {
  PairKey key;
  bool is_sound = true;
  std::vector<ComparedValue> numbers;
};

ComparedValue compared(const RockRecord& rock, const RockStatistic& number) {
  if (bounded(rock, number).censored) return {number.of(rock), Truth::is_above};
  const bool goes_down = number.column.along_x && rock.censored && rock.stop_x < rock.start_x;
  return {number.of(rock), goes_down ? Truth::is_below : Truth::is_it};
}

/// What may still become 1.
ComparedValue share_value(bool counts, bool is_open) {
  return {counts ? 1.0 : 0.0, !counts && is_open ? Truth::is_above : Truth::is_it};
}

/// Which bound a - b is.
DifferenceBound bound_of(Truth a, Truth b) {
  if (a == Truth::is_it && b == Truth::is_it) return DifferenceBound::none;
  if (a != Truth::is_below && b != Truth::is_above) return DifferenceBound::at_least;
  if (a != Truth::is_above && b != Truth::is_below) return DifferenceBound::at_most;
  return DifferenceBound::not_known;
}

class ComparedReader {
 public:
  explicit ComparedReader(const Scenario& scenario) : scenario_(scenario) {}

  /// The rocks of a chunk, sorted by key.
  std::vector<ComparedRock> read(const TrialRecords& chunk) const {
    std::vector<ComparedRock> rocks;
    std::map<std::pair<std::uint64_t, int>, int> in_group;
    std::size_t gate = 0, barrier = 0;
    for (const RockRecord& rock : chunk.rocks) {
      const auto gates = rows_of_rock(chunk.gates, gate, rock);
      const auto barriers = rows_of_rock(chunk.barriers, barrier, rock);
      ComparedRock& read = rocks.emplace_back();
      read.key = {rock.trial, rock.group, in_group[{rock.trial, rock.group}]++};
      read.is_sound = !is_fault(rock.reason);
      for (const RockStatistic& number : rock_statistics) read.numbers.push_back(compared(rock, number));
      add_gates(rock, gates, read.numbers);
      add_barriers(rock, barriers, read.numbers);
    }
    std::sort(rocks.begin(), rocks.end(),
              [](const ComparedRock& a, const ComparedRock& b) { return a.key < b.key; });
    return rocks;
  }

 private:
  void add_gates(const RockRecord& rock, std::span<const GateRecord> rows,
                 std::vector<ComparedValue>& numbers) const {
    for (std::size_t g = 0; g < scenario_.gates.size(); ++g) {
      const bool passed = std::any_of(rows.begin(), rows.end(), [&](const GateRecord& row) {
        return static_cast<std::size_t>(row.passage.gate) == g;
      });
      numbers.push_back(share_value(passed, may_still_arrive(rock, rock.decided_gates, g)));
    }
  }

  void add_barriers(const RockRecord& rock, std::span<const BarrierRecord> rows,
                    std::vector<ComparedValue>& numbers) const {
    for (std::size_t b = 0; b < scenario_.barriers.size(); ++b) {
      const auto row = std::find_if(rows.begin(), rows.end(), [&](const BarrierRecord& each) {
        return static_cast<std::size_t>(each.hit.barrier) == b;
      });
      const bool reached = row != rows.end();
      const bool is_open = !reached && may_still_arrive(rock, rock.decided_barriers, b);
      for (std::size_t s = 0; s < barrier_share_names.size(); ++s)
        numbers.push_back(
            share_value(reached && counts(static_cast<BarrierShare>(s), row->hit.outcome), is_open));
    }
  }

  static bool counts(BarrierShare share, BarrierOutcome outcome) {
    if (share == BarrierShare::reached) return true;
    if (share == BarrierShare::past) return outcome != BarrierOutcome::caught;
    return static_cast<std::size_t>(share) == static_cast<std::size_t>(outcome);
  }

  const Scenario& scenario_;
};

/// Sums over the pairs of one number. Differences are counted from the first one, so that large means lose no
/// digits.
class PairSums {
 public:
  void add(const ComparedValue& at_0, const ComparedValue& at_k, std::uint64_t trial) {
    const DifferenceBound bound = bound_of(at_k.truth, at_0.truth);
    censored_ += bound != DifferenceBound::none;
    at_least_ += bound == DifferenceBound::at_least;
    at_most_ += bound == DifferenceBound::at_most;
    if (bound == DifferenceBound::not_known)
      ++left_out_;
    else
      add(at_k.value - at_0.value, trial);
  }

  Difference result() {
    Difference result = mean_and_interval();
    result.censored = censored_;
    result.left_out = left_out_;
    result.bound = bound();
    const Interval none{unknown, unknown, result.interval.design_effect, result.interval.trials_needed};
    if (result.has_many_censored() || result.bound == DifferenceBound::not_known) result.interval = none;
    if (result.bound == DifferenceBound::not_known) result.mean = unknown;
    return result;
  }

 private:
  DifferenceBound bound() const {
    if (left_out_ > 0 || (at_least_ > 0 && at_most_ > 0)) return DifferenceBound::not_known;
    if (at_least_ > 0) return DifferenceBound::at_least;
    return at_most_ > 0 ? DifferenceBound::at_most : DifferenceBound::none;
  }

  void add(double difference, std::uint64_t trial) {
    if (in_trial_ > 0 && trial != trial_) end_trial();
    if (pairs_ == 0 && in_trial_ == 0) first_ = difference;
    trial_ = trial;
    ++in_trial_;
    const double from_first = difference - first_;
    of_trial_ += from_first;
    squares_ += from_first * from_first;
    differs_ = differs_ || difference != 0;
  }

  Difference mean_and_interval() {
    end_trial();
    Difference result{.pairs = pairs_, .differing = differing_};
    if (pairs_ == 0) return result;
    const double n = static_cast<double>(pairs_), m = static_cast<double>(trials_);
    const double mean = sum_ / n;
    result.mean = first_ + mean;
    const bool is_clustered = pairs_ > trials_;
    if (is_clustered || differing_ < trials_)
      result.interval.trials_needed = trials_needed(differing_, trials_);
    if (differing_ == 0) result.interval.trials_needed = 0;  // there is nothing to be uncertain of
    if (trials_ < 2 || differing_ == 0 || result.interval.trials_needed > 0) return result;
    const double spread = std::max(0.0, trial_squares_ - 2 * mean * trial_products_ + mean * mean * counts_);
    const double clustered = m / (m - 1) * spread / (n * n);
    const double independent = std::max(0.0, squares_ - n * mean * mean) / (n - 1) / n;
    if (is_clustered && independent > 0)
      result.interval.design_effect = std::max(1.0, clustered / independent);
    const boost::math::students_t_distribution<> student(m - 1);
    const double t = boost::math::quantile(boost::math::complement(student, 0.5 * (1 - stated_confidence)));
    const double half = t * std::sqrt(std::max(clustered, independent));
    result.interval.lower = result.mean - half;
    result.interval.upper = result.mean + half;
    return result;
  }

  void end_trial() {
    if (in_trial_ == 0) return;
    const double n = static_cast<double>(in_trial_);
    ++trials_;
    pairs_ += in_trial_;
    differing_ += differs_;
    sum_ += of_trial_;
    trial_squares_ += of_trial_ * of_trial_;
    trial_products_ += of_trial_ * n;
    counts_ += n * n;
    in_trial_ = 0;
    of_trial_ = 0;
    differs_ = false;
  }

  std::uint64_t pairs_ = 0, trials_ = 0, differing_ = 0;
  std::uint64_t censored_ = 0, left_out_ = 0, at_least_ = 0, at_most_ = 0;  ///< pairs
  double first_ = 0, sum_ = 0, squares_ = 0;
  double trial_squares_ = 0, trial_products_ = 0, counts_ = 0;  ///< sums of S_t^2, S_t n_t, n_t^2
  // The open trial:
  std::uint64_t trial_ = 0, in_trial_ = 0;
  double of_trial_ = 0;
  bool differs_ = false;
};

/// The pairs of a group, or of all rocks, of one point.
struct GroupPairs {
  explicit GroupPairs(std::size_t numbers) : sums(numbers) {}

  std::uint64_t rocks = 0, paired = 0;  ///< of both points; pairs of sound rocks
  std::vector<PairSums> sums;

  void add(const ComparedRock& at_0, const ComparedRock& at_k) {
    ++paired;
    for (std::size_t i = 0; i < sums.size(); ++i)
      sums[i].add(at_0.numbers[i], at_k.numbers[i], at_0.key.trial);
  }
};

/// All pairs of one point with point 0.
class PointPairs {
 public:
  PointPairs(std::size_t groups, std::size_t numbers)
      : groups_(groups > 1 ? 1 + groups : 1, GroupPairs(numbers)) {}

  /// Counts a rock of either point.
  void see(const ComparedRock& rock) {
    each_group(rock, [](GroupPairs& group) { ++group.rocks; });
  }
  void add(const ComparedRock& at_0, const ComparedRock& at_k) {
    if (!at_0.is_sound || !at_k.is_sound) return;
    each_group(at_0, [&](GroupPairs& group) { group.add(at_0, at_k); });
  }

  std::vector<PointDifferences::Group> results(const std::vector<std::string>& names) {
    std::vector<PointDifferences::Group> list;
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      GroupPairs& pairs = groups_[g];
      PointDifferences::Group& group = list.emplace_back();
      if (g > 0) group.name = names[g - 1];
      group.unpaired = pairs.rocks - 2 * pairs.paired;
      for (PairSums& sums : pairs.sums) group.numbers.push_back(sums.result());
    }
    return list;
  }

 private:
  template <class Do>
  void each_group(const ComparedRock& rock, Do act) {
    act(groups_.front());
    if (groups_.size() > 1) act(groups_.at(1 + static_cast<std::size_t>(rock.key.group)));
  }
  std::vector<GroupPairs> groups_;
};

/// Consecutive trials of point 0.
struct TrialBlock {
  std::vector<ComparedRock> rocks;
  std::uint64_t from = 0, until = 0;  ///< trials; until is not among them
  bool is_last = true;

  bool has(std::uint64_t trial) const { return trial >= from && (is_last || trial < until); }
};

/// The trials from `from` on, as many whole chunks as there is room for.
TrialBlock block_of(const Rows& rows, const ComparedReader& reader, std::uint64_t from) {
  TrialBlock block{.rocks = {}, .from = from, .until = from};
  rows(Part::brief, [&](const TrialRecords& chunk) {
    if (chunk.rocks.empty() || chunk.rocks.back().trial < from) return;
    if (!block.rocks.empty() && block.rocks.size() + chunk.rocks.size() > most_rocks_in_memory)
      block.is_last = false;
    if (!block.is_last) return;
    for (ComparedRock& rock : reader.read(chunk))
      if (rock.key.trial >= from) block.rocks.push_back(std::move(rock));
    block.until = chunk.rocks.back().trial + 1;
  });
  return block;
}

/// Adds the pairs of a point with the rocks of a block.
void add_pairs(const Rows& rows, const ComparedReader& reader, const TrialBlock& block, PointPairs& pairs) {
  for (const ComparedRock& rock : block.rocks) pairs.see(rock);
  rows(Part::brief, [&](const TrialRecords& chunk) {
    if (chunk.rocks.empty() || !(block.has(chunk.rocks.front().trial) || block.has(chunk.rocks.back().trial)))
      return;
    for (const ComparedRock& rock : reader.read(chunk)) {
      if (!block.has(rock.key.trial)) continue;
      pairs.see(rock);
      const auto partner =
          std::lower_bound(block.rocks.begin(), block.rocks.end(), rock.key,
                           [](const ComparedRock& other, const PairKey& key) { return other.key < key; });
      if (partner != block.rocks.end() && partner->key == rock.key) pairs.add(*partner, rock);
    }
  });
}

/// Why there are no differences of a point; empty if there are.
std::string why_none(const Plan& plan, const std::vector<PointResult>& points, std::size_t point) {
  for (const std::size_t p : {std::size_t{0}, point}) {
    if (!plan.points[p].output.rocks) return "rows";
    if (has_lost(plan.points[p], points[p])) return "lost";
  }
  return "";
}

}  // namespace

std::string difference_text(const Difference& difference) {
  const std::string of_pairs =
      fmt::format("{} of {} pairs", difference.censored, difference.pairs + difference.left_out);
  if (difference.bound == DifferenceBound::not_known)
    return fmt::format("not known: {} are censored, and bound it neither from below nor from above",
                       of_pairs);
  if (std::isnan(difference.mean)) return "";
  const char* bound = difference.bound == DifferenceBound::at_least  ? ">= "
                      : difference.bound == DifferenceBound::at_most ? "<= "
                                                                     : "";
  const std::string text =
      fmt::format("{}{}{} m", bound, difference.mean > 0 ? "+" : "", three_digits(difference.mean));
  std::vector<std::string> notes;
  if (difference.differing == 0)
    notes.push_back("no pair differs");
  else if (difference.interval.trials_needed > 0)
    notes.push_back("too few trials that differ");
  else if (!std::isnan(difference.interval.lower))
    notes.push_back(fmt::format("95 % interval {} to {} m", three_digits(difference.interval.lower),
                                three_digits(difference.interval.upper)));
  if (difference.censored > 0)
    notes.push_back(fmt::format("{} are censored: they count where the rocks were last seen", of_pairs));
  return notes.empty() ? text : fmt::format("{} ({})", text, fmt::join(notes, "; "));
}

std::vector<ComparedNumber> compared_numbers(const Scenario& scenario) {
  std::vector<ComparedNumber> list;
  for (const RockStatistic& number : rock_statistics)
    list.push_back({std::string(number.name()), number.column.unit});
  for (const GatePlan& gate : scenario.gates) list.push_back({"gate." + gate.name + ".passed", ""});
  for (const BarrierPlan& barrier : scenario.barriers)
    for (const std::string_view share : barrier_share_names)
      list.push_back({"barrier." + barrier.name + "." + std::string(share), ""});
  return list;
}

std::vector<PointDifferences> make_differences(const Plan& plan, const std::vector<PointResult>& points,
                                               const std::vector<Rows>& rows) {
  std::vector<PointDifferences> list;
  const Scenario& first = plan.points.front();
  if (points.size() < 2 || !first.bodies.empty()) return list;
  const std::vector<std::string> names = group_names(first);
  const ComparedReader reader(first);
  std::vector<PointPairs> pairs(points.size(), PointPairs(names.size(), compared_numbers(first).size()));
  for (std::size_t p = 1; p < points.size(); ++p)
    list.push_back({.point = p, .groups = {}, .reason = why_none(plan, points, p)});
  const bool any =
      std::any_of(list.begin(), list.end(), [](const auto& each) { return each.reason.empty(); });
  for (std::uint64_t from = 0; any;) {
    const TrialBlock block = block_of(rows.front(), reader, from);
    for (PointDifferences& of_point : list)
      if (of_point.reason.empty()) add_pairs(rows[of_point.point], reader, block, pairs[of_point.point]);
    if (block.is_last) break;
    from = block.until;
  }
  for (PointDifferences& of_point : list)
    if (of_point.reason.empty()) of_point.groups = pairs[of_point.point].results(names);
  return list;
}

}  // namespace flyrock
