#include "report/tables/stored_contacts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>

namespace flyrock {

namespace {

/// Between rows of the series [s]; 0: each step has one.
double time_between_rows(const SqliteReader& database, std::int64_t point) {
  Query row(database, fmt::format("SELECT series_every_s FROM points WHERE point = {}", point));
  return row.next() && row.type(0) != SQLITE_NULL ? row.real(0) : 0;
}

constexpr double rounding = 1e-9;  // of the time between rows

/// Until when the row of a step that ends at `time` stands: just before the next one falls due, at a multiple
/// of `every`.
double end_of_row(double time, double every) {
  if (every <= 0) return time;
  return std::max(time, every * (std::floor(time / every + rounding) + 1 - rounding));
}

/// The last rows stand also when the next ones would fall due, where the run may end.
void let_last_rows_stand(std::vector<StoredContact>& contacts, double every) {
  double latest = 0;
  for (const StoredContact& contact : contacts) latest = std::max(latest, contact.forces.back().end);
  for (StoredContact& contact : contacts)
    if (contact.forces.back().end == latest) contact.forces.back().end += 2 * rounding * every;
}

/// The paths of a trial by the names that its series use: those of bodies, or the group and number of a rock.
std::map<std::string, const StoredPath*> by_name(const std::vector<StoredPath>& paths, std::int64_t trial) {
  std::map<std::string, const StoredPath*> names;
  for (const StoredPath& path : paths) {
    if (path.trial != trial) continue;
    names.emplace(path.group, &path);
    names.emplace(fmt::format("{} {}", path.group, path.rock), &path);
  }
  return names;
}

}  // namespace

const StoredForce* StoredContact::at(double time) const {
  const auto later = std::lower_bound(forces.begin(), forces.end(), time,
                                      [](const StoredForce& force, double t) { return force.end < t; });
  return later == forces.end() || later->begin > time ? nullptr : &*later;
}

std::vector<Vec3> StoredContact::line(const StoredForce& force, double time) const {
  std::vector<Vec3> places;
  if (a) places.push_back(a->at(time).place);
  places.push_back(force.place);
  if (b) places.push_back(b->at(time).place);
  return places;
}

std::vector<StoredContact> stored_contacts(const SqliteReader& database, std::int64_t point,
                                           std::int64_t trial, const std::vector<StoredPath>& paths) {
  Query row(database,
            fmt::format("SELECT a, b, number, time_s, step_s, x_m, y_m, z_m, nx, ny, nz, fx_N, fy_N, fz_N "
                        "FROM series_contacts WHERE point = {} AND trial = {} AND rn_N > 0 "
                        "ORDER BY a, b, number, time_s",
                        point, trial));
  const double every = time_between_rows(database, point);
  const std::map<std::string, const StoredPath*> names = by_name(paths, trial);
  const auto path_of = [&](const std::string& name) {
    const auto known = names.find(name);
    return known == names.end() ? nullptr : known->second;
  };
  const auto vector_at = [&](int column) {
    return Vec3(row.real(column), row.real(column + 1), row.real(column + 2));
  };
  std::vector<StoredContact> contacts;
  std::tuple<std::string, std::string, std::int64_t> before;
  while (row.next()) {
    const std::tuple<std::string, std::string, std::int64_t> key(row.text(0), row.text(1), row.whole(2));
    if (contacts.empty() || key != before)
      contacts.push_back({path_of(std::get<0>(key)), path_of(std::get<1>(key)), {}});
    before = key;
    const double time = row.real(3), step = row.real(4);
    contacts.back().forces.push_back({.begin = time - step,
                                      .end = end_of_row(time, every),
                                      .place = vector_at(5),
                                      .normal = vector_at(8),
                                      .force = vector_at(11)});
  }
  let_last_rows_stand(contacts, every);
  return contacts;
}

}  // namespace flyrock
