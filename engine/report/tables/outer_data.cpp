#include "report/tables/outer_data.h"

#include <nlohmann/json.hpp>

#include "report/tables/json_object.h"

namespace flyrock {

nlohmann::ordered_json outer_data(const OuterSummary& outer) {
  using Json = nlohmann::ordered_json;
  Json numbers = Json::object();
  for (const OuterNumber& each : outer.numbers) {
    Json& data = numbers[each.measure] = json_object("unit", each.unit, "runs", each.runs);
    Json bounds = Json::array();
    const std::initializer_list<std::pair<const char*, const Bounded&>> statistics = {
        {"mean", each.mean}, {"sd", each.sd},   {"min", each.min}, {"p5", each.p5},
        {"p50", each.p50},   {"p95", each.p95}, {"max", each.max}};
    for (const auto& [name, value] : statistics) {
      data[name] = number(value.value);
      if (value.censored) bounds.push_back(name);
    }
    data["lower_bounds"] = std::move(bounds);
  }
  return json_object("runs", outer.runs, "trials", outer.trials, "lost", outer.lost, "numbers",
                     std::move(numbers));
}

}  // namespace flyrock
