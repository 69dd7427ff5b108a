#include "flight/arc.h"

#include <algorithm>
#include <cmath>

#include "geometry/ground.h"
#include "geometry/profile.h"
#include "math/polynomial.h"

namespace flyrock {

namespace {

/// Coefficients c0 + c1 s + ... of the distance to a line.
using Coefficients = std::array<double, 6>;

/// When the height `p` above a segment or facet falls through 0 over it: over(s) says whether the arc is over
/// it. If the arc is below its line or plane elsewhere, it must first rise through it before it can touch.
template <class Over>
std::optional<double> touch(const Coefficients& p, const Over& over) {
  Coefficients depth;
  std::transform(p.begin(), p.end(), depth.begin(), std::negate());
  std::optional<double> from = 0;
  while (from) {
    const std::optional<double> fall = first_fall(p, *from, 1);
    if (!fall || over(*fall)) return fall;
    const double below = std::nextafter(*fall, 2);
    from = below < 1 ? first_fall(depth, below, 1) : std::nullopt;
  }
  return std::nullopt;
}

std::optional<double> touch(const Arc<3>& arc, const Facet& facet) {
  Coefficients height = arc.along(facet.normal);
  height[0] = facet.distance(arc.c[0]);
  if (facet.unbounded) return first_fall(height, 0, 1);
  return touch(height, [&](double s) {
    const Vec3 place = arc.position(s);
    for (int i = 0; i < 3; ++i)
      if (facet.inside(i, place) < -1e-12 * facet.along(i).norm()) return false;
    return true;
  });
}

/// The first touch within [from, to] of s. The arc is halved until few facets are near a part of it.
std::optional<double> first_touch(const Arc<3>& arc, const Ground3& ground, double from, double to) {
  constexpr int few = 16;
  const Box3 box = arc.part(from, to).box();
  const int met = ground.count(box, few + 1);
  if (met == 0) return std::nullopt;
  if (met > few && to - from > 1e-6) {
    const double middle = 0.5 * (from + to);
    const auto first = first_touch(arc, ground, from, middle);
    return first ? first : first_touch(arc, ground, middle, to);
  }
  std::vector<Facet> facets;
  ground.triangles(box, facets);
  std::optional<double> first;
  for (const Facet& facet : facets)
    if (const auto s = touch(arc, facet); s && (!first || *s < *first)) first = s;
  return first;
}

}  // namespace

template <int D>
Vec<D> Arc<D>::position_of_degree_5(double s) const {
  Vec<D> p = c[5];
  for (int k = 4; k >= 0; --k) p = p * s + c[k];
  return p;
}

template <int D>
Vec<D> Arc<D>::velocity_of_degree_5(double s) const {
  Vec<D> v = 5 * c[5];
  for (int k = 4; k >= 1; --k) v = v * s + k * c[k];
  return v / length;
}

/// Horner's scheme expands p about `from`; then s is scaled.
template <int D>
Arc<D> Arc<D>::part(double from, double to) const {
  Arc part = *this;
  for (int k = 0; k < 5; ++k)
    for (int i = 4; i >= k; --i) part.c[i] += from * part.c[i + 1];
  double scale = 1;
  for (Vec<D>& coefficient : part.c) {
    coefficient *= scale;
    scale *= to - from;
  }
  part.start += from * length;
  part.length *= to - from;
  return part;
}

template <int D>
Box<D> Arc<D>::box() const {
  // Control points b_i = sum over k <= i of C(i, k) / C(5, k) c_k.
  constexpr double share[6][6] = {
      {1}, {1, 0.2}, {1, 0.4, 0.1}, {1, 0.6, 0.3, 0.1}, {1, 0.8, 0.6, 0.4, 0.2}, {1, 1, 1, 1, 1, 1}};
  Box<D> box{c[0], c[0]};
  for (int i = 1; i <= 5; ++i) {
    Vec<D> point = Vec<D>::Zero();
    for (int k = 0; k <= i; ++k) point += share[i][k] * c[k];
    box.add(point);
  }
  return box;
}

template <int D>
Arc<D> arc_between(double start, double length, const FlightState<D>& from, const FlightState<D>& to) {
  Arc<D> arc = parabola(start, length, from);
  const Vec<D> place = to.position - arc.c[0] - arc.c[1] - arc.c[2];
  const Vec<D> speed = length * to.velocity - arc.c[1] - 2 * arc.c[2];
  const Vec<D> half_bend = 0.5 * length * length * (to.acceleration - from.acceleration);
  arc.c[3] = 10 * place - 4 * speed + half_bend;
  arc.c[4] = -15 * place + 7 * speed - 2 * half_bend;
  arc.c[5] = 6 * place - 3 * speed + half_bend;
  arc.is_parabola = arc.c[3].isZero(0) && arc.c[4].isZero(0) && arc.c[5].isZero(0);
  return arc;
}

std::optional<double> first_touch(const Arc<2>& arc, const Profile& ground) {
  const Box2 box = arc.box();
  const auto& points = ground.points;
  auto i = std::lower_bound(points.begin(), points.end(), box.low.x(),
                            [](const Vec2& point, double x) { return point.x() < x; });
  if (i != points.begin()) --i;
  std::optional<double> first;
  for (; i + 1 < points.end() && i->x() <= box.high.x(); ++i) {
    const Vec2 &a = *i, &b = *(i + 1);
    if (std::max(a.y(), b.y()) < box.low.y()) continue;
    const Vec2 normal = perpendicular(b - a).normalized();
    Coefficients height = arc.along(normal);
    height[0] = normal.dot(arc.c[0] - a);
    const Vec2 along = b - a;
    const double slack = 1e-12 * along.squaredNorm();  // so that two neighbours leave no gap
    const auto s = touch(height, [&](double at) {
      const double place = (arc.position(at) - a).dot(along);
      return place >= -slack && place <= along.squaredNorm() + slack;
    });
    if (s && (!first || *s < *first)) first = s;
  }
  return first;
}

std::optional<double> first_touch(const Arc<3>& arc, const Ground3& ground) {
  return first_touch(arc, ground, 0, 1);
}

template <int D>
std::optional<double> first_arrival(const Arc<D>& arc, double x, double side, double end) {
  const Coefficients ahead = arc.along(-side * Vec<D>::Unit(0), side * x);
  return ahead[0] <= 0 ? 0 : first_fall(ahead, 0, end);
}

std::optional<double> first_exit(const Arc<2>& arc, const Profile& ground) {
  std::optional<double> first;
  for (const double side : {-1.0, 1.0}) {
    const double end = side < 0 ? ground.x_min() : ground.x_max();
    const Coefficients inside = arc.along(-side * Vec2::UnitX(), side * end);
    if (const auto s = first_fall(inside, 0, 1); s && (!first || *s < *first)) first = s;
  }
  return first;
}

std::optional<double> first_exit(const Arc<3>& arc, const Ground3& ground) {
  std::optional<double> first;
  for (const double side : {-1.0, 1.0})
    for (int k = 0; k < 2; ++k) {
      const double end = side < 0 ? ground.extent().low[k] : ground.extent().high[k];
      if (std::isinf(end)) continue;
      const Coefficients inside = arc.along(-side * Vec3::Unit(k), side * end);
      if (const auto s = first_fall(inside, 0, 1); s && (!first || *s < *first)) first = s;
    }
  return first;
}

template std::optional<double> first_arrival(const Arc<2>&, double, double, double);
template std::optional<double> first_arrival(const Arc<3>&, double, double, double);
template struct Arc<2>;
template struct Arc<3>;
template Arc<2> arc_between(double, double, const FlightState<2>&, const FlightState<2>&);
template Arc<3> arc_between(double, double, const FlightState<3>&, const FlightState<3>&);

}  // namespace flyrock
