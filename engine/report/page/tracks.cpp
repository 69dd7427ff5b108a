#include "report/page/tracks.h"

#include <algorithm>

#include "report/page/rounded.h"
#include "report/tables/json_object.h"

namespace flyrock {

namespace {

using Json = nlohmann::ordered_json;

/// The greatest distance between a thinned path and the stored path, relative to the extent of its group: a
/// seventh of a pixel in a plot of the group.
constexpr double track_tolerance = 1e-4;

}  // namespace

std::vector<std::size_t> simplify(const std::vector<Vec3>& points, double tolerance) {
  if (points.empty()) return {};
  std::vector<bool> keep(points.size(), false);
  keep.front() = keep.back() = true;
  // A stack of stretches instead of recursion, because a path may have many thousand points.
  std::vector<std::pair<std::size_t, std::size_t>> stretches = {{0, points.size() - 1}};
  while (!stretches.empty()) {
    const auto [first, last] = stretches.back();
    stretches.pop_back();
    double farthest = tolerance;
    std::size_t split = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double distance = distance_to_segment(points[i], points[first], points[last]);
      if (distance > farthest) {
        farthest = distance;
        split = i;
      }
    }
    if (split == first) continue;
    keep[split] = true;
    stretches.emplace_back(first, split);
    stretches.emplace_back(split, last);
  }
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (keep[i]) kept.push_back(i);
  return kept;
}

std::vector<Tracks::Stretch> Tracks::stretches_of(const TrialRecords& chunk) {
  std::vector<Stretch> stretches;
  auto rock = chunk.rocks.begin();
  const std::vector<TrajectoryRecord>& rows = chunk.trajectories;
  for (std::size_t begin = 0, end = 0; begin < rows.size(); begin = end) {
    const auto of_one = [&](const auto& row) {
      return row.trial == rows[begin].trial && row.rock == rows[begin].rock;
    };
    while (end < rows.size() && of_one(rows[end])) ++end;
    rock = std::find_if(rock, chunk.rocks.end(), of_one);  // rows are sorted in the order of the rocks
    stretches.push_back({*rock, begin, end});
  }
  return stretches;
}

/// Thins each stretch of one mode separately. A stretch ends where the next one begins.
std::vector<Tracks::Point> Tracks::thinned(const std::vector<Point>& path, double tolerance) {
  std::vector<Point> kept = {path.front()};
  for (std::size_t begin = 0; begin + 1 < path.size();) {
    std::size_t end = begin + 1;
    while (end + 1 < path.size() && path[end + 1].mode == path[begin + 1].mode) ++end;
    std::vector<Vec3> places;
    for (std::size_t i = begin; i <= end; ++i) places.push_back(path[i].place);
    const std::vector<std::size_t> of_places = simplify(places, tolerance);
    for (std::size_t i = 1; i < of_places.size(); ++i) kept.push_back(path[begin + of_places[i]]);
    begin = end;
  }
  return kept;
}

double Tracks::tolerance(int group) const { return track_tolerance * boxes_.at(group).diagonal().norm(); }

void Tracks::add(const TrialRecords& chunk) {
  const std::vector<Stretch> stretches = stretches_of(chunk);
  for (const auto& [rock, begin, end] : stretches)
    for (std::size_t i = begin; i < end; ++i)
      boxes_[rock.group].extend(chunk.trajectories[i].point.state.position);
  for (const auto& [rock, begin, end] : stretches) {
    // Thinning again may save room, but rarely more than half of it.
    full_ = full_ || kept_ > 2 * budget_;
    if (full_) return;
    std::vector<Point> path;
    for (std::size_t i = begin; i < end; ++i) {
      const TrajectoryPoint& point = chunk.trajectories[i].point;
      const BodyState& state = point.state;
      const Vec3& at = state.position;
      const Vec3 place = dimension_ == 3 ? Vec3(at.x(), at.z(), at.y()) : Vec3(at.x(), at.y(), 0);
      path.push_back({place, state.time, state.velocity.norm(), point.mode});
    }
    tracks_.push_back({rock.trial, rock.rock, rock.group, rock.reason, thinned(path, tolerance(rock.group))});
    kept_ += tracks_.back().points.size();
  }
}

Json Tracks::data_of(const Track& track, const std::vector<Point>& points) const {
  std::vector<double> x, y, across, t;
  std::vector<int> modes;
  Json speed = Json::array();
  for (const Point& point : points) {
    x.push_back(point.place.x());
    y.push_back(point.place.y());
    across.push_back(point.place.z());
    t.push_back(point.time);
    modes.push_back(static_cast<int>(point.mode));
    speed.push_back(thousandth(point.speed));
  }
  Json data = json_object("trial", track.trial, "rock", track.rock, "group", track.group, "reason",
                          name_of(track.reason), "x", differences(x), "y", differences(y), "t",
                          differences(t), "speed", std::move(speed), "modes", runs_of(modes));
  if (dimension_ == 3) data["across"] = differences(across);
  return data;
}

Json Tracks::data() const {
  Json list = Json::array();
  std::size_t count = 0;
  bool cut = false;
  for (const Track& track : tracks_) {
    const std::vector<Point> points = thinned(track.points, tolerance(track.group));
    cut = (count += points.size()) > budget_;
    if (cut) break;
    list.push_back(data_of(track, points));
  }
  return json_object("list", std::move(list), "cut", cut || full_);
}

}  // namespace flyrock
