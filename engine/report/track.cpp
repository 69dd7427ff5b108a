#include "report/track.h"

namespace flyrock {

namespace {

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

}  // namespace flyrock
