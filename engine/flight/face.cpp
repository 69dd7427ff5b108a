#include "flight/face.h"

#include <algorithm>
#include <cmath>

#include "flight/ground.h"
#include "math/polynomial.h"

namespace flyrock {

namespace {

constexpr double no_touch = infinite;

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

/// When the distance of a curve from a place along n, `from` at its start, falls through 0.
template <int D>
double fall_along(const Parabola<D>& path, const Vec<D>& n, double from, bool at_zero) {
  return fall_of_parabola(from, n.dot(path.v), 0.5 * n.dot(path.a), at_zero);
}
template <int D>
double fall_along(const Arc<D>& arc, const Vec<D>& n, double from, bool at_zero) {
  if (arc.is_parabola) return fall_of_parabola(from, n.dot(arc.c[1]), n.dot(arc.c[2]), at_zero);
  std::array<double, 6> distance = arc.along(n);
  distance[0] = from;
  return fall_of(distance, at_zero);
}

Face<2> face_of(const Terrain2& terrain, int segment) {
  const Vec2& tangent = terrain.tangent(segment);
  return {.id = segment,
          .part = terrain.part(segment),
          .rims = 2,
          .normal = terrain.normal(segment),
          .corner = {terrain.start(segment), terrain.end(segment)},
          .inward = {tangent, -tangent}};
}

Face<3> face_of(const Terrain3& terrain, const Facet& facet) {
  Face<3> face{.id = static_cast<int>(facet.id),
               .part = terrain.ground().part(facet.id),
               .rims = facet.unbounded ? 0 : 3,
               .normal = facet.normal,
               .corner = facet.corner,
               .inward = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}};
  for (int i = 0; i < face.rims; ++i) face.inward[i] = facet.normal.cross(facet.along(i)).normalized();
  return face;
}

// What a touch asks of a part of the ground, without its Face, which takes longer to make.
const Vec2& normal_of(const Terrain2& terrain, int segment) { return terrain.normal(segment); }
const Vec2& corner_of(const Terrain2& terrain, int segment) { return terrain.start(segment); }
bool is_over(const Terrain2& terrain, int segment, const Vec2& place, double reach) {
  const double along = terrain.tangent(segment).dot(place - terrain.start(segment));
  return along >= -reach && along <= terrain.length(segment) + reach;
}
const Vec3& normal_of(const Terrain3&, const Facet& facet) { return facet.normal; }
const Vec3& corner_of(const Terrain3&, const Facet& facet) { return facet.corner[0]; }
bool is_over(const Terrain3& terrain, const Facet& facet, const Vec3& place, double reach) {
  return face_of(terrain, facet).is_over(place, reach);
}

/// When a curve touches a part of the ground, at most at s = end; infinity if it does not.
template <class Curve, class Terrain, class Part>
double touch(const Curve& curve, const Terrain& terrain, const Part& part, double end) {
  const auto& normal = normal_of(terrain, part);
  const double height = normal.dot(curve.origin() - corner_of(terrain, part));
  const bool at_zero = std::abs(height) <= face_reach && is_over(terrain, part, curve.origin(), face_reach);
  const double s = fall_along(curve, normal, height, at_zero);
  return s <= end && is_over(terrain, part, curve.position(s), face_reach) ? s : no_touch;
}

/// When a curve passes an end of the domain; infinity if it does not.
template <class Curve, int D>
double exit_of(const Curve& curve, const Domain<D>& domain) {
  double first = no_touch;
  for (int k = 0; k < D - 1; ++k)
    for (const int side : {-1, 1}) {
      const double end = side < 0 ? domain.low[k] : domain.high[k];
      if (std::isinf(end)) continue;
      const double ahead = -side * curve.origin()[k] + side * end;
      const double rate = -side * curve.rate()[k], bend = -side * curve.bend()[k];
      const bool out = ahead <= 0 && (rate < 0 || (rate == 0 && bend < 0));
      const Vec<D> inward = -side * Vec<D>::Unit(k);
      first = std::min(first, out ? 0 : fall_along(curve, inward, ahead, ahead <= 0));
    }
  return first <= curve.end() ? first : no_touch;
}

/// The end of a curve that touches the ground and passes an end of the terrain at these s.
ArcEnd end_at(double end, double touched, double left, int segment = -1) {
  if (touched <= end && touched <= left) return {touched, true, false, false, segment};
  if (left <= end) return {left, false, true};
  return {end};
}

struct Touch {
  double s = no_touch;
  int segment = -1;
};

/// The first touch over the segments that a parabola passes, in their order.
Touch march(const Parabola<2>& path, const PointGround<2>& ground, double end) {
  const Terrain2& terrain = ground.terrain;
  const double x = path.x.x(), to = x + path.v.x() * end;
  const int last = terrain.segments() - 2;  // the first and the last segment lie beyond the profile
  Touch first;
  double limit = to + (to >= x ? face_reach : -face_reach);
  // Whether the path touches segment i before the others.
  const auto is_first = [&](int i) {
    const double t = touch(path, terrain, i, end);
    if (!(t < first.s)) return false;
    first = {t, i};
    end = t;
    return true;
  };
  if (to >= x) {
    for (int i = std::max(terrain.first_segment(x - face_reach, ground.near), 1);
         i <= last && terrain.start(i).x() <= limit; ++i)
      if (is_first(i)) limit = path.position(first.s).x() + face_reach;
  } else {
    const int from = terrain.segments_between(x + face_reach, x + face_reach, ground.near).last;
    for (int i = std::clamp(from, 1, last); i >= 1 && terrain.end(i).x() >= limit; --i)
      if (is_first(i)) limit = path.position(first.s).x() - face_reach;
  }
  return first;
}

/// When a parabola passes an end of the profile; infinity if it does not.
double exit_of(const Parabola<2>& path, const Terrain2& terrain) {
  const double x = path.x.x(), rate = path.v.x();
  const double room = rate < 0 ? x - terrain.profile().x_min() : terrain.profile().x_max() - x;
  if (rate == 0) return no_touch;
  const double t = std::max(0.0, room) / std::abs(rate);
  return t <= path.length ? t : no_touch;
}

Touch first_of(const Arc<2>& arc, const Terrain2& terrain, double end) {
  const Box2 box = arc.part(0, end).box();
  const auto run = terrain.segments_between(box.low.x() - face_reach, box.high.x() + face_reach);
  Touch first;
  for (int i = std::max(1, run.first); i <= std::min(run.last, terrain.segments() - 2); ++i)
    if (const double s = touch(arc, terrain, i, std::min(end, first.s)); s < first.s) first = {s, i};
  return first;
}

/// A box that contains the curve over [from, to] of s, with face_reach to spare.
Box3 box_over(const Arc<3>& arc, double from, double to) {
  return arc.part(from, to).box().grown(face_reach);
}
Box3 box_over(const Parabola<3>& path, double from, double to) {
  return swept_box(Path<3>{path.position(from), path.velocity(from), path.a}, face_reach, to - from);
}

/// The first touch within [from, to] of s. The curve is halved until few facets are near a part of it.
template <class Curve>
double first_of(const Curve& curve, const Terrain3& terrain, double from, double to,
                std::vector<Facet>& facets) {
  constexpr int few = 16;
  const Box3 box = box_over(curve, from, to);
  const int met = terrain.ground().count(box, few + 1);
  if (met == 0) return no_touch;
  if (met > few && to - from > 1e-6 * curve.end()) {
    const double middle = 0.5 * (from + to);
    const double first = first_of(curve, terrain, from, middle, facets);
    return first < no_touch ? first : first_of(curve, terrain, middle, to, facets);
  }
  facets.clear();
  terrain.ground().triangles(box, facets);
  double first = no_touch;
  for (const Facet& facet : facets)
    first = std::min(first, touch(curve, terrain, facet, std::min(to, first)));
  return first;
}

/// When a parabola is certainly below all ground: a later touch is impossible.
double below_all(const Parabola<3>& path, const Ground3& ground) {
  const double low = ground.extent().low.z();
  if (std::isinf(low)) return path.length;
  const double t = fall_of_parabola(path.x.z() - low + 1, path.v.z(), 0.5 * path.a.z(), false);
  return std::min(t, path.length);
}
double below_all(const Arc<3>&, const Ground3&) { return 1; }

/// A part of the curve, from its start, that is about as long as `length` [m] > 0.
double piece_of(const Arc<3>& arc, double length) { return length / (arc.c[1].norm() + arc.c[2].norm()); }
double piece_of(const Parabola<3>& path, double length) {
  const double speed = path.v.norm();
  return 2 * length / (speed + std::sqrt(speed * speed + 2 * length * path.a.norm()));
}

template <class Curve>
ArcEnd end_in_space(const Curve& curve, const PointGround<3>& ground) {
  thread_local std::vector<Facet> facets;  // keeps its memory between calls
  const Ground3& surface = ground.terrain.ground();
  double left = exit_of(curve, domain_of(ground.terrain));
  const double end = std::min({left, below_all(curve, surface), curve.end()});
  double from = 0, touched = no_touch;
  // Pieces grow from the length of a few facets, because most flights are short.
  double piece = surface.cell() > 0 ? std::min(piece_of(curve, 4 * surface.cell()), end) : end;
  while (from < end && touched == no_touch) {
    const double to = end - from < 1.5 * piece ? end : from + piece;
    touched = first_of(curve, ground.terrain, from, to, facets);
    from = to;
    piece *= 2;
  }
  if (!surface.whole()) {  // straight in plan between its ends
    const double s = std::min(touched, end), until = curve.time(s) - curve.start;
    if (until > 0) {
      const Path<3> chord{curve.origin(), (curve.position(s) - curve.origin()) / until, Vec3::Zero()};
      const double over = time_over_ground(ground.terrain, chord, until);
      if (over < until) left = std::min(left, std::min(1.0, over / until * (1 + 1e-9) + 1e-12) * s);
    }
  }
  return end_at(curve.end(), touched, left);
}

}  // namespace

