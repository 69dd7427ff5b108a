#include "report/sensitivity.h"

#include <algorithm>
#include <cmath>

#include "batch/rank_correlation.h"
#include "report/rounded.h"

namespace flyrock {

namespace {

constexpr std::size_t most_rocks = 10'000;

}  // namespace

Sensitivity::Sensitivity(const Scenario& scenario) : groups_(scenario.rocks.size()) {
  for (const Draw& draw : scenario.draws) names_.push_back(draw.stream);
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
    for (auto i = first; i != input; ++i) group.inputs[i->draw].push_back(i->value);
  }
}

nlohmann::ordered_json Sensitivity::group_data(const Group& group) const {
  struct Line {
    std::string path;
    RankCorrelation found;
  };
  std::vector<Line> lines;
  if (group.runout.size() >= least_pairs)
    for (const auto& [draw, values] : group.inputs)
      if (values.size() == group.runout.size())  // a population may draw a number for some of its rocks only
        if (const RankCorrelation found = rank_correlation(values, group.runout, stated_confidence); !std::isnan(found.r))
          lines.push_back({names_.at(static_cast<std::size_t>(draw)), found});
  std::stable_sort(lines.begin(), lines.end(),
                   [](const Line& a, const Line& b) { return std::abs(a.found.r) > std::abs(b.found.r); });
  auto inputs = nlohmann::ordered_json::array();
  for (const Line& line : lines)
    inputs.push_back({{"path", line.path},
                      {"r", rounded(line.found.r)},
                      {"lower", rounded(line.found.lower)},
                      {"upper", rounded(line.found.upper)}});
  return {{"count", group.runout.size()}, {"inputs", inputs}};
}

nlohmann::ordered_json Sensitivity::data() const {
  auto list = nlohmann::ordered_json::array();
  for (const Group& group : groups_) list.push_back(group_data(group));
  return list;
}

}  // namespace flyrock
