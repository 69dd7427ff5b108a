#include "report/stored_scene.h"

#include <fmt/format.h>

namespace flyrock {

std::optional<std::int64_t> stored_ground(const SqliteReader& database, std::int64_t point) {
  Query row(database, fmt::format("SELECT ground FROM points WHERE point = {}", point));
  if (!row.next() || row.type(0) == SQLITE_NULL) return std::nullopt;
  return row.whole(0);
}

std::vector<SurfaceCorner> stored_corners(const SqliteReader& database, const StoredPath& path) {
  Query row(database, fmt::format("SELECT contactor, face, x_m, y_m, z_m, radius_m FROM shapes WHERE point = "
                                  "{} AND trial = {} AND rock = {}",
                                  path.point, path.trial, path.rock));
  std::vector<SurfaceCorner> corners;
  while (row.next())
    corners.push_back({static_cast<int>(row.whole(0)), static_cast<int>(row.whole(1)),
                       Vec3(row.real(2), row.real(3), row.real(4)), row.real(5)});
  return corners;
}

}  // namespace flyrock
