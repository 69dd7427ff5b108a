#include "geometry/profile.h"

#include <fmt/format.h>

#include <algorithm>

namespace flyrock {

double Profile::height(double x) const {
  const auto from = std::lower_bound(points.begin(), points.end(), x,
                                     [](const Vec2& point, double value) { return point.x() < value; });
  if (from == points.end()) return points.back().y();
  if (from->x() > x) {
    if (from == points.begin()) return from->y();
    const Vec2& left = *(from - 1);
    return left.y() + (x - left.x()) / (from->x() - left.x()) * (from->y() - left.y());
  }
  double highest = from->y();
  for (auto point = from; point != points.end() && point->x() == x; ++point)
    highest = std::max(highest, point->y());
  return highest;
}

std::string Profile::face_name(std::size_t face) const {
  return faces[face].name.empty() ? fmt::format("bench_{}", face + 1) : faces[face].name;
}

std::string Profile::fault() const {
  if (points.size() < 2) return fmt::format("a profile has {} points, at least 2 are needed", points.size());
  if (part.size() + 1 != points.size())
    return fmt::format("the profile has {} segments but {} part numbers", segments(), part.size());
  for (int index : part)
    if (index < 0 || index >= static_cast<int>(parts.size()))
      return fmt::format("a profile of {} parts has a segment of part {}", parts.size(), index);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!points[i].allFinite()) return fmt::format("point {} of a profile is not finite", i);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec2 &a = points[i], &b = points[i + 1];
    if (a == b) return fmt::format("a profile has the point ({:.6g}, {:.6g}) twice in a row", a.x(), a.y());
    if (b.x() < a.x())
      return fmt::format(
          "x decreases from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g}); a profile goes from left to right: sort "
          "the "
          "points, or, if the wall overhangs there, run in `dimension: 3` with the section extruded as a "
          "`mesh`",
          a.x(), a.y(), b.x(), b.y());
    const bool back = i > 0 && points[i - 1].x() == a.x() && a.x() == b.x() &&
                      (a.y() - points[i - 1].y()) * (b.y() - a.y()) < 0;
    if (back) return fmt::format("a profile turns straight back at ({:.6g}, {:.6g})", a.x(), a.y());
  }
  if (x_min() == x_max())
    return fmt::format("a profile has no width: all its points have x = {:.6g}", x_min());
  return {};
}

}  // namespace flyrock
