#include "report/tables/exposure_data.h"

#include <nlohmann/json.hpp>

#include "report/tables/json_object.h"

namespace flyrock {

namespace {

nlohmann::ordered_json place_data(const ExposurePlan& plan, int dimension) {
  if (plan.line.empty())
    return dimension == 2 ? nlohmann::ordered_json(plan.at.x())
                          : nlohmann::ordered_json({plan.at.x(), plan.at.y()});
  nlohmann::ordered_json line = nlohmann::ordered_json::array();
  for (const Vec2& point : plan.line) line.push_back({point.x(), point.y()});
  return line;
}

}  // namespace

nlohmann::ordered_json bounds_data(const BlastBounds& bounds) {
  return json_object(
      "share", number(bounds.upper), "lower", number(bounds.lower), "upper", number(bounds.upper), "interval",
      interval_data(bounds.interval), "telling_weight",
      bounds.tells() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(telling_weight(bounds)));
}

nlohmann::ordered_json exposures_data(const Scenario& scenario,
                                      const std::vector<ExposureSummary>& exposures) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < exposures.size(); ++i) {
    const ExposurePlan& plan = scenario.exposures[i];
    const ExposureSummary& exposed = exposures[i];
    list.push_back(json_object(
        "exposure", plan.name, plan.line.empty() ? "at" : "line", place_data(plan, scenario.dimension),
        "area_m2", plan.area, "energy_J", plan.energy, "occupied", plan.occupied, "blasts_per_year",
        plan.blasts_per_year, "radius_m", number(exposed.radius), "landings", exposed.landings, "trials",
        exposed.trials, "hits_per_m2", number(exposed.hits_per_m2), "per_blast",
        bounds_data(exposed.per_blast), "per_year", number(exposed.per_year), "per_year_interval",
        interval_data(exposed.per_year_interval)));
    if (plan.limit_per_blast) list.back()["limit_per_blast"] = *plan.limit_per_blast;
    if (plan.limit_per_year) list.back()["limit_per_year"] = *plan.limit_per_year;
    if (!plan.has_traffic()) continue;
    list.back()["vehicle_hit"] = number(exposed.per_blast.upper);
    list.back()["vehicle_hit_interval"] = interval_data(exposed.per_blast.interval);
    list.back()["expected_vehicles"] = number(exposed.expected_vehicles);
    list.back()["road_hit"] = number(exposed.road_hit);
  }
  return list;
}

}  // namespace flyrock
