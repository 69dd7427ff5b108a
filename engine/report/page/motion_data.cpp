#include "report/page/motion_data.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "report/page/rounded.h"
#include "report/pictures/animation.h"
#include "report/tables/stored_paths.h"

namespace flyrock {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_points = 12;           // of a sweep
constexpr std::size_t most_of_picture = 600'000;  // bytes
constexpr std::size_t most_on_curve = 500;        // points

/// Columns of numbers of the same length.
class Curves {
 public:
  explicit Curves(std::vector<const char*> names) : names_(std::move(names)), values_(names_.size()) {}

  void add(const std::vector<double>& row) {
    for (std::size_t i = 0; i < row.size(); ++i) values_[i].push_back(row[i]);
  }
  /// Writes every n-th row, and the last one.
  void put(Json& object) const {
    const std::size_t count = values_.front().size(), stride = (count + most_on_curve - 1) / most_on_curve;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      Json list = Json::array();
      for (std::size_t k = 0; k < count; k += stride) list.push_back(short_number(values_[i][k]));
      if (count > 0 && (count - 1) % stride != 0) list.push_back(short_number(values_[i].back()));
      object[names_[i]] = std::move(list);
    }
  }

 private:
  /// Six digits are enough for a picture.
  static Json short_number(double value) { return rounded(value, 6); }

  std::vector<const char*> names_;
  std::vector<std::vector<double>> values_;
};

Json body_curves(const SqliteReader& database, const std::vector<StoredPath>& paths, bool in_space) {
  Json list = Json::array();
  for (const StoredPath& path : paths) {
    if (path.trial != paths.front().trial) break;
    Query name(database,
               fmt::format("SELECT \"group\" FROM rocks WHERE point = {} AND trial = {} AND rock = {}",
                           path.point, path.trial, path.rock));
    name.next();
    Curves curves({"t", "height", "speed", "energy"});
    for (const StoredMoment& moment : path.moments)
      curves.add({moment.time, in_space ? moment.place.z() : moment.place.y(), moment.speed, moment.energy});
    Json body = {{"name", name.text(0)}};
    curves.put(body);
    list.push_back(std::move(body));
  }
  return list;
}

Json contact_curves(const SqliteReader& database, std::int64_t point) {
  Query row(database,
            fmt::format("SELECT a, b, time_s, MIN(gap_m), SUM(rn_N), SUM(rt_N) FROM series_contacts "
                        "WHERE point = {} AND trial = 0 AND step_s > 0 GROUP BY a, b, time_s "
                        "ORDER BY a, b, time_s",
                        point));
  Json list = Json::array();
  bool more = row.next();
  while (more) {
    const std::string a = row.text(0), b = row.text(1);
    Curves curves({"t", "gap", "rn", "rt"});
    for (; more && row.text(0) == a && row.text(1) == b; more = row.next())
      curves.add({row.real(2), row.real(3), row.real(4), row.real(5)});
    Json pair = {{"name", a + " on " + b}};
    curves.put(pair);
    list.push_back(std::move(pair));
  }
  return list;
}

/// The energy at the moments at which all moving bodies have a row.
Json energy_curve(const SqliteReader& database, std::int64_t point) {
  const std::string rows = fmt::format(
      "SELECT time_s AS t, COUNT(DISTINCT body) AS n, SUM(kinetic_energy_J) / COUNT(*) * COUNT(DISTINCT "
      "body) "
      "AS k, SUM(potential_energy_J) / COUNT(*) * COUNT(DISTINCT body) AS p FROM series_bodies WHERE point = "
      "{} "
      "AND trial = 0 GROUP BY time_s",
      point);
  Query row(database, fmt::format("SELECT t, k, p FROM ({0}) WHERE n = (SELECT n FROM ({0}) ORDER BY t DESC "
                                  "LIMIT 1) ORDER BY t",
                                  rows));
  Curves curves({"t", "kinetic", "potential"});
  while (row.next()) curves.add({row.real(0), row.real(1), row.real(2)});
  Json energy = Json::object();
  curves.put(energy);
  return energy;
}

}  // namespace

void add_motion(Json& data, const std::filesystem::path& file) {
  const Json& points = data.at("points");
  if (points.empty() || points[0].at("bodies").empty()) return;
  const SqliteReader database(file);
  StoredPaths stored(database);
  Json motion = Json::array();
  for (auto paths = stored.next_point(); !paths.empty() && motion.size() < most_points;
       paths = stored.next_point()) {
    const std::int64_t point = paths.front().point;
    while (motion.size() < static_cast<std::size_t>(point)) motion.push_back(nullptr);
    std::string picture = animation_of(database, paths, fmt::format("motion, point {}", point));
    if (picture.size() > most_of_picture) picture.clear();
    motion.push_back({{"picture", picture},
                      {"bodies", body_curves(database, paths, data.at("summary").at("dimension") == 3)},
                      {"contacts", contact_curves(database, point)},
                      {"energy", energy_curve(database, point)}});
  }
  data["motion"] = std::move(motion);
}

}  // namespace flyrock
