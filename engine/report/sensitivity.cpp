#include "report/sensitivity.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "batch/rank_correlation.h"
#include "report/rounded.h"

namespace flyrock {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_rocks = 10'000;
constexpr int derived = 2;  // numbers that follow from draws
constexpr std::size_t tenths = 10;
constexpr std::size_t least_in_tenth = 10;  // fewer rocks have no p10

/// Of sorted values, the one that `share` of them do not exceed.
double at_share(const std::vector<double>& values, double share) {
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

/// The runout over one number, tenth by tenth; rocks of one value stay together. Null where there are too few rocks or values.
Json curve_data(const std::vector<double>& values, const std::vector<double>& runout) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return values[i] < values[j]; });
  Json x = Json::array(), low = Json::array(), middle = Json::array(), high = Json::array();
  std::size_t begin = 0;
  for (std::size_t tenth = 1; tenth <= tenths; ++tenth) {
    std::size_t end = order.size() * tenth / tenths;
    while (end > begin && end < order.size() && values[order[end]] == values[order[end - 1]]) ++end;
    if (end <= begin || end - begin < least_in_tenth) continue;
    std::vector<double> within;
    for (std::size_t i = begin; i < end; ++i) within.push_back(runout[order[i]]);
    std::sort(within.begin(), within.end());
    x.push_back(rounded(values[order[(begin + end - 1) / 2]]));
    low.push_back(rounded(at_share(within, 0.1)));
    middle.push_back(rounded(at_share(within, 0.5)));
    high.push_back(rounded(at_share(within, 0.9)));
    begin = end;
  }
  if (x.size() < 2) return nullptr;
  return {{"x", x}, {"low", low}, {"middle", middle}, {"high", high}};
}

}  // namespace

Sensitivity::Sensitivity(const Scenario& scenario) : blast_(scenario.blast), groups_(scenario.rocks.size()) {
  for (const Draw& draw : scenario.draws) names_.push_back(draw.stream);
  names_.insert(names_.end(), {"blast: charge per hole in kg", "blast: powder factor in kg/m3"});
}

/// What the blast of one rock, whose drawn numbers are given, makes of them; where a draw of it is missing, nothing.
void Sensitivity::add_derived(const std::map<int, double>& drawn, Group& group) const {
  if (!blast_) return;
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
    return;  // the rock has failed for it
  }
  const BlastDesign design = design_of(blast, blast_->pattern);
  const int first = static_cast<int>(names_.size()) - derived;
  if (!std::isnan(design.charge_per_hole)) group.inputs[first].push_back(design.charge_per_hole);
  if (!std::isnan(design.powder_factor)) group.inputs[first + 1].push_back(design.powder_factor);
}

void Sensitivity::see(const TrialRecords& chunk) {
  auto input = chunk.inputs.begin();
  for (const RockRecord& rock : chunk.rocks) {
    const auto first = input;
    input = std::find_if(first, chunk.inputs.end(),
                         [&](const InputRecord& i) { return i.trial != rock.trial || i.rock != rock.rock; });
    if (is_fault(rock.reason) || static_cast<std::size_t>(rock.group) >= groups_.size()) continue;
    Group& group = groups_[static_cast<std::size_t>(rock.group)];
    if (group.runout.size() == most_rocks) continue;
    group.runout.push_back(rock.runout);
    std::map<int, double> drawn;
    for (auto i = first; i != input; ++i) drawn[i->draw] = i->value;
    for (const auto& [draw, value] : drawn) group.inputs[draw].push_back(value);
    add_derived(drawn, group);
  }
}

Json Sensitivity::group_data(const Group& group) const {
  struct Line {
    std::string path;
    RankCorrelation found;
    Json curve;
  };
  std::vector<Line> lines;
  if (group.runout.size() >= least_pairs)
    for (const auto& [draw, values] : group.inputs)
      if (values.size() == group.runout.size())  // a population may draw a number for some of its rocks only
        if (const RankCorrelation found = rank_correlation(values, group.runout, stated_confidence); !std::isnan(found.r))
          lines.push_back({names_.at(static_cast<std::size_t>(draw)), found, curve_data(values, group.runout)});
  std::stable_sort(lines.begin(), lines.end(),
                   [](const Line& a, const Line& b) { return std::abs(a.found.r) > std::abs(b.found.r); });
  auto inputs = Json::array();
  for (const Line& line : lines)
    inputs.push_back({{"path", line.path},
                      {"r", rounded(line.found.r)},
                      {"lower", rounded(line.found.lower)},
                      {"upper", rounded(line.found.upper)},
                      {"curve", line.curve}});
  return {{"count", group.runout.size()}, {"inputs", inputs}};
}

Json Sensitivity::data() const {
  auto list = Json::array();
  for (const Group& group : groups_) list.push_back(group_data(group));
  return list;
}

}  // namespace flyrock
