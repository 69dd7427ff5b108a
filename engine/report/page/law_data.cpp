#include "report/page/law_data.h"

#include <nlohmann/json.hpp>

#include "report/page/rounded.h"

namespace flyrock {

namespace {

using Json = nlohmann::ordered_json;

Json rounded_all(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(rounded(value));
  return list;
}

}  // namespace

Json law_data(const Scenario& scenario, const LawSubject& subject) {
  Json graphs = Json::array();
  for (const MaterialGraph& graph : material_graphs(scenario, subject)) {
    Json curves = Json::array();
    for (const MaterialCurve& curve : graph.curves) {
      Json data = {{"name", curve.name}, {"middle", rounded_all(curve.middle)}};
      if (graph.drawn) data["low"] = rounded_all(curve.low), data["high"] = rounded_all(curve.high);
      curves.push_back(std::move(data));
    }
    graphs.push_back({{"material", graph.material},
                      {"kind", graph.kind},
                      {"law", graph.law},
                      {"doc", graph.doc},
                      {"source", graph.source},
                      {"x", graph.x},
                      {"y", graph.y},
                      {"speed", rounded_all(graph.speed)},
                      {"curves", curves},
                      {"drawn", graph.drawn},
                      {"fault", graph.fault}});
  }
  return {{"mass", rounded(subject.mass)}, {"radius", rounded(subject.radius)}, {"graphs", graphs}};
}

}  // namespace flyrock
