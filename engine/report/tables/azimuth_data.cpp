#include "report/tables/azimuth_data.h"

#include "geometry/bearing.h"
#include "report/tables/json_object.h"

namespace flyrock {

namespace {

using Json = nlohmann::ordered_json;

Json percentile_data(const AzimuthSector::Percentile& percentile) {
  if (std::isnan(percentile.value.value)) return nullptr;
  return {{"value", percentile.value.value},
          {"lower_bound", percentile.value.censored},
          {"interval", interval_data(percentile.interval)}};
}

}  // namespace

Json azimuth_data(const PointResult& point, double north) {
  constexpr double width = 360.0 / azimuth_sectors;
  const auto bearing = [&](std::size_t edge) {
    return bearing_degrees(width * static_cast<double>(edge) * pi / 180, north);
  };
  Json list = Json::array();
  for (std::size_t g = 0; g < point.azimuths.size(); ++g) {
    const RunoutByAzimuth& azimuths = point.azimuths[g];
    const std::string& group = point.groups.at(g).name;
    Json sectors = Json::array();
    for (std::size_t i = 0; i < azimuths.sectors.size(); ++i) {
      const AzimuthSector& sector = azimuths.sectors[i];
      if (sector.count == 0) continue;
      sectors.push_back({{"from_deg", width * static_cast<double>(i)},
                         {"to_deg", width * static_cast<double>(i + 1)},
                         {"bearing_from_deg", bearing(i + 1)},
                         {"bearing_to_deg", bearing(i)},
                         {"count", sector.count},
                         {"share", sector.share.value},
                         {"share_interval", interval_data(sector.share.interval)},
                         {"greatest", sector.greatest.value},
                         {"lower_bound", sector.greatest.censored},
                         {"p50", percentile_data(sector.percentiles[0])},
                         {"p95", percentile_data(sector.percentiles[1])}});
    }
    list.push_back({{"group", group.empty() ? Json(nullptr) : Json(group)},
                    {"still", azimuths.still},
                    {"least", least_in_sector},
                    {"sectors", std::move(sectors)}});
  }
  return list;
}

}  // namespace flyrock
