#include "report/tables/stored_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>

namespace flyrock {

std::string stored_crs(const SqliteReader& database) {
  Query row(database, "SELECT json_extract(data, '$.summary.crs') FROM report");
  return row.next() && row.type(0) == SQLITE_TEXT ? row.text(0) : "";
}

std::optional<std::int64_t> stored_ground(const SqliteReader& database, std::int64_t point) {
  Query row(database, fmt::format("SELECT ground FROM points WHERE point = {}", point));
  if (!row.next() || row.type(0) == SQLITE_NULL) return std::nullopt;
  return row.whole(0);
}

namespace {

constexpr const char* corner_columns = "contactor, face, x_m, y_m, z_m, radius_m";

SurfaceCorner corner_of(const Query& row, int first) {
  return {static_cast<int>(row.whole(first)), static_cast<int>(row.whole(first + 1)),
          Vec3(row.real(first + 2), row.real(first + 3), row.real(first + 4)), row.real(first + 5)};
}

/// The start of a driven body, or of a fixed one, and how it moves on.
struct PrescribedMotion {
  Vec3 place, velocity, acceleration, spin;
  double time, angle;
  Eigen::Quaterniond turn;

  bool moves() const { return !velocity.isZero(0) || !acceleration.isZero(0) || !spin.isZero(0); }
  StoredMoment at(double moment) const {
    const double t = moment - time, turned = spin.norm() * t;
    const Vec3 speed = velocity + t * acceleration;
    const Eigen::AngleAxisd rotation(turned, spin.isZero(0) ? Vec3::UnitZ() : Vec3(spin.normalized()));
    return {.time = moment,
            .speed = speed.norm(),
            .energy = 0,
            .mode = 0,
            .place = place + t * velocity + 0.5 * t * t * acceleration,
            .angle = angle + spin.z() * t,
            .turn = rotation * turn};
  }
};

}  // namespace

std::vector<SurfaceCorner> stored_corners(const SqliteReader& database, const StoredPath& path) {
  Query row(database, fmt::format("SELECT {} FROM shapes WHERE point = {} AND trial = {} AND rock = {}",
                                  corner_columns, path.point, path.trial, path.rock));
  std::vector<SurfaceCorner> corners;
  while (row.next()) corners.push_back(corner_of(row, 0));
  return corners;
}

std::vector<StoredFixture> stored_fixtures(const SqliteReader& database,
                                           const std::vector<StoredPath>& paths) {
  constexpr int most_moments = 250;  // of the path of a driven body
  std::vector<StoredFixture> fixtures;
  if (paths.empty()) return fixtures;
  const StoredPath& first = paths.front();
  double end = 0;
  for (const StoredPath& path : paths) end = std::max(end, path.moments.back().time);
  const std::string here = fmt::format("WHERE point = {} AND trial = {}", first.point, first.trial);
  std::map<std::string, std::vector<SurfaceCorner>> corners;
  Query corner(database,
               fmt::format("SELECT body, {} FROM fixture_shapes {} ORDER BY rowid", corner_columns, here));
  while (corner.next()) corners[corner.text(0)].push_back(corner_of(corner, 1));
  Query row(database,
            "SELECT body, time_s, x_m, y_m, z_m, vx_m_s, vy_m_s, vz_m_s, ax_m_s2, ay_m_s2, az_m_s2, "
            "spin_x_rad_s, spin_y_rad_s, spin_z_rad_s, angle_rad, qw, qx, qy, qz FROM fixtures " +
                here + " ORDER BY rowid");
  const auto vector = [&](int column) {
    return Vec3(row.real(column), row.real(column + 1), row.real(column + 2));
  };
  std::vector<std::pair<std::string, std::vector<PrescribedMotion>>> motions;  // of each body, in pieces
  while (row.next()) {
    if (motions.empty() || motions.back().first != row.text(0)) motions.push_back({row.text(0), {}});
    motions.back().second.push_back({.place = vector(2),
                                     .velocity = vector(5),
                                     .acceleration = vector(8),
                                     .spin = vector(11),
                                     .time = row.real(1),
                                     .angle = row.real(14),
                                     .turn = {row.real(15), row.real(16), row.real(17), row.real(18)}});
  }
  for (const auto& [body, pieces] : motions) {
    StoredFixture fixture{{first.point, first.trial, -1, body, 0, 0, {}}, corners[body]};
    const double start = pieces.front().time;
    const bool moves =
        std::any_of(pieces.begin(), pieces.end(), [](const auto& piece) { return piece.moves(); });
    const int count = moves && end > start ? most_moments : 0;
    for (int i = 0; i <= count; ++i) {
      const double time = start + (end - start) * i / std::max(count, 1);
      const auto next =
          std::upper_bound(pieces.begin(), pieces.end(), time,
                           [](double t, const PrescribedMotion& piece) { return t < piece.time; });
      fixture.path.moments.push_back((next - 1)->at(time));
    }
    fixtures.push_back(std::move(fixture));
  }
  return fixtures;
}

Vec3 StoredLink::End::at(double time) const {
  if (!path) return place;
  const StoredMoment moment = path->at(time);
  const Eigen::Quaterniond turn =
      moment.angle != 0 ? Eigen::Quaterniond(Eigen::AngleAxisd(moment.angle, Vec3::UnitZ())) : moment.turn;
  return moment.place + turn * place;
}

std::vector<StoredLink> stored_links(const SqliteReader& database, const std::vector<StoredPath>& paths,
                                     const std::vector<StoredFixture>& fixtures) {
  std::vector<StoredLink> links;
  if (paths.empty()) return links;
  Query row(database,
            fmt::format("SELECT type, a, a_rock, ax_m, ay_m, az_m, b, b_rock, bx_m, by_m, bz_m FROM links "
                        "WHERE point = {} AND trial = {} ORDER BY rowid",
                        paths.front().point, paths.front().trial));
  const auto path_of = [&](const std::string& body, std::int64_t rock) -> const StoredPath* {
    for (const StoredPath& path : paths)
      if (rock >= 0 && path.rock == rock && path.trial == paths.front().trial) return &path;
    for (const StoredFixture& fixture : fixtures)
      if (fixture.path.group == body) return &fixture.path;
    return nullptr;
  };
  const auto end = [&](int first) -> std::optional<StoredLink::End> {
    const std::string body = row.text(first);
    const StoredPath* path = path_of(body, row.whole(first + 1));
    if (!path && body != "terrain") return std::nullopt;
    return StoredLink::End{path, Vec3(row.real(first + 2), row.real(first + 3), row.real(first + 4))};
  };
  while (row.next())
    if (const auto a = end(1), b = end(6); a && b) links.push_back({row.text(0), *a, *b});
  return links;
}

}  // namespace flyrock
