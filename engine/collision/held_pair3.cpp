#include "collision/held_pair3.h"

#include <algorithm>
#include <cmath>

namespace flyrock {

namespace {
constexpr double same_direction = 1 - 5e-7;  // cosine of 1e-3 rad
}

bool HeldPair::holds(FeatureId feature, FeatureId against) const {
  if (!a_.shape.round() && !b_.shape.round()) return search_.holds(feature, against);
  return std::any_of(search_.held.begin(), search_.held.end(), [&](const HeldContact& h) {
    return contactor_of(h.feature) == a_.index && of_b(h.against);
  });
}

bool HeldPair::of_b(FeatureId feature) const {
  if (!b_.facet) return contactor_of(feature) == b_.index;
  bool known = feature == b_.facet->face_feature();
  for (int i = 0; i < 3; ++i)
    known = known || feature == b_.facet->edge_feature(i) || feature == b_.facet->vertex_feature(i);
  return known;
}

bool HeldPair::in_plane(const HeldOnGround& h) const {
  constexpr double same = 1e-10;  // rad, and m per m
  return (h.normal - b_.facet->normal).squaredNorm() <= same * same &&
         std::abs(b_.facet->distance(h.place)) <= same * search_.size;
}

bool HeldPair::over(FeatureId face, int i) const {
  if (!b_.facet || face != b_.facet->face_feature()) return false;
  const FeatureId point = a_.id(FeatureKind::vertex, i);
  return std::any_of(b_.held.begin(), b_.held.end(), [&](const HeldOnGround& h) {
    return h.feature == point && kind_of(h.against) == FeatureKind::face && in_plane(h);
  });
}

bool HeldPair::along(const Vec3& direction, int i, int j, const MovingState& state_of_a) const {
  return std::any_of(b_.held.begin(), b_.held.end(), [&](const HeldOnGround& h) {
    if (contactor_of(h.feature) != a_.index || !contains(a_, h.feature, i) ||
        !h.contains(b_.facet->vertex[j]))
      return false;
    const int feature = index_of(h.feature);
    if (kind_of(h.feature) == FeatureKind::vertex) return direction.dot(h.normal) > same_direction;
    if (kind_of(h.feature) == FeatureKind::face)
      return -direction.dot(state_of_a.arm(a_.shape.faces[feature].normal)) > same_direction;
    const Contactor3::Edge& edge = a_.shape.edges[feature];
    const Vec3 along = state_of_a.arm(a_.shape.points[edge.end] - a_.shape.points[edge.start]);
    for (int rim = 0; rim < 3; ++rim) {
      if (h.against != b_.facet->edge_feature(rim)) continue;
      const Vec3 normal = along.cross(b_.facet->along(rim));
      return std::abs(direction.dot(normal)) > same_direction * normal.norm();
    }
    return false;
  });
}

HeldPair::Place HeldPair::place_of(const MovingContactor& c, FeatureId feature, const MovingState& s) {
  const int i = index_of(feature);
  Place place{kind_of(feature), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  int point = i;
  if (place.kind == FeatureKind::edge) {
    point = c.shape.edges[i].start;
    place.along = s.arm(c.shape.points[c.shape.edges[i].end] - c.shape.points[point]);
  } else if (place.kind == FeatureKind::face) {
    point = c.shape.vertex(c.shape.faces[i], 0);
    place.normal = s.arm(c.shape.faces[i].normal);
  }
  place.at = s.x + s.arm(c.shape.points[point]);
  return place;
}

/// Unit, from b to a. A point or a line without an edge has the direction zero.
Vec3 HeldPair::normal_of(const Place& a, const Place& b) {
  if (b.kind == FeatureKind::face) return b.normal;
  if (a.kind == FeatureKind::face) return -a.normal;
  const Vec3 away = a.at - b.at, across = a.along.cross(b.along);
  const double most = a.along.norm() * b.along.norm();
  if (most > 0 && across.norm() > 1e-9 * most) return (across.dot(away) < 0 ? -1 : 1) * across.normalized();
  const Vec3& along = a.kind == FeatureKind::edge ? a.along : b.along;
  const double square = along.squaredNorm();
  return (square > 0 ? Vec3(away - along.dot(away) / square * along) : away).normalized();
}

bool HeldPair::contains(const MovingContactor& c, FeatureId feature, int point) {
  const int i = index_of(feature);
  switch (kind_of(feature)) {
    case FeatureKind::vertex:
      return i == point;
    case FeatureKind::edge:
      return c.shape.edges[i].start == point || c.shape.edges[i].end == point;
    case FeatureKind::face:
      break;
  }
  const Contactor3::Face& face = c.shape.faces[i];
  const auto* loop = &c.shape.loop[face.first];
  return std::find(loop, loop + face.count, point) != loop + face.count;
}

bool HeldPair::agrees(const Vec3& direction, const Place& a, const Place& b) const {
  return direction.dot(normal_of(a, b)) > same_direction;
}

HeldPair::Hold HeldPair::along_normal(const Vec3& direction, FeatureId feature, int i, int j,
                                      const MovingState& sa, const MovingState& sb) const {
  const FeatureId of_a = a_.id(FeatureKind::vertex, i), of_b = b_.id(FeatureKind::vertex, j);
  if (search_.holds(of_a, feature) || search_.holds(feature, of_b) || over(feature, i)) return Hold::exactly;
  return for_now(direction, i, j, sa, sb);
}

HeldPair::Hold HeldPair::along_edges(const Vec3& direction, FeatureId edge_a, FeatureId edge_b, int i, int j,
                                     const MovingState& sa, const MovingState& sb) const {
  const auto on_edge_b = [&] {
    if (!b_.facet) return contains(b_, edge_b, j);
    for (int rim = 0; rim < 3; ++rim)
      if (b_.facet->edge_feature(rim) == edge_b) return j == rim || j == Facet::next(rim);
    return false;
  };
  if (search_.holds(edge_a, edge_b) && contains(a_, edge_a, i) && on_edge_b()) return Hold::exactly;
  return for_now(direction, i, j, sa, sb);
}

HeldPair::Hold HeldPair::for_now(const Vec3& direction, int i, int j, const MovingState& sa,
                                 const MovingState& sb) const {
  const auto is_vertex = [](FeatureId feature) { return kind_of(feature) == FeatureKind::vertex; };
  const auto on_ground = [&](const HeldOnGround& h) {
    if (contactor_of(h.feature) != a_.index || !contains(a_, h.feature, i)) return false;
    const bool of_facet = of_b(h.against);
    if (!(is_vertex(h.feature) && of_facet) && !h.contains(b_.facet->vertex[j])) return false;
    // Two edges have a normal of their own, which only their cross product follows.
    if (!is_vertex(h.feature) && !is_vertex(h.against) && of_facet) return false;
    return agrees(direction, place_of(a_, h.feature, sa), {kind_of(h.against), h.place, h.along, h.normal});
  };
  const auto on_body = [&](const HeldContact& h) {
    if (contactor_of(h.feature) != a_.index || contactor_of(h.against) != b_.index) return false;
    const bool end_of_a = !a_.shape.has_faces() && h.feature == a_.id(FeatureKind::vertex, i);
    const bool end_of_b = !b_.shape.has_faces() && h.against == b_.id(FeatureKind::vertex, j);
    const bool is_vertex_of_both = (is_vertex(h.feature) || is_vertex(h.against)) &&
                                   contains(a_, h.feature, i) && contains(b_, h.against, j);
    return (end_of_a || end_of_b || is_vertex_of_both) &&
           agrees(direction, place_of(a_, h.feature, sa), place_of(b_, h.against, sb));
  };
  const bool is_held = b_.facet ? std::any_of(b_.held.begin(), b_.held.end(), on_ground)
                                : std::any_of(search_.held.begin(), search_.held.end(), on_body);
  return is_held ? Hold::for_now : Hold::no;
}

bool HeldPair::touches(int face) const {
  const FeatureId feature = a_.id(FeatureKind::face, face);
  return std::any_of(b_.held.begin(), b_.held.end(),
                     [&](const HeldOnGround& h) { return h.feature == feature; });
}

}  // namespace flyrock
