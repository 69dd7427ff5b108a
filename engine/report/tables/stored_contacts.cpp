#include "report/tables/stored_contacts.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <tuple>

#include "report/tables/stored_scene.h"

namespace flyrock {

const StoredForce* StoredContact::at(double time) const {
  const auto later = std::lower_bound(forces.begin(), forces.end(), time,
                                      [](const StoredForce& force, double t) { return force.end < t; });
  return later == forces.end() || later->begin > time ? nullptr : &*later;
}

std::vector<StoredContact> stored_contacts(const SqliteReader& database, std::int64_t point,
                                           std::int64_t trial) {
  Query row(database,
            fmt::format("SELECT a, b, number, time_s, step_s, rn_N, rt_N, x_m, y_m, z_m, nx, ny, nz "
                        "FROM series_contacts WHERE point = {} AND trial = {} AND rn_N > 0 "
                        "ORDER BY a, b, number, time_s",
                        point, trial));
  const bool in_space = stored_ground(database, point).has_value();
  std::vector<StoredContact> contacts;
  std::tuple<std::string, std::string, std::int64_t> before;
  while (row.next()) {
    const std::tuple<std::string, std::string, std::int64_t> key(row.text(0), row.text(1), row.whole(2));
    if (contacts.empty() || key != before) contacts.emplace_back();
    before = key;
    const Vec3 normal(row.real(10), row.real(11), row.real(12));
    const Vec3 tangent = in_space ? Vec3(Vec3::Zero()) : Vec3(normal.y(), -normal.x(), 0);
    contacts.back().forces.push_back({row.real(3) - row.real(4), row.real(3),
                                      Vec3(row.real(7), row.real(8), row.real(9)),
                                      row.real(5) * normal + row.real(6) * tangent});
  }
  return contacts;
}

}  // namespace flyrock
