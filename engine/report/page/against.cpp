#include "report/page/against.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace flyrock {

namespace {

using Json = nlohmann::ordered_json;

/// Adds the leaves of a scenario: "rocks.face.launch.k" -> "27".
void collect(const Json& value, const std::string& path,
             std::vector<std::pair<std::string, std::string>>& leaves) {
  const auto below = [&](const std::string& key) { return path.empty() ? key : path + "." + key; };
  if (value.is_object()) {
    for (const auto& [key, inner] : value.items()) collect(inner, below(key), leaves);
  } else if (value.is_array() && !value.empty() && value.front().is_object()) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      const auto name = value[i].find("name");
      collect(
          value[i],
          below(name != value[i].end() && name->is_string() ? name->get<std::string>() : std::to_string(i)),
          leaves);
    }
  } else {
    leaves.emplace_back(path, value.is_string() ? value.get<std::string>() : value.dump());
  }
}

Json inputs_that_differ(const Json& before, const Json& now) {
  std::vector<std::pair<std::string, std::string>> old_leaves, leaves;
  collect(before, "", old_leaves);
  collect(now, "", leaves);
  const std::map<std::string, std::string> old_ones(old_leaves.begin(), old_leaves.end()),
      new_ones(leaves.begin(), leaves.end());
  Json list = Json::array();
  for (const auto& [path, text] : leaves) {
    const auto old = old_ones.find(path);
    if (old == old_ones.end() || old->second != text)
      list.push_back({{"path", path},
                      {"before", old == old_ones.end() ? Json(nullptr) : Json(old->second)},
                      {"now", text}});
  }
  for (const auto& [path, text] : old_leaves)
    if (!new_ones.contains(path)) list.push_back({{"path", path}, {"before", text}, {"now", nullptr}});
  return list;
}

struct Shown {
  std::string unit;
  Json value, interval, lower_bound;
};
using Numbers = std::vector<std::pair<std::string, Shown>>;

void add_share(const std::string& what, const Json& share, Numbers& numbers) {
  numbers.push_back({what, {"", share.at("share"), share.at("interval"), share.at("lower_bound")}});
}

/// Whether a statistic is a lower bound: `lower_bounds` lists the names of those.
bool is_bound(const Json& statistics, const std::string& name) {
  const Json& bounds = statistics.at("lower_bounds");
  return std::find(bounds.begin(), bounds.end(), Json(name)) != bounds.end();
}

/// The numbers of a sweep point that people act upon.
Numbers numbers_of(const Json& point) {
  Numbers numbers;
  const Json& groups = point.at("rocks");
  for (std::size_t g = groups.size() > 1 ? 1 : 0; g < groups.size(); ++g) {
    const Json& runout = groups[g].at("runout");
    const std::string of =
        groups[g].at("group").is_string() ? " of " + groups[g].at("group").get<std::string>() : "";
    for (const char* statistic : {"p50", "p95", "p99"})
      numbers.push_back({fmt::format("runout {}{}", statistic, of),
                         {"m", runout.at(statistic),
                          runout.at("intervals").value(statistic, Json::array({nullptr, nullptr})),
                          is_bound(runout, statistic)}});
  }
  for (const Json& gate : point.at("gates"))
    add_share("trials that pass gate " + gate.at("gate").get<std::string>(),
              gate.at("shares").at("passed").at("per_trial"), numbers);
  for (const Json& barrier : point.at("barriers"))
    add_share("trials with a rock past barrier " + barrier.at("barrier").get<std::string>(),
              barrier.at("shares").at("past").at("per_trial"), numbers);
  for (const Json& clearance : point.at("clearance"))
    numbers.push_back(
        {"clearance " + clearance.at("clearance").get<std::string>(),
         {"m", clearance.at("distance"), Json::array({clearance.at("lower"), clearance.at("upper")}),
          clearance.at("lower_bound")}});
  if (point.contains("exposure"))
    for (const Json& exposed : point.at("exposure"))
      numbers.push_back(
          {"blasts that hit " + exposed.at("exposure").get<std::string>(),
           {"", exposed.at("per_blast").at("share"), exposed.at("per_blast").at("interval"), false}});
  return numbers;
}

Json number_data(const Shown& number) {
  return {{"value", number.value}, {"interval", number.interval}, {"lower_bound", number.lower_bound}};
}

/// Whether the intervals of two numbers do not overlap; null where an end that would tell is not known.
Json apart(const Json& a, const Json& b) {
  const auto end = [](const Json& interval, std::size_t which) -> std::optional<double> {
    if (!interval.is_array() || interval.size() != 2 || !interval.at(which).is_number()) return std::nullopt;
    return interval.at(which).get<double>();
  };
  const auto lies_below = [&](const Json& one, const Json& other) {
    const std::optional<double> high = end(one, 1), low = end(other, 0);
    return high && low && *high < *low;
  };
  if (lies_below(a, b) || lies_below(b, a)) return true;
  const bool all_known = end(a, 0) && end(a, 1) && end(b, 0) && end(b, 1);
  return all_known ? Json(false) : Json(nullptr);
}

}  // namespace

Json against_data(const RunData& other, const RunData& now) {
  const Numbers old_numbers = numbers_of(other.summary.at("points").at(0));
  Json numbers = Json::array();
  for (const auto& [what, number] : numbers_of(now.summary.at("points").at(0)))
    for (const auto& [name, old] : old_numbers)
      if (name == what)
        numbers.push_back({{"what", what},
                           {"unit", number.unit},
                           {"before", number_data(old)},
                           {"now", number_data(number)},
                           {"apart", apart(old.interval, number.interval)}});
  return {{"title", other.summary.at("title")},
          {"inputs", inputs_that_differ(other.manifest.at("scenario"), now.manifest.at("scenario"))},
          {"numbers", numbers}};
}

}  // namespace flyrock
