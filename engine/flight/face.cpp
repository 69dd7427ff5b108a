#include "flight/face.h"

#include <algorithm>
#include <cmath>

#include "flight/ground.h"
#include "math/polynomial.h"

namespace flyrock {

namespace {

constexpr double no_touch = std::numeric_limits<double>::infinity();

/// When c0 + c1 s + c2 s^2 falls through 0 at s >= 0; infinity if it does not. If c0 < 0 it must rise first.
/// `at_zero`: c0 is taken as 0, and a function that does not rise from there never falls back.
double fall_of_parabola(double c0, double c1, double c2, bool at_zero) {
  if (at_zero) return c1 > 0 && c2 < 0 ? -c1 / c2 : no_touch;
  const double discriminant = c1 * c1 - 4 * c0 * c2;
  if (discriminant < 0) return no_touch;
  if (c1 < 0) return c0 >= 0 ? 2 * c0 / (std::sqrt(discriminant) - c1) : no_touch;
  return c2 < 0 ? (c1 + std::sqrt(discriminant)) / (-2 * c2) : no_touch;
}

/// The same for a polynomial of degree 5, up to s = 1.
double fall_of(std::array<double, 6> c, bool at_zero) {
  if (at_zero) {
    if (!(c[1] > 0)) return no_touch;
    c[0] = 0;
  }
  std::array<double, 6> depth;
  double from = 0;
  if (c[0] < 0) {
    for (int k = 0; k < 6; ++k) depth[k] = -c[k];
    const auto rise = first_fall(depth, 0, 1);
    if (!rise || *rise >= 1) return no_touch;
    from = std::nextafter(*rise, 2);
  }
  return first_fall(c, from, 1).value_or(no_touch);
}

/// When the distance of the arc from a place along n, `from` at its start, falls through 0.
template <int D>
double fall_along(const Arc<D>& arc, const Vec<D>& n, double from, bool at_zero) {
  if (arc.is_parabola) return fall_of_parabola(from, n.dot(arc.c[1]), n.dot(arc.c[2]), at_zero);
  std::array<double, 6> distance = arc.along(n);
  distance[0] = from;
  return fall_of(distance, at_zero);
}

inline Face<2> face_of(const Terrain2& terrain, int segment) {
  const Vec2& tangent = terrain.tangent(segment);
  Face<2> face;
  face.id = segment;
  face.part = terrain.part(segment);
  face.normal = terrain.normal(segment);
  face.rims = 2;
  face.corner = {terrain.start(segment), terrain.end(segment)};
  face.inward = {tangent, -tangent};
  return face;
}

Face<3> face_of(const Terrain3& terrain, const Facet& facet) {
  Face<3> face;
  face.id = static_cast<int>(facet.id);
  face.part = terrain.ground().part(facet.id);
  face.normal = facet.normal;
  face.corner = facet.corner;
  face.rims = facet.unbounded ? 0 : 3;
  for (int i = 0; i < face.rims; ++i) face.inward[i] = facet.normal.cross(facet.along(i)).normalized();
  return face;
}

/// When the arc touches a part of the ground, at most at s = end; infinity if it does not. `normal` and
/// `corner` are those of the face, which is made only where the arc comes to its plane.
template <int D, class Terrain, class Part>
double touch(const Arc<D>& arc, const Terrain& terrain, const Part& part, const Vec<D>& normal,
             const Vec<D>& corner, double end) {
  const double height = normal.dot(arc.c[0] - corner);
  const bool at_zero = std::abs(height) <= face_reach && face_of(terrain, part).is_over(arc.c[0], face_reach);
  const double s = fall_along(arc, normal, height, at_zero);
  return s <= end && face_of(terrain, part).is_over(arc.position(s), face_reach) ? s : no_touch;
}
double touch(const Arc<2>& arc, const Terrain2& terrain, int segment, double end) {
  return touch<2>(arc, terrain, segment, terrain.normal(segment), terrain.start(segment), end);
}
double touch(const Arc<3>& arc, const Terrain3& terrain, const Facet& facet, double end) {
  return touch<3>(arc, terrain, facet, facet.normal, facet.corner[0], end);
}

/// When an arc passes an end of the domain; infinity if it does not.
template <int D>
double exit_of(const Arc<D>& arc, const Domain<D>& domain) {
  double first = no_touch;
  for (int k = 0; k < D - 1; ++k)
    for (const int side : {-1, 1}) {
      const double end = side < 0 ? domain.low[k] : domain.high[k];
      if (std::isinf(end)) continue;
      const double ahead = -side * arc.c[0][k] + side * end;
      const double rate = -side * arc.c[1][k], bend = -side * arc.c[2][k];
      const bool out = ahead <= 0 && (rate < 0 || (rate == 0 && bend < 0));
      const Vec<D> inward = -side * Vec<D>::Unit(k);
      first = std::min(first, out ? 0 : fall_along(arc, inward, ahead, ahead <= 0));
    }
  return first <= 1 ? first : no_touch;
}

ArcEnd end_at(double touched, double left, int segment = -1) {
  if (touched <= 1 && touched <= left) return {touched, true, false, false, segment};
  if (left <= 1) return {left, false, true};
  return {};
}

struct Touch {
  double s = no_touch;
  int segment = -1;
};

/// The first touch over the segments that a parabola without horizontal acceleration passes, in their order.
Touch march(const Arc<2>& arc, const PointGround<2>& ground, double end) {
  const Terrain2& terrain = ground.terrain;
  const double x = arc.c[0].x(), to = x + arc.c[1].x() * end;
  const int last = terrain.segments() - 2;  // the first and the last segment lie beyond the profile
  Touch first;
  double limit = to + (to >= x ? face_reach : -face_reach);
  const auto is_first = [&](int i) {
    const double s = touch(arc, terrain, i, std::min(end, first.s));
    if (s < first.s) first = {s, i};
    return first.segment == i;
  };
  if (to >= x) {
    for (int i = std::max(terrain.first_segment(x - face_reach, ground.near), 1);
         i <= last && terrain.start(i).x() <= limit; ++i)
      if (is_first(i)) limit = arc.position(first.s).x() + face_reach;
  } else {
    const int from = terrain.segments_between(x + face_reach, x + face_reach, ground.near).last;
    for (int i = std::clamp(from, 1, last); i >= 1 && terrain.end(i).x() >= limit; --i)
      if (is_first(i)) limit = arc.position(first.s).x() - face_reach;
  }
  return first;
}

/// When such a parabola passes an end of the profile; infinity if it does not.
double exit_of_parabola(const Arc<2>& arc, const Terrain2& terrain) {
  const double x = arc.c[0].x(), rate = arc.c[1].x();
  const double room = rate < 0 ? x - terrain.profile().x_min() : terrain.profile().x_max() - x;
  if (rate == 0) return no_touch;
  const double s = std::max(0.0, room) / std::abs(rate);
  return s <= 1 ? s : no_touch;
}

Touch first_of(const Arc<2>& arc, const Terrain2& terrain, double end) {
  const Eigen::AlignedBox2d box = arc.part(0, end).box();
  const auto run = terrain.segments_between(box.min().x() - face_reach, box.max().x() + face_reach);
  Touch first;
  for (int i = std::max(1, run.first); i <= std::min(run.last, terrain.segments() - 2); ++i)
    if (const double s = touch(arc, terrain, i, std::min(end, first.s)); s < first.s) first = {s, i};
  return first;
}

/// The first touch within [from, to] of s. The arc is halved until few facets are near a part of it.
double first_of(const Arc<3>& arc, const Terrain3& terrain, double from, double to,
                std::vector<Facet>& facets) {
  constexpr int few = 16;
  const Eigen::AlignedBox3d bounds = arc.part(from, to).box();
  const Box3 box{bounds.min().array() - face_reach, bounds.max().array() + face_reach};
  const int met = terrain.ground().count(box, few + 1);
  if (met == 0) return no_touch;
  if (met > few && to - from > 1e-6) {
    const double middle = 0.5 * (from + to);
    const double first = first_of(arc, terrain, from, middle, facets);
    return first < no_touch ? first : first_of(arc, terrain, middle, to, facets);
  }
  facets.clear();
  terrain.ground().triangles(box, facets);
  double first = no_touch;
  for (const Facet& facet : facets) first = std::min(first, touch(arc, terrain, facet, std::min(to, first)));
  return first;
}

/// When a parabola is certainly below all ground: a later touch is impossible.
double below_all(const Arc<3>& arc, const Ground3& ground) {
  const double low = ground.extent().low.z();
  if (std::isinf(low)) return 1;
  const double s = fall_of_parabola(arc.c[0].z() - low + 1, arc.c[1].z(), arc.c[2].z(), false);
  return std::min(s, 1.0);
}

}  // namespace

void faces_at(const Terrain2& terrain, const Vec2& at, int near, std::vector<Face<2>>& faces) {
  faces.clear();
  const int last = terrain.segments() - 2;
  for (int i = std::max(1, terrain.first_segment(at.x() - face_reach, near));
       i <= last && terrain.start(i).x() <= at.x() + face_reach; ++i) {
    if (std::abs(terrain.normal(i).dot(at - terrain.start(i))) > 2 * face_reach) continue;
    const Face<2> face = face_of(terrain, i);
    if (face.is_over(at, 2 * face_reach)) faces.push_back(face);
  }
}

void faces_at(const Terrain3& terrain, const Vec3& at, int, std::vector<Face<3>>& faces) {
  faces.clear();
  thread_local std::vector<Facet> facets;  // keeps its memory between calls
  facets.clear();
  const Vec3 reach = Vec3::Constant(2 * face_reach);
  terrain.ground().triangles({at - reach, at + reach}, facets);
  for (const Facet& facet : facets) {
    if (std::abs(facet.distance(at)) > 2 * face_reach) continue;
    const Face<3> face = face_of(terrain, facet);
    if (face.is_over(at, 2 * face_reach)) faces.push_back(face);
  }
}

ArcEnd end_of(const Arc<2>& arc, const PointGround<2>& ground) {
  const bool ordered = arc.is_parabola && arc.c[2].x() == 0;
  const double left =
      ordered ? exit_of_parabola(arc, ground.terrain) : exit_of(arc, domain_of(ground.terrain));
  const double end = std::min(left, 1.0);
  const Touch first = ordered ? march(arc, ground, end) : first_of(arc, ground.terrain, end);
  return end_at(first.s, left, first.segment);
}

ArcEnd end_of(const Arc<3>& arc, const PointGround<3>& ground) {
  thread_local std::vector<Facet> facets;  // keeps its memory between calls
  double left = exit_of(arc, domain_of(ground.terrain));
  const double low = arc.is_parabola ? below_all(arc, ground.terrain.ground()) : 1,
               end = std::min({left, low, 1.0});
  double from = 0, touched = no_touch;
  // Pieces grow from the length of a few facets, because most flights are short.
  const double few_facets = 4 * ground.terrain.ground().cell();
  const double rate = arc.c[1].norm() + arc.c[2].norm();
  double piece = few_facets > 0 && rate > 0 ? std::min(few_facets / rate, end) : end;
  while (from < end && touched == no_touch) {
    const double to = end - from < 1.5 * piece ? end : from + piece;
    touched = first_of(arc, ground.terrain, from, to, facets);
    from = to;
    piece *= 2;
  }
  if (!ground.terrain.ground().whole()) {  // straight in plan between its ends
    const double until = std::min(touched, end) * arc.length;
    if (until > 0) {
      const Path<3> chord{arc.c[0], (arc.position(until / arc.length) - arc.c[0]) / until, Vec3::Zero()};
      const double over = time_over_ground(ground.terrain, chord, until);
      if (over < until) left = std::min(left, std::min(1.0, over / arc.length * (1 + 1e-9) + 1e-12));
    }
  }
  return end_at(touched, left);
}

template <int D>
std::optional<double> end_on(const Arc<D>& arc, const Face<D>& face) {
  double first = no_touch;
  for (int i = 0; i < face.rims; ++i) {
    const double inside = face.inside(i, arc.c[0]);
    first = std::min(first, fall_along(arc, face.inward[i], inside, inside <= face_reach));
  }
  return first <= 1 ? std::optional(first) : std::nullopt;
}

template std::optional<double> end_on(const Arc<2>&, const Face<2>&);
template std::optional<double> end_on(const Arc<3>&, const Face<3>&);

}  // namespace flyrock
