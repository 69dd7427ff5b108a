#include "report/tracks.h"

#include <algorithm>
#include <cmath>

#include "report/rounded.h"

namespace flyrock {

namespace {

using Json = nlohmann::ordered_json;

/// A thinned path departs from the stored one by this share of the extent of its group at most: a seventh of a pixel of a
/// plot of the group.
constexpr double track_tolerance = 1e-4;

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

/// Rows of a track that a plot needs: each stretch of one mode is thinned, and ends where the next begins.
std::vector<std::size_t> thinned(const std::vector<TrajectoryRecord>& rows, const Track& track, int dimension, double tolerance) {
  std::vector<std::size_t> kept = {track.begin};
  for (std::size_t begin = track.begin; begin + 1 < track.end;) {
    const TravelMode mode = rows[begin + 1].point.mode;
    std::size_t end = begin + 1;
    while (end + 1 < track.end && rows[end + 1].point.mode == mode) ++end;
    std::vector<Vec2> path;
    for (std::size_t i = begin; i <= end; ++i) path.push_back(in_view(rows[i].point.state.position, dimension));
    const std::vector<std::size_t> of_path = simplify(path, tolerance);
    for (std::size_t i = 1; i < of_path.size(); ++i) kept.push_back(begin + of_path[i]);
    begin = end;
  }
  return kept;
}

/// [2, 0, 5, 1]: two points of mode 0, then five of mode 1.
Json runs_of(const std::vector<int>& modes) {
  Json runs = Json::array();
  for (std::size_t i = 0, end = 0; i < modes.size(); i = end) {
    for (end = i; end < modes.size() && modes[end] == modes[i];) ++end;
    runs.push_back(end - i);
    runs.push_back(modes[i]);
  }
  return runs;
}

Json track_data(const std::vector<TrajectoryRecord>& rows, const Track& track, int dimension, double tolerance) {
  std::vector<double> x, y, t;
  std::vector<int> modes;
  Json speed = Json::array();
  for (const std::size_t i : thinned(rows, track, dimension, tolerance)) {
    const BodyState& state = rows[i].point.state;
    const Vec2 place = in_view(state.position, dimension);
    x.push_back(place.x());
    y.push_back(place.y());
    t.push_back(state.time);
    modes.push_back(static_cast<int>(rows[i].point.mode));
    speed.push_back(thousandth(state.velocity.norm()));
  }
  return {{"x", differences(x)}, {"y", differences(y)}, {"t", differences(t)}, {"speed", speed}, {"modes", runs_of(modes)}};
}

/// Null for a body that does not move: it has no row.
const RockRecord* rock_of(const Track& track, const TrialRecords& chunk) {
  const auto rock = std::find_if(chunk.rocks.begin(), chunk.rocks.end(), [&](const RockRecord& row) {
    return row.trial == track.trial && row.rock == track.rock;
  });
  return rock == chunk.rocks.end() ? nullptr : &*rock;
}

double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double length2 = along.squaredNorm();
  if (length2 == 0) return (p - a).norm();
  const double share = std::clamp((p - a).dot(along) / length2, 0.0, 1.0);
  return (p - a - share * along).norm();
}

}  // namespace

std::vector<std::size_t> simplify(const std::vector<Vec2>& points, double tolerance) {
  if (points.empty()) return {};
  std::vector<bool> keep(points.size(), false);
  keep.front() = keep.back() = true;
  // A stack of stretches in place of recursion: a path may have many thousand points.
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

std::vector<Track> tracks_of(const std::vector<TrajectoryRecord>& rows) {
  std::vector<Track> tracks;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (tracks.empty() || tracks.back().trial != rows[i].trial || tracks.back().rock != rows[i].rock)
      tracks.push_back({rows[i].trial, rows[i].rock, i, i});
    tracks.back().end = i + 1;
  }
  return tracks;
}

void Tracks::measure(const TrialRecords& chunk) {
  for (const Track& track : tracks_of(chunk.trajectories)) {
    const RockRecord* rock = rock_of(track, chunk);
    for (std::size_t i = track.begin; rock && i < track.end; ++i)
      boxes_[rock->group].extend(chunk.trajectories[i].point.state.position);
  }
}

void Tracks::see(const TrialRecords& chunk) {
  for (const Track& track : tracks_of(chunk.trajectories))
    if (!cut_) add(track, chunk);
}

void Tracks::add(const Track& track, const TrialRecords& chunk) {
  const RockRecord* rock = rock_of(track, chunk);
  if (!rock) return;
  const double extent = boxes_.at(rock->group).diagonal().norm();
  Json data = {{"trial", track.trial}, {"rock", track.rock}, {"group", rock->group}, {"reason", name_of(rock->reason)}};
  data.update(track_data(chunk.trajectories, track, dimension_, track_tolerance * extent));
  points_ += data["x"].size();
  cut_ = points_ > budget_;
  if (!cut_) list_.push_back(std::move(data));
}

}  // namespace flyrock
