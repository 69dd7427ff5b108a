#include "report/report_data.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "report/runout_data.h"
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

/// A place as it is drawn: the vertical plane of 2D; space seen from the side.
Vec2 in_view(const Vec3& place, int dimension) { return {place.x(), place[dimension - 1]}; }

Json track_data(const std::vector<TrajectoryRecord>& rows, const Track& track, int group, int dimension, double tolerance) {
  std::vector<Vec2> path;
  for (std::size_t i = track.begin; i < track.end; ++i)
    path.push_back(in_view(rows[i].point.state.position, dimension));
  std::vector<double> x, y, t;
  Json speed = Json::array();
  for (const std::size_t i : simplify(path, tolerance)) {
    const BodyState& state = rows[track.begin + i].point.state;
    x.push_back(path[i].x());
    y.push_back(path[i].y());
    t.push_back(state.time);
    speed.push_back(thousandth(state.velocity.norm()));
  }
  return {{"trial", track.trial}, {"rock", track.rock},   {"group", group}, {"x", differences(x)},
          {"y", differences(y)},  {"t", differences(t)}, {"speed", speed}};
}

/// The tracks of whole rocks, as many as fit into a budget of points.
class Tracks {
 public:
  Tracks(std::size_t budget, int dimension) : budget_(budget), dimension_(dimension) {}

  void see(const TrialRecords& chunk) {
    if (!measured_) {
      for (const TrajectoryRecord& row : chunk.trajectories) box_.extend(row.point.state.position);
      return;
    }
    for (const Track& track : tracks_of(chunk.trajectories))
      if (!cut_) add(track, chunk);
  }

  bool again() { return !std::exchange(measured_, true); }
  Json data() const { return {{"list", list_}, {"cut", cut_}}; }

 private:
  void add(const Track& track, const TrialRecords& chunk) {
    const auto rock = std::find_if(chunk.rocks.begin(), chunk.rocks.end(), [&](const RockRecord& row) {
      return row.trial == track.trial && row.rock == track.rock;
    });
    if (rock == chunk.rocks.end()) return;  // a body that does not move
    const double extent = box_.isEmpty() ? 0 : box_.diagonal().norm();
    Json data = track_data(chunk.trajectories, track, rock->group, dimension_, track_tolerance * extent);
    points_ += data["x"].size();
    cut_ = points_ > budget_;
    if (cut_) return;
    data["reason"] = name_of(rock->reason);
    list_.push_back(std::move(data));
  }

  std::size_t budget_, points_ = 0;
  int dimension_;
  bool measured_ = false, cut_ = false;
  Eigen::AlignedBox3d box_;
  Json list_ = Json::array();
};

Json terrain_data(const Profile& terrain) {
  Json x = Json::array(), y = Json::array();
  for (const Vec2& point : terrain.points) {
    x.push_back(thousandth(point.x()));
    y.push_back(thousandth(point.y()));
  }
  return {{"x", x}, {"y", y}, {"part", terrain.part}, {"parts", terrain.parts}};
}

/// Of all rocks, then of each group where there is more than one: the order of PointResult::groups.
class Runouts {
 public:
  explicit Runouts(const std::vector<GroupSummary>& groups) {
    for (const GroupSummary& group : groups)
      groups_.emplace_back(group.count - group.faults, group.at(RockQuantity::runout, Statistic::min).value,
                           group.at(RockQuantity::runout, Statistic::max).value);
  }

  void see(const TrialRecords& chunk) {
    for (const RockRecord& rock : chunk.rocks) {
      if (is_fault(rock.reason)) continue;
      const Bounded runout = quantity_of(rock, RockQuantity::runout);
      groups_.front().add(runout);
      if (groups_.size() > 1) groups_.at(1 + static_cast<std::size_t>(rock.group)).add(runout);
    }
  }

  bool again() {
    bool more = false;
    for (RunoutData& group : groups_) more |= group.again();
    return more;
  }

  Json data() const {
    Json list = Json::array();
    for (const RunoutData& group : groups_) list.push_back(group.data());
    return list;
  }

 private:
  std::vector<RunoutData> groups_;
};

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json bodies_data(const Scenario& scenario, const TrialTotals& totals) {
  Json list = Json::array();
  for (std::size_t b = 0; b < totals.bodies.size() && b < scenario.bodies.size(); ++b) {
    const BodyHistory& body = totals.bodies[b];
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

Json report_data(const Plan& plan, const Results& results, const std::vector<Rows>& rows) {
  Json points = Json::array();
  const std::size_t budget = most_track_points / results.points.size();
  for (std::size_t p = 0; p < results.points.size(); ++p) {
    const PointResult& point = results.points[p];
    Tracks tracks(budget, plan.points[p].dimension);
    read_in_passes(rows[p], tracks, Part::paths);
    Runouts runouts(point.groups);
    read_in_passes(rows[p], runouts);
    points.push_back({{"terrain", terrain_data(point.terrain)},
                      {"tracks", tracks.data()},
                      {"runout", runouts.data()},
                      {"bodies", bodies_data(plan.points[p], point.totals)}});
  }
  return {{"summary", summary_data(plan, results)},
          {"scenario", to_yaml(plan.resolved)},
          {"groups", group_names(plan.points.front())},
          {"units", quantity_units},
          {"points", points}};
}

}  // namespace flyrock
