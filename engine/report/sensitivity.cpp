#include "report/sensitivity.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>
#include <stdexcept>

#include "batch/inputs.h"
#include "report/rounded.h"
#include "results/unknown.h"

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

/// Of sorted runouts, the one that the given share of the rocks does not exceed.
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
    : blast_(scenario.blast),
      inputs_(scenario),
      draws_(static_cast<int>(scenario.draws.size())),
      rank_outcomes_(scenario.output.rank_outcomes),
      groups_(scenario.rocks.size()) {
  for (const Input& input : inputs_of(scenario)) {
    names_.push_back(input.path);
    units_.push_back(readable_unit(input.unit));
  }
  names_.insert(names_.end(), {"blast: charge per hole", "blast: powder factor"});
  units_.insert(units_.end(), {{"kg", 1}, {"kg/m3", 1}});
}

bool Sensitivity::is_ranked(std::size_t group, int input) const {
  if (input >= first_derived())
    return inputs_.reads(group, static_cast<DerivedInput>(input - first_derived()));
  if (input >= draws_) return rank_outcomes_;
  return inputs_.reads(group, input) && inputs_.was_asked(input);
}

/// Adds the numbers that follow from the drawn numbers of one rock. Adds nothing if a draw of its blast is
/// missing.
void Sensitivity::add_derived(std::map<int, double>& drawn) const {
  if (!blast_ || blast_->has_holes()) return;  // measured holes are ranked by their share of the risk
  Blast blast;
  for (const auto& [field, number] : blast_->fields) {
    if (number.is_constant())
      blast[field] = number.constant;
    else if (const auto found = drawn.find(number.draw); found != drawn.end())
      blast[field] = found->second;
    else
      return;
  }
  try {
    complete(blast);
  } catch (const std::invalid_argument&) {
    return;  // the rock failed for this reason
  }
  const BlastDesign design = design_of(blast, blast_->pattern);
  if (!std::isnan(design.charge_per_hole)) drawn[first_derived()] = design.charge_per_hole;
  if (!std::isnan(design.powder_factor)) drawn[first_derived() + 1] = design.powder_factor;
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
    std::map<int, double> numbers = numbers_of(first, input);
    add_derived(numbers);
    for (const auto& [name, value] : numbers) {
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

Json Sensitivity::group_data(std::size_t of_group) const {
  const std::vector<Line> lines = ranked(of_group);
  const double confidence =
      1 - (1 - stated_confidence) / static_cast<double>(std::max<std::size_t>(1, lines.size()));
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
                                           line.column.rocks.weight)}});
  }
  return {{"count", groups_[of_group].runout.size()}, {"confidence", confidence}, {"inputs", inputs}};
}

Json Sensitivity::data() const {
  auto list = Json::array();
  for (std::size_t group = 0; group < groups_.size(); ++group) list.push_back(group_data(group));
  return list;
}

}  // namespace flyrock