void faces_at(const Terrain2& terrain, const Vec2& at, int near, std::vector<Face<2>>& faces) {
  const int last = terrain.segments() - 2;
  const auto is_on = [&](int i) {
    return std::abs(terrain.normal(i).dot(at - terrain.start(i))) <= 2 * face_reach &&
           is_over(terrain, i, at, 2 * face_reach);
  };
  // Most points lie on one segment, away from its ends, and many come back to it.
  if (faces.size() == 1 && faces[0].id == near && terrain.start(near).x() < at.x() - face_reach &&
      at.x() + face_reach < terrain.end(near).x() && is_on(near))
    return;
  faces.clear();
  for (int i = std::max(1, terrain.first_segment(at.x() - face_reach, near));
       i <= last && terrain.start(i).x() <= at.x() + face_reach; ++i)
    if (is_on(i)) faces.push_back(face_of(terrain, i));
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

ArcEnd end_of(const Parabola<2>& path, const PointGround<2>& ground) {
  // No segment goes on beyond an end of the profile.
  const Touch first = march(path, ground, path.length);
  if (first.segment >= 0) return {first.s, true, false, false, first.segment};
  return end_at(path.length, no_touch, exit_of(path, ground.terrain));
}

ArcEnd end_of(const Arc<2>& arc, const PointGround<2>& ground) {
  const double left = exit_of(arc, domain_of(ground.terrain));
  const Touch first = first_of(arc, ground.terrain, std::min(left, 1.0));
  return end_at(1, first.s, left, first.segment);
}

ArcEnd end_of(const Parabola<3>& path, const PointGround<3>& ground) { return end_in_space(path, ground); }
ArcEnd end_of(const Arc<3>& arc, const PointGround<3>& ground) { return end_in_space(arc, ground); }

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
