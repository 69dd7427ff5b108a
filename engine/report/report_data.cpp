#include "report/report_data.h"

#include <cmath>

#include "report/summary_data.h"
#include "report/track.h"

namespace flyrock {

namespace {

using Json = nlohmann::ordered_json;

/// Points of trajectories in one page; 15 bytes each.
constexpr std::size_t most_track_points = 150'000;
/// A thinned path departs from the stored one by this share of the plot's extent at most: a seventh of a pixel.
constexpr double track_tolerance = 1e-4;

std::int64_t thousandth(double value) { return std::llround(1000 * value); }

/// Whole thousandths, the first as it is and then the differences.
Json differences(const std::vector<double>& values) {
  Json list = Json::array();
  std::int64_t before = 0;
  for (double value : values) {
    list.push_back(thousandth(value) - before);
    before = thousandth(value);
  }
  return list;
}

double extent_of(const std::vector<TrajectoryRecord>& rows) {
  Eigen::AlignedBox3d box;
  for (const TrajectoryRecord& row : rows) box.extend(row.point.state.position);
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

Json track_data(const std::vector<TrajectoryRecord>& rows, const Track& track, int group, double tolerance) {
  std::vector<Vec2> path;
  for (std::size_t i = track.begin; i < track.end; ++i) path.push_back(rows[i].point.state.position.head<2>());
  std::vector<double> x, y, t;
  Json speed = Json::array();
  for (const std::size_t i : simplify(path, tolerance)) {
    const BodyState& state = rows[track.begin + i].point.state;
    x.push_back(state.position.x());
    y.push_back(state.position.y());
    t.push_back(state.time);
    speed.push_back(thousandth(state.velocity.norm()));
  }
  return {{"trial", track.trial}, {"rock", track.rock},   {"group", group}, {"x", differences(x)},
          {"y", differences(y)},  {"t", differences(t)}, {"speed", speed}};
}

/// The tracks of whole trials, as many as fit into `budget` points.
Json tracks_data(const TrialRecords& records, std::size_t budget) {
  std::map<std::pair<std::uint64_t, int>, const RockRecord*> rock_of;
  for (const RockRecord& rock : records.rocks) rock_of[{rock.trial, rock.rock}] = &rock;
  const double tolerance = track_tolerance * extent_of(records.trajectories);
  Json list = Json::array();
  std::size_t points = 0;
  bool cut = false;
  for (const Track& track : tracks_of(records.trajectories)) {
    const auto rock = rock_of.find({track.trial, track.rock});
    if (rock == rock_of.end()) continue;  // a body that does not move
    Json data = track_data(records.trajectories, track, rock->second->group, tolerance);
    points += data["x"].size();
    cut = points > budget;
    if (cut) break;
    data["reason"] = name_of(rock->second->reason);
    list.push_back(std::move(data));
  }
  return {{"list", list}, {"cut", cut}};
}

Json terrain_data(const Profile& terrain) {
  Json x = Json::array(), y = Json::array();
  for (const Vec2& point : terrain.points) {
    x.push_back(thousandth(point.x()));
    y.push_back(thousandth(point.y()));
  }
  return {{"x", x}, {"y", y}, {"part", terrain.part}, {"parts", terrain.parts}};
}

/// Of all rocks, then of each group where there is more than one: the order of PointResult::groups.
Json runouts_data(const PointResult& point) {
  std::vector<std::vector<Bounded>> values(point.groups.size());
  for (const RockRecord& rock : point.records.rocks) {
    if (is_fault(rock.reason)) continue;
    const Bounded runout = quantity_of(rock, RockQuantity::runout);
    values[0].push_back(runout);
    if (values.size() > 1) values[1 + rock.group].push_back(runout);
  }
  Json list = Json::array();
  for (const std::vector<Bounded>& group : values) list.push_back(runout_data(group));
  return list;
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json bodies_data(const Scenario& scenario, const TrialRecords& records) {
  Json list = Json::array();
  for (std::size_t b = 0; b < records.bodies.size() && b < scenario.bodies.size(); ++b) {
    const BodyHistory& body = records.bodies[b];
    list.push_back({{"name", scenario.bodies[b].name},
                    {"reason", name_of(body.reason)},
                    {"stop_time", number(body.stop_time)},
                    {"x", number(body.last.position.x())},
                    {"y", number(body.last.position.y())},
                    {"speed", number(body.last.velocity.norm())},
                    {"spin", number(body.last.spin.z())},
                    {"max_speed", number(body.max_speed)},
                    {"impacts", body.impact_count},
                    {"contact_time", number(body.contact_time)}});
  }
  return list;
}

}  // namespace

Json report_data(const Plan& plan, const Results& results) {
  Json points = Json::array();
  const std::size_t budget = most_track_points / results.points.size();
  for (std::size_t p = 0; p < results.points.size(); ++p) {
    const PointResult& point = results.points[p];
    points.push_back({{"terrain", terrain_data(point.terrain)},
                      {"tracks", tracks_data(point.records, budget)},
                      {"runout", runouts_data(point)},
                      {"bodies", bodies_data(plan.points[p], point.records)}});
  }
  return {{"summary", summary_data(plan, results)},
          {"scenario", to_yaml(plan.resolved)},
          {"groups", group_names(plan.points.front())},
          {"units", quantity_units},
          {"points", points}};
}

}  // namespace flyrock
