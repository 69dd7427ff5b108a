#include "report/page/map_data.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "report/page/rounded.h"

namespace flyrock {

nlohmann::ordered_json map_data(const MapRasters& maps, std::size_t& room) {
  using Json = nlohmann::ordered_json;
  if (maps.cells.empty() || maps.cells.size() > room) return nullptr;
  room -= maps.cells.size();
  Json data = {{"x", maps.grid.low.x()},
               {"y", maps.grid.low.y()},
               {"cell", maps.grid.cell},
               {"columns", maps.grid.columns},
               {"rows", maps.grid.rows}};
  Json& index = data["index"] = Json::array();
  std::uint32_t before = 0;
  for (const MapRasters::Cell& cell : maps.cells) {
    index.push_back(cell.index - before);
    before = cell.index;
  }
  for (std::size_t m = 0; m < map_names.size(); ++m) {
    if (std::isnan(maps.cells.front().values[m])) continue;  // no raster of this method
    Json& values = data[map_names[m]] = Json::array();
    for (const MapRasters::Cell& cell : maps.cells)
      // Counts of rocks are whole numbers, and so are most sums of weights.
      values.push_back(is_count_map(m) && cell.values[m] == std::floor(cell.values[m])
                           ? Json(static_cast<std::uint64_t>(cell.values[m]))
                           : rounded(cell.values[m]));
  }
  return data;
}

nlohmann::ordered_json map_unit_data() {
  nlohmann::ordered_json units = nlohmann::ordered_json::object();
  for (std::size_t m = 0; m < map_names.size(); ++m) units[map_names[m]] = map_units[m];
  return units;
}

}  // namespace flyrock
