#include "report/page/sensitivity.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "batch/inputs.h"
#include "report/page/rounded.h"
#include "results/statistics/unknown.h"

namespace flyrock {

namespace {

using Json = nlohmann::ordered_json;
using TrialInputs = std::vector<InputRecord>::const_iterator;

constexpr std::size_t most_rocks = 10'000;
constexpr std::size_t tenths = 10;
constexpr std::size_t least_in_tenth = 10;  // with fewer rocks there is no p10

/// One rock in a tenth.
struct Weighted {
  double runout, weight;
};

/// The runout that the given share of the rocks does not exceed. Sorted runouts are given.
double at_share(const std::vector<Weighted>& rocks, double share) {
  double all = 0, below = 0;
  for (const Weighted& rock : rocks) all += rock.weight;
  const double wanted = share * (all - all / static_cast<double>(rocks.size()));
  for (const Weighted& rock : rocks) {
    if (below + 0.5 * rock.weight > wanted) return rock.runout;
    below += rock.weight;
  }
  return rocks.back().runout;
}

/// The runout against one number, times `scale`, for each tenth of the rocks. Rocks with equal values stay
/// together. Null if there are too few rocks or values.
Json curve_data(const std::vector<double>& values, double scale, const std::vector<double>& runout,
                const std::vector<double>& weight) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return values[i] < values[j]; });
  Json x = Json::array(), low = Json::array(), middle = Json::array(), high = Json::array();
  std::size_t begin = 0;
  for (std::size_t tenth = 1; tenth <= tenths; ++tenth) {
    std::size_t end = order.size() * tenth / tenths;
    while (end > begin && end < order.size() && values[order[end]] == values[order[end - 1]]) ++end;
    if (end <= begin || end - begin < least_in_tenth) continue;
    std::vector<Weighted> within;
    for (std::size_t i = begin; i < end; ++i) within.push_back({runout[order[i]], weight[order[i]]});
    std::stable_sort(within.begin(), within.end(),
                     [](const Weighted& a, const Weighted& b) { return a.runout < b.runout; });
    x.push_back(rounded(scale * values[order[(begin + end - 1) / 2]]));
    low.push_back(rounded(at_share(within, 0.1)));
    middle.push_back(rounded(at_share(within, 0.5)));
    high.push_back(rounded(at_share(within, 0.9)));
    begin = end;
  }
  if (x.size() < 2) return nullptr;
  return {{"x", x}, {"low", low}, {"middle", middle}, {"high", high}};
}

/// The numbers of one rock: of each that is drawn at impacts the mean.
std::map<int, double> numbers_of(TrialInputs begin, TrialInputs end) {
  struct Mean {
    double sum = 0;
    int count = 0;
  };
  std::map<int, Mean> means;
  for (auto input = begin; input != end; ++input) {
    Mean& mean = means[input->input];
    mean.sum += input->value;
    ++mean.count;
  }
  std::map<int, double> numbers;
  for (const auto& [input, mean] : means) numbers[input] = mean.sum / mean.count;
  return numbers;
}

}  // namespace

Sensitivity::Sensitivity(const Scenario& scenario)
    : inputs_(scenario),
      draws_(static_cast<int>(scenario.draws.size())),
      rank_outcomes_(scenario.output.rank_outcomes),
      groups_(scenario.rocks.size()) {
  for (const Input& input : inputs_of(scenario)) {
    names_.push_back(input.path);
    units_.push_back(readable_unit(input.unit));
  }
  made_of_.resize(derived_count);
  draws_of_blast_.resize(scenario.draws.size());
  if (!scenario.blast) return;
  for (std::size_t d = 0; d < derived_count; ++d)
    made_of_[d] = paths_made_of(*scenario.blast, static_cast<Derived>(d));
  for (const auto& [field, number] : scenario.blast->fields)
    if (!number.is_constant()) {
      const auto draw = static_cast<std::size_t>(number.draw);
      draws_of_blast_[draw] = scenario.draws[draw].stream;
    }
}

bool Sensitivity::is_ranked(std::size_t group, int input) const {
  if (input >= first_derived()) return inputs_.reads(group, static_cast<Derived>(input - first_derived()));
  if (input >= draws_) return rank_outcomes_;
  return inputs_.reads(group, input) && inputs_.was_asked(input);
}

