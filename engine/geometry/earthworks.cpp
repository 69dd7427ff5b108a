#include "geometry/earthworks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "math/space.h"

namespace flyrock {

namespace {

/// A unit vector; exact for an upright side.
Vec2 direction(double slope) { return {std::max(0.0, std::cos(slope)), std::sin(slope)}; }

/// The horizontal run of a side [m].
double run_of(double height, double slope) {
  const Vec2 along = direction(slope);
  return height * along.x() / along.y();
}

class Works {
 public:
  explicit Works(Profile& profile) : profile_(profile) {}

  /// Replaces the ground from `x` on by an outline: steps from the ground, then straight along `last` until
  /// it meets the ground again. `side`: -1 below the ground, 1 above. Returns where it ends.
  Vec2 put(const char* part, double x, const std::vector<Vec2>& steps, const Vec2& last, int side) {
    part_ = part;
    x = at_point_near(x);
    const std::size_t after = first_after(x);
    std::vector<Vec2> outline = {start(x, after)};
    for (const Vec2& step : steps) outline.push_back(outline.back() + step);
    check_corners(outline, side);
    const auto [end, segment] = meeting(outline.back(), last);
    outline.push_back(end);
    check_ground(outline, side);
    replace(outline, after, segment);
    return end;
  }

 private:
  [[noreturn]] void fail(const std::string& text) const {
    throw EarthworksError(fmt::format("the {} {}", part_, text));
  }

  /// The place of a point of the profile that x means: a toe at 26.751 m that was written as 26.75.
  double at_point_near(double x) const {
    constexpr double rounding = 0.01;  // m
    double nearest = x, gap = rounding;
    for (const Vec2& point : profile_.points)
      if (std::abs(point.x() - x) <= gap) {
        nearest = point.x();
        gap = std::abs(point.x() - x);
      }
    return nearest;
  }

  /// The first point to the right of x.
  std::size_t first_after(double x) const {
    const auto& points = profile_.points;
    if (!(x >= profile_.x_min() && x < profile_.x_max()))
      fail(fmt::format("begins at x = {:.6g} m, the profile goes from {:.6g} to {:.6g} m", x,
                       profile_.x_min(), profile_.x_max()));
    const auto after = std::upper_bound(points.begin(), points.end(), x,
                                        [](double value, const Vec2& point) { return value < point.x(); });
    return static_cast<std::size_t>(after - points.begin());
  }

  Vec2 start(double x, std::size_t after) const {
    const Vec2 &a = profile_.points[after - 1], &b = profile_.points[after];
    return {x, a.y() + (x - a.x()) / (b.x() - a.x()) * (b.y() - a.y())};
  }

  /// Where a ray first meets the ground, and on which segment.
  std::pair<Vec2, std::size_t> meeting(const Vec2& from, const Vec2& along) const {
    double least = std::numeric_limits<double>::infinity();
    std::size_t segment = 0;
    for (std::size_t i = 0; i + 1 < profile_.points.size(); ++i) {
      const Vec2 &a = profile_.points[i], side = profile_.points[i + 1] - a, to_a = a - from;
      const double across = cross(along, side);
      if (across == 0 || profile_.points[i + 1].x() < from.x()) continue;
      const double t = cross(to_a, side) / across, s = cross(to_a, along) / across;
      if (t > 0 && s >= 0 && s <= 1 && t < least) {
        least = t;
        segment = i;
      }
    }
    if (!std::isfinite(least))
      fail(fmt::format("does not come back to the ground before the profile ends at x = {:.6g} m",
                       profile_.x_max()));
    return {from + least * along, segment};
  }

  [[noreturn]] void refuse_meeting(double x) const {
    fail(fmt::format(
        "meets the ground at x = {:.6g} m, before its far side does: expected gentler ground, or other "
        "measures",
        x));
  }

  /// All corners but the first one lie on one side of the ground.
  void check_corners(const std::vector<Vec2>& corners, int side) const {
    for (std::size_t i = 1; i < corners.size(); ++i) {
      const double x = corners[i].x();
      if (x >= profile_.x_max())
        fail(fmt::format("does not come back to the ground before the profile ends at x = {:.6g} m",
                         profile_.x_max()));
      if (side * (corners[i].y() - profile_.height(x)) <= 0) refuse_meeting(x);
    }
  }

  /// The points of the ground below or above the outline lie on its other side.
  void check_ground(const std::vector<Vec2>& outline, int side) const {
    for (const Vec2& point : profile_.points)
      for (std::size_t i = 0; i + 1 < outline.size(); ++i) {
        const Vec2 &a = outline[i], &b = outline[i + 1];
        if (!(point.x() > a.x() && point.x() < b.x())) continue;
        const double height = a.y() + (point.x() - a.x()) / (b.x() - a.x()) * (b.y() - a.y());
        if (side * (height - point.y()) <= 0) refuse_meeting(point.x());
      }
  }

  /// The outline takes the place of the points from `after` to the end of `segment`, which stays.
  void replace(const std::vector<Vec2>& outline, std::size_t after, std::size_t segment) {
    Profile made = {
        .points = {profile_.points.begin(), profile_.points.begin() + static_cast<std::ptrdiff_t>(after)},
        .part = {profile_.part.begin(), profile_.part.begin() + static_cast<std::ptrdiff_t>(after) - 1},
        .parts = profile_.parts,
        .faces = profile_.faces};
    const auto go_to = [&](const Vec2& point, int part) {
      if (point == made.points.back()) return;
      made.points.push_back(point);
      made.part.push_back(part);
    };
    auto own = std::find(made.parts.begin(), made.parts.end(), part_);
    if (own == made.parts.end()) own = made.parts.insert(own, part_);
    const int index = static_cast<int>(own - made.parts.begin());
    go_to(outline.front(), profile_.part[after - 1]);
    for (std::size_t i = 1; i < outline.size(); ++i) go_to(outline[i], index);
    for (std::size_t i = segment; i + 1 < profile_.points.size(); ++i)
      go_to(profile_.points[i + 1], profile_.part[i]);
    profile_ = std::move(made);
  }

  Profile& profile_;
  const char* part_ = "";
};

}  // namespace

Profile with_earthworks(Profile profile, const Earthworks& works) {
  Works put(profile);
  std::optional<double> edge;
  if (const auto& ditch = works.ditch)
    edge =
        put.put("ditch", ditch->x, {{run_of(ditch->depth, ditch->slope), -ditch->depth}, {ditch->width, 0}},
                direction(ditch->slope), -1)
            .x();
  if (const auto& bund = works.bund) {
    const Vec2 down = {direction(bund->slope).x(), -direction(bund->slope).y()};
    put.put("bund", bund->x ? *bund->x : edge.value_or(0) + bund->distance,
            {{run_of(bund->height, bund->slope), bund->height}, {bund->top, 0}}, down, 1);
  }
  return profile;
}

}  // namespace flyrock
