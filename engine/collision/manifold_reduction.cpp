#include "collision/manifold_reduction.h"

#include <algorithm>
#include <array>

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

/// The point q for which all other points lie on the left of the line from points[from] to q; the farthest
/// one if several points qualify.
std::size_t next_on_hull(std::span<const Vec3> points, std::size_t from, const Vec3& normal) {
  std::size_t next = from;
  for (std::size_t j = 0; j < points.size(); ++j) {
    if (j == from) continue;
    const Vec3 a = points[next] - points[from], b = points[j] - points[from];
    const double turn = normal.dot(a.cross(b));
    if (next == from || turn < 0 || (turn == 0 && b.squaredNorm() > a.squaredNorm())) next = j;
  }
  return next;
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
  std::sort(kept.begin(), kept.end());
  const auto end = std::unique(kept.begin(), kept.end());
  std::size_t to = begin;
  for (auto from = kept.begin(); from != end; ++from) contacts[to++] = contacts[*from];
  contacts.resize(to);
}

double tributary_area(std::span<const Vec3> points, std::size_t which, const Vec3& normal) {
  if (points.size() < 3) return 0;
  const std::size_t next = next_on_hull(points, which, normal);
  for (const Vec3& p : points)  // a point inside the hull has neighbours on both sides of any line
    if (normal.dot((points[next] - points[which]).cross(p - points[which])) < 0) return 0;
  Vec3 sum = points[which];
  std::size_t before = which, corners = 1;
  for (std::size_t i = next; i != which && corners < points.size(); i = next_on_hull(points, i, normal)) {
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
