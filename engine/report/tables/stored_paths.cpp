#include "report/tables/stored_paths.h"

#include <algorithm>
#include <cmath>

#include "record/observe.h"

namespace flyrock {

namespace {

double mode_number(const std::string& name) {
  const auto found = std::find(travel_mode_names.begin(), travel_mode_names.end(), name);
  return static_cast<double>(found - travel_mode_names.begin());
}

/// In 2D the quaternion is not stored and reads as 0.
Eigen::Quaterniond turn_of(const Query& row, int first) {
  const Eigen::Quaterniond turn(row.real(first), row.real(first + 1), row.real(first + 2),
                                row.real(first + 3));
  return turn.norm() > 0 ? turn : Eigen::Quaterniond::Identity();
}

}  // namespace

StoredPaths::StoredPaths(const SqliteReader& database)
    : rows_(database,
            "SELECT t.point, t.trial, t.rock, runout_m, volume_m3, t.time_s, x_m, y_m, z_m, vx_m_s, vy_m_s, "
            "vz_m_s, kinetic_energy_J, mode, angle_rad, qw, qx, qy, qz, \"group\" FROM trajectories t JOIN "
            "rocks USING "
            "(point, trial, rock) ORDER BY t.point, t.trial, t.rock"),
      more_(rows_.next()) {}

std::vector<StoredPath> StoredPaths::next_point() {
  std::vector<StoredPath> paths;
  for (; more_ && (paths.empty() || paths.back().point == rows_.whole(0)); more_ = rows_.next()) {
    if (paths.empty() || paths.back().trial != rows_.whole(1) || paths.back().rock != rows_.whole(2))
      paths.push_back({rows_.whole(0),
                       rows_.whole(1),
                       rows_.whole(2),
                       rows_.text(19),
                       rows_.real(3),
                       std::cbrt(6 * rows_.real(4) / pi),
                       {}});
    const Vec3 velocity(rows_.real(9), rows_.real(10), rows_.real(11));
    paths.back().moments.push_back({.time = rows_.real(5),
                                    .speed = velocity.norm(),
                                    .energy = rows_.real(12),
                                    .mode = mode_number(rows_.text(13)),
                                    .place = {rows_.real(6), rows_.real(7), rows_.real(8)},
                                    .angle = rows_.real(14),
                                    .turn = turn_of(rows_, 15)});
  }
  return paths;
}

StoredMoment StoredPath::at(double time) const {
  const auto later = std::lower_bound(moments.begin(), moments.end(), time,
                                      [](const StoredMoment& m, double t) { return m.time < t; });
  if (later == moments.end()) return moments.back();
  if (later == moments.begin()) return *later;
  const StoredMoment &a = *std::prev(later), &b = *later;
  const double share = (time - a.time) / (b.time - a.time);
  return {.time = time,
          .speed = a.speed + share * (b.speed - a.speed),
          .energy = a.energy + share * (b.energy - a.energy),
          .mode = b.mode,
          .place = a.place + share * (b.place - a.place),
          .angle = a.angle + share * (b.angle - a.angle),
          .turn = a.turn.slerp(share, b.turn)};
}

}  // namespace flyrock
