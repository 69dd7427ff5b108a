#include "report/tables/variance_data.h"

#include <nlohmann/json.hpp>

#include "report/tables/json_object.h"

namespace flyrock {

namespace {

using Json = nlohmann::ordered_json;

Json curve_data(const InputResponse& response) {
  Json bins = Json::array();
  for (const ResponseBin& bin : response.curve)
    bins.push_back({{"x", number(bin.x)},
                    {"mean", number(bin.mean)},
                    {"interval", interval_data(bin.mean_interval)},
                    {"p50", number(bin.p50)},
                    {"p50_interval", interval_data(bin.p50_interval)},
                    {"p95", number(bin.p95)},
                    {"p95_interval", interval_data(bin.p95_interval)},
                    {"p99", number(bin.p99)},
                    {"p99_interval", interval_data(bin.p99_interval)},
                    {"trials", bin.trials}});
  return bins;
}

void add_response(Json& line, const NamedResponse* of) {
  const InputResponse none, &response = of ? of->response : none;
  line["p10"] = number(response.p10);
  line["p90"] = number(response.p90);
  line["f_p10"] = number(response.f_p10);
  line["f_p90"] = number(response.f_p90);
  line["f_p10_interval"] = interval_data(response.f_p10_interval);
  line["f_p90_interval"] = interval_data(response.f_p90_interval);
  line["explained"] = number(response.explained);
  line["unit"] = of ? Json(of->unit) : Json(nullptr);
  line["curve"] = curve_data(response);
  if (of && of->crossing)
    line["crossing"] = {{"at", number(of->crossing->at)},
                        {"interval", interval_data(of->crossing->interval)},
                        {"rising", of->crossing->is_rising}};
}

Json number_data(const ExplainedVariance& found, const ExplainedNumber& explained) {
  const SobolIndices& indices = explained.indices;
  Json inputs = Json::array();
  for (const std::size_t i : ranked(indices)) {
    const ExchangedInput& input = found.inputs.inputs[i];
    const SobolIndex& index = indices.inputs[i];
    Json line = {{"stream", input.name},
                 {"first", number(index.first)},
                 {"first_interval", interval_data(index.first_interval)},
                 {"total", number(index.total)},
                 {"total_interval", interval_data(index.total_interval)}};
    add_response(line, explained.responses[i] ? &*explained.responses[i] : nullptr);
    if (input.streams.size() > 1) line["streams"] = input.streams;
    inputs.push_back(std::move(line));
  }
  Json derived = Json::array();
  for (std::size_t d = 0; d < explained.made.size(); ++d) {
    Json line = {{"path", explained.made[d].path}, {"of", explained.made_of[d]}};
    add_response(line, &explained.made[d]);
    derived.push_back(std::move(line));
  }
  Json data = {{"of", explained.of},
               {"unit", explained.unit},
               {"answer", sentences_of(found, explained)},
               {"mean", number(indices.mean)},
               {"variance", number(indices.variance)},
               {"inputs", inputs},
               {"sum_first", number(indices.sum_first)},
               {"sum_total", number(indices.sum_total)},
               {"evaluations", found.evaluations()},
               {"left_out", indices.left_out}};
  if (indices.is_lost()) data["reason"] = "lost";
  data["derived"] = derived;
  if (const auto& map = explained.map) {
    Json means = Json::array();
    for (const std::vector<double>& row : map->map.mean) {
      means.push_back(Json::array());
      for (const double mean : row) means.back().push_back(number(mean));
    }
    data["map"] = {{"x", map->x}, {"y", map->y}, {"x_at", map->map.x}, {"y_at", map->map.y}, {"mean", means}};
  }
  return data;
}

}  // namespace

Json variance_data(const ExplainedVariance& found) {
  Json not_read = Json::array();
  for (const NoInput& input : found.inputs.not_read)
    not_read.push_back({{"stream", input.stream}, {"why", input.why}});
  Json data = {{"flyrock", FLYROCK_ENGINE_VERSION}, {"scenario", found.scenario}, {"title", found.title},
               {"scenario_sha256", found.hash},     {"seed", found.seed},         {"trials", found.trials}};
  data.update(number_data(found, found.numbers.front()));
  data["line"] = found.line ? Json(*found.line) : Json(nullptr);
  data["once_a_run"] = found.inputs.once_a_run;
  data["not_read"] = not_read;
  data["remarks"] = remarks_of(found);
  data["also"] = Json::array();
  for (std::size_t n = 1; n < found.numbers.size(); ++n)
    data["also"].push_back(number_data(found, found.numbers[n]));
  return data;
}

}  // namespace flyrock
