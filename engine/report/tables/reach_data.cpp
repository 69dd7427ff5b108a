#include "report/tables/reach_data.h"

#include <nlohmann/json.hpp>

#include "report/page/rounded.h"

namespace flyrock {

using Json = nlohmann::ordered_json;

Json reach_data(const Scenario& scenario, const std::vector<LaunchReach>& reaches) {
  Json list = Json::array();
  for (const LaunchReach& reach : reaches) {
    Json speeds = Json::array();
    for (const LaunchReach::OfSpeed& of : reach.speeds)
      speeds.push_back({{"of", statistic_names[static_cast<int>(of.statistic)]},
                        {"speed_m_s", of.speed},
                        {"elevation_deg", of.farthest.elevation * 180 / pi},
                        {"range_m", of.farthest.range}});
    list.push_back({{"group", scenario.rocks[reach.group].name},
                    {"model", reach.model},
                    {"height_m", reach.height},
                    {"mass_kg", reach.mass},
                    {"drag_1_m", reach.forces.air.drag},
                    {"speeds", speeds}});
  }
  return list;
}

Json shroud_data(const std::vector<LaunchReach>& reaches) {
  constexpr int points = 41;
  Json list = Json::array();
  for (const LaunchReach& reach : reaches)
    for (const LaunchReach::OfSpeed& of : reach.speeds) {
      Json x = Json::array(), y = Json::array();
      for (const Vec2& point : shroud(reach.forces, of.speed, reach.height, reach.longest, points)) {
        x.push_back(rounded(reach.origin.x() + point.x()));
        y.push_back(rounded(reach.origin.y() + point.y()));
      }
      list.push_back({{"group", reach.group},
                      {"of", statistic_names[static_cast<int>(of.statistic)]},
                      {"x", x},
                      {"y", y}});
    }
  return list;
}

}  // namespace flyrock
