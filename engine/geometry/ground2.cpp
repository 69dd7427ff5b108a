#include "geometry/ground2.h"

#include <algorithm>

#include "geometry/doubled_area.h"
#include "geometry/plan_zone.h"

namespace flyrock {

namespace {
// If the directions of two segments differ by less than this angle [rad], the point between them is flat and
// no feature. A body then does not feel the internal edge.
constexpr double flat_angle = 1e-9;
}  // namespace

Ground2::Ground2(std::vector<Vec2> points, std::vector<int> part)
    : points_(std::move(points)), part_(std::move(part)) {
  measure();
  // The ends may be long and level; the grid covers what is between them.
  const int n = segments();
  const double low = end(0).x(), high = start(n - 1).x();
  cell_ = std::max((high - low) / n, 1e-300);
  int segment = 0;
  for (int k = 0; k < n; ++k) {
    while (segment < n - 1 && end(segment).x() < low + k * cell_) ++segment;
    grid_.push_back(segment);
  }
}

Ground2 Ground2::outline(const std::vector<Vec2>& points) {
  Ground2 line(true);
  // It begins in the middle of a segment, so that all corners lie between two segments.
  const Vec2 middle = 0.5 * (points.front() + points.back());
  line.points_.push_back(middle);
  line.points_.insert(line.points_.end(), points.begin(), points.end());
  line.points_.push_back(middle);
  line.part_.assign(points.size() + 1, 0);
  line.solid_outside_ = doubled_area(points) > 0;
  line.measure();
  return line;
}

void Ground2::measure() {
  const int n = segments();
  for (int i = 0; i < n; ++i) {
    const Vec2 along = end(i) - start(i);
    length_.push_back(along.norm());
    tangent_.push_back(along / length_.back());
    normal_.push_back(perpendicular(tangent_.back()));
    slope_.push_back(along.y() / along.x());
  }
  corner_.assign(n + 1, Corner::flat);
  for (int i = 1; i < n; ++i) {
    const double bend = cross(tangent_[i - 1], tangent_[i]);
    if (bend < -flat_angle) corner_[i] = Corner::convex;
    if (bend > flat_angle) corner_[i] = Corner::concave;
  }
  extent_ = Box2::around(points_);
}

double Ground2::top(double x, int near) const {
  int i = first_segment(x, near);
  const Vec2 &left = start(i), &right = end(i);
  if (left.x() > x) return left.y();
  if (right.x() > x) return left.y() + (x - left.x()) * slope(i);
  double highest = right.y();
  for (++i; i < segments() && end(i).x() == x; ++i) highest = std::max(highest, end(i).y());
  return highest;
}

bool Ground2::is_inside(const Vec2& p) const {
  if (!closed_) return p.y() < top(p.x());
  return flyrock::is_inside(points_, p) != solid_outside_;
}

int Ground2::find_segment(double x, int near) const {
  int i = near;
  if (i < 0) {
    const double cell = (x - end(0).x()) / cell_;
    i = grid_[static_cast<int>(std::clamp(cell, 0.0, static_cast<double>(grid_.size() - 1)))];
  }
  while (i > 0 && end(i - 1).x() >= x) --i;
  while (i < segments() - 1 && end(i).x() < x) ++i;
  return i;
}

Ground2::Run Ground2::segments_between(double x_low, double x_high, int near) const {
  if (x_high < extent_.low.x() || x_low > extent_.high.x()) return {0, -1};
  if (closed_) return {0, segments() - 1};
  Run run{first_segment(x_low, near), 0};
  run.last = run.first;
  while (run.last + 1 < segments() && start(run.last + 1).x() <= x_high) ++run.last;
  return run;
}

Ground2::Run Ground2::near_inside(const Vec2& p) const {
  if (closed_) return {0, segments() - 1};
  const int above = first_segment(p.x());
  const double depth = std::max({start(above).y(), end(above).y(), p.y()}) - p.y();
  return segments_between(p.x() - depth, p.x() + depth);
}

}  // namespace flyrock
