#include "collision/terrain.h"

#include <algorithm>

namespace flyrock {

namespace {
// If the directions of two segments differ by less than this angle [rad], the point between them is flat and
// no feature. A body then does not feel the internal edge.
constexpr double flat_angle = 1e-9;

constexpr double beyond = 1000;  // m
}  // namespace

Terrain2::Terrain2(Profile profile) : profile_(std::move(profile)), names_(terrain_names(profile_.parts)) {
  points_.push_back(profile_.points.front() - Vec2(beyond, 0));
  points_.insert(points_.end(), profile_.points.begin(), profile_.points.end());
  points_.push_back(profile_.points.back() + Vec2(beyond, 0));
  part_.push_back(profile_.part.front());
  part_.insert(part_.end(), profile_.part.begin(), profile_.part.end());
  part_.push_back(profile_.part.back());
  const int n = segments();
  for (int i = 0; i < n; ++i) {
    const Vec2 along = end(i) - start(i);
    length_.push_back(along.norm());
    tangent_.push_back(along / length_.back());
    normal_.push_back(perpendicular(tangent_.back()));
  }
  corner_.assign(n + 1, Corner::flat);
  for (int i = 1; i < n; ++i) {
    const double bend = cross(tangent_[i - 1], tangent_[i]);
    if (bend < -flat_angle) corner_[i] = Corner::convex;
    if (bend > flat_angle) corner_[i] = Corner::concave;
  }
  cell_ = std::max((profile_.x_max() - profile_.x_min()) / n, 1e-300);
  int segment = 0;
  for (int k = 0; k < n; ++k) {
    while (segment < n - 1 && end(segment).x() < profile_.x_min() + k * cell_) ++segment;
    grid_.push_back(segment);
  }
}

double Terrain2::height(double x) const {
  return profile_.height(std::clamp(x, profile_.x_min(), profile_.x_max()));
}

int Terrain2::first_segment(double x) const {
  const double cell = (x - profile_.x_min()) / cell_;
  int i = grid_[static_cast<int>(std::clamp(cell, 0.0, static_cast<double>(grid_.size() - 1)))];
  while (i > 0 && end(i - 1).x() >= x) --i;
  while (i < segments() - 1 && end(i).x() < x) ++i;
  return i;
}

Terrain2::Run Terrain2::segments_between(double x_low, double x_high) const {
  if (x_high < points_.front().x() || x_low > points_.back().x()) return {0, -1};
  Run run{first_segment(x_low), 0};
  run.last = run.first;
  while (run.last + 1 < segments() && start(run.last + 1).x() <= x_high) ++run.last;
  return run;
}

}  // namespace flyrock
