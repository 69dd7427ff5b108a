#include "collision/manifold_reduction.h"

#include <algorithm>
#include <array>
#include <concepts>

namespace flyrock {

namespace {

/// The index of the greatest value from `begin` on; the first one if several are equal.
template <class Value>
std::size_t greatest(const std::vector<ContactPoint<3>>& contacts, std::size_t begin, Value&& value) {
  std::size_t best = begin;
  for (std::size_t i = begin + 1; i < contacts.size(); ++i)
    if (value(contacts[i]) > value(contacts[best])) best = i;
  return best;
}

/// The place of each of some points.
template <class Points>
concept PlaceOf = requires(const Points& points, std::size_t i) {
  { points(i) } -> std::convertible_to<Vec3>;
};

/// The one of `count` points for which all others lie on the left of the line from point `from` to it; the
/// farthest one if several points qualify.
std::size_t next_on_hull(std::size_t count, const PlaceOf auto& points, std::size_t from,
                         const Vec3& normal) {
  std::size_t next = from;
  for (std::size_t j = 0; j < count; ++j) {
    if (j == from) continue;
    const Vec3 a = points(next) - points(from), b = points(j) - points(from);
    const double turn = normal.dot(a.cross(b));
    if (next == from || turn < 0 || (turn == 0 && b.squaredNorm() > a.squaredNorm())) next = j;
  }
  return next;
}

/// The area [m2] of the convex hull of `count` points, one corner of which is point `corner`.
double hull_area(std::size_t count, const PlaceOf auto& points, std::size_t corner, const Vec3& normal) {
  constexpr double same = 1e-9;  // of the first edge: a point that coincides with the corner ends the round
  const Vec3 start = points(corner);
  std::size_t at = next_on_hull(count, points, corner, normal);
  const double nearest = same * (points(at) - start).norm();
  double doubled = 0;
  for (std::size_t edges = 2; edges <= count && (points(at) - start).norm() > nearest; ++edges) {
    const std::size_t next = next_on_hull(count, points, at, normal);
    doubled += normal.dot((points(at) - start).cross(points(next) - start));
    at = next;
  }
  return 0.5 * doubled;
}

}  // namespace

void keep_four(std::vector<ContactPoint<3>>& contacts, std::size_t begin) {
  if (contacts.size() - begin <= 4) return;
  const Vec3 normal = contacts[begin].normal;
  std::array<std::size_t, 4> kept;
  kept[0] = greatest(contacts, begin, [](const auto& c) { return -c.gap; });
  const Vec3 first = contacts[kept[0]].point;
  kept[1] = greatest(contacts, begin, [&](const auto& c) { return (c.point - first).squaredNorm(); });
  const Vec3 across = normal.cross(contacts[kept[1]].point - first);
  kept[2] = greatest(contacts, begin, [&](const auto& c) { return across.dot(c.point - first); });
  kept[3] = greatest(contacts, begin, [&](const auto& c) { return -across.dot(c.point - first); });
  // The contact farthest from another one is a corner of the hull of all, and of that of the kept ones.
  const std::size_t corner = kept[1];
  const auto point = [&](std::size_t i) { return contacts[begin + i].point; };
  const double whole = hull_area(contacts.size() - begin, point, corner - begin, normal);
  std::sort(kept.begin(), kept.end());
  const auto end = std::unique(kept.begin(), kept.end());
  const std::size_t corner_of_kept = std::find(kept.begin(), end, corner) - kept.begin();
  std::size_t to = begin;
  for (auto from = kept.begin(); from != end; ++from) contacts[to++] = contacts[*from];
  contacts.resize(to);
  const std::size_t left = to - begin;
  const double dropped = whole - hull_area(left, point, corner_of_kept, normal);
  for (std::size_t i = begin; i < to; ++i)
    contacts[i].dropped_area = std::max(dropped, 0.0) / static_cast<double>(left);
}

double tributary_area(std::span<const Vec3> points, std::size_t which, const Vec3& normal) {
  if (points.size() < 3) return 0;
  const auto place = [&](std::size_t i) { return points[i]; };
  const std::size_t next = next_on_hull(points.size(), place, which, normal);
  for (const Vec3& p : points)  // a point inside the hull has neighbours on both sides of any line
    if (normal.dot((points[next] - points[which]).cross(p - points[which])) < 0) return 0;
  Vec3 sum = points[which];
  std::size_t before = which, corners = 1;
  for (std::size_t i = next; i != which && corners < points.size();
       i = next_on_hull(points.size(), place, i, normal)) {
    sum += points[i];
    ++corners;
    before = i;
  }
  const Vec3 to_centre = sum / static_cast<double>(corners) - points[which];
  const double after = normal.dot((points[next] - points[which]).cross(to_centre));
  const double ahead = normal.dot(to_centre.cross(points[before] - points[which]));
  return 0.25 * (after + ahead);
}

}  // namespace flyrock