void Sensitivity::add(const TrialRecords& chunk) {
  inputs_.add(chunk.totals);
  auto input = chunk.inputs.begin();
  for (const RockRecord& rock : chunk.rocks) {
    const auto first = input;
    input = std::find_if(first, chunk.inputs.end(),
                         [&](const InputRecord& i) { return i.trial != rock.trial || i.rock != rock.rock; });
    if (rock.branch != 0) continue;  // it does not draw all that the others draw
    if (is_fault(rock.reason) || static_cast<std::size_t>(rock.group) >= groups_.size()) continue;
    Group& group = groups_[static_cast<std::size_t>(rock.group)];
    if (group.runout.size() == most_rocks) continue;
    for (const auto& [name, value] : numbers_of(first, input)) {
      std::vector<double>& values = group.inputs[name];
      values.resize(group.runout.size(), unknown);  // of the rocks before that did not draw it
      values.push_back(value);
    }
    group.rocks.add(rock.trial, rock.weight);
    group.runout.push_back(rock.runout);
  }
}

Sensitivity::Column Sensitivity::column(const Group& group, const std::vector<double>& values) {
  Column known;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isnan(values[i])) continue;
    known.rocks.add(group.rocks.trial[i], group.rocks.weight[i]);
    known.value.push_back(values[i]);
    known.runout.push_back(group.runout[i]);
  }
  return known;
}

/// The ranked inputs of a group, strongest first.
std::vector<Sensitivity::Line> Sensitivity::ranked(std::size_t of_group) const {
  const Group& group = groups_[of_group];
  std::vector<Line> lines;
  for (const auto& [input, values] : group.inputs) {
    if (!is_ranked(of_group, input)) continue;
    Column known = column(group, values);
    if (known.value.size() < least_pairs) continue;
    const RankCorrelation found = rank_correlation(known.value, known.runout, known.rocks);
    if (!std::isnan(found.r)) lines.push_back({input, std::move(known), found});
  }
  std::stable_sort(lines.begin(), lines.end(),
                   [](const Line& a, const Line& b) { return std::abs(a.found.r) > std::abs(b.found.r); });
  return lines;
}

Json Sensitivity::made_of_data(std::size_t group, int input) const {
  if (input < first_derived()) return nullptr;
  Json of = Json::array();
  for (const std::string& path : made_of_[static_cast<std::size_t>(input - first_derived())]) {
    const auto draw = std::find(draws_of_blast_.begin(), draws_of_blast_.end(), path);
    const auto index = static_cast<int>(draw - draws_of_blast_.begin());
    of.push_back({{"path", path}, {"read", draw == draws_of_blast_.end() || inputs_.reads(group, index)}});
  }
  return of;
}

Json Sensitivity::group_data(std::size_t of_group) const {
  const std::vector<Line> lines = ranked(of_group);
  const auto causes = std::count_if(lines.begin(), lines.end(),
                                    [&](const Line& line) { return line.input < first_derived(); });
  const double confidence =
      1 - (1 - stated_confidence) / static_cast<double>(std::max<std::ptrdiff_t>(1, causes));
  auto inputs = Json::array();
  for (const Line& line : lines) {
    const auto input = static_cast<std::size_t>(line.input);
    const Interval interval = line.found.interval(confidence);
    const auto pairs = static_cast<double>(line.column.value.size());
    inputs.push_back({{"path", names_[input]},
                      {"unit", units_[input].name},
                      {"r", rounded(line.found.r)},
                      {"lower", rounded(interval.lower)},
                      {"upper", rounded(interval.upper)},
                      {"design_effect", rounded(pairs / line.found.effective_size)},
                      {"curve", curve_data(line.column.value, units_[input].per_si, line.column.runout,
                                           line.column.rocks.weight)},
                      {"of", made_of_data(of_group, line.input)}});
  }
  Json not_read = Json::array();
  for (std::size_t d = 0; d < draws_of_blast_.size(); ++d)
    if (!draws_of_blast_[d].empty() && !inputs_.reads(of_group, static_cast<int>(d)))
      not_read.push_back(draws_of_blast_[d]);
  return {{"count", groups_[of_group].runout.size()},
          {"confidence", confidence},
          {"inputs", inputs},
          {"not_read", not_read}};
}

Json Sensitivity::data() const {
  auto list = Json::array();
  for (std::size_t group = 0; group < groups_.size(); ++group) list.push_back(group_data(group));
  return list;
}

}  // namespace flyrock
