#include "collision/held_3d.h"

#include <algorithm>
#include <cmath>

#include "collision/pairs.h"
#include "collision/smooth/support_feature.h"

namespace flyrock {

namespace {

constexpr double same_direction = 1 - 0.5 * drift_angle * drift_angle;  // its cosine

bool contains(const Moving3& c, FeatureId feature, int point) {
  return contains_piece(c.shape, feature_of(feature), point);
}

}  // namespace

bool is_in_plane(const HeldOnGround& held, const Facet& facet, double size) {
  constexpr double same = 1e-10;  // rad, and m per m
  return kind_of(held.against) == FeatureKind::face &&
         (held.upward - facet.normal).squaredNorm() <= same * same &&
         std::abs(facet.distance(held.place)) <= same * size;
}

bool HeldPoints::has(FeatureId feature, FeatureId against) const {
  return search_.held.hold(feature, against) != Hold::no;
}

bool HeldPoints::of_b(FeatureId feature) const {
  bool known = feature == b_.facet->face_feature();
  for (int i = 0; i < 3; ++i)
    known = known || feature == b_.facet->edge_feature(i) || feature == b_.facet->vertex_feature(i);
  return known;
}

bool HeldPoints::over(FeatureId face, int i) const {
  if (face != b_.facet->face_feature()) return false;
  const FeatureId point = a_.id(FeatureKind::vertex, i);
  return std::any_of(b_.held_on_ground.begin(), b_.held_on_ground.end(), [&](const HeldOnGround& h) {
    return h.feature == point && is_in_plane(h, *b_.facet, search_.size);
  });
}

bool HeldPoints::along_rim(const Vec3& direction, int i, int j, const MovingState& state_of_a) const {
  return std::any_of(b_.held_on_ground.begin(), b_.held_on_ground.end(), [&](const HeldOnGround& h) {
    if (contactor_of(h.feature) != a_.index || !contains(a_, h.feature, i) ||
        !h.contains(b_.facet->vertex[j]))
      return false;
    const int feature = index_of(h.feature);
    if (kind_of(h.feature) == FeatureKind::vertex) return direction.dot(h.upward) > same_direction;
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

HeldPoints::Place HeldPoints::place_of(const Moving3& c, FeatureId feature, const MovingState& s) {
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
Vec3 HeldPoints::normal_of(const Place& a, const Place& b) {
  if (b.kind == FeatureKind::face) return b.normal;
  if (a.kind == FeatureKind::face) return -a.normal;
  const Vec3 away = a.at - b.at, across = a.along.cross(b.along);
  const double most = a.along.norm() * b.along.norm();
  if (most > 0 && across.norm() > 1e-9 * most) return (across.dot(away) < 0 ? -1 : 1) * across.normalized();
  const Vec3& along = a.kind == FeatureKind::edge ? a.along : b.along;
  const double square = along.squaredNorm();
  return (square > 0 ? Vec3(away - along.dot(away) / square * along) : away).normalized();
}

bool HeldPoints::agrees(const Vec3& direction, const Place& a, const Place& b) const {
  return direction.dot(normal_of(a, b)) > same_direction;
}

bool HeldPoints::holds_on(const Features& of, int point) const {
  if (of.of_a) return has(*of.of_a, b_.id(FeatureKind::vertex, point));
  return has(a_.id(FeatureKind::vertex, point), *of.of_b) || over(*of.of_b, point);
}

bool HeldPoints::holds_edges(const Features& of, int i, int j) const {
  const auto on_edge_of_b = [&] {
    for (int rim = 0; rim < 3; ++rim)
      if (b_.facet->edge_feature(rim) == *of.of_b) return j == rim || j == Facet::next(rim);
    return false;
  };
  return contains(a_, *of.of_a, i) && on_edge_of_b() && has(*of.of_a, *of.of_b);
}

Hold HeldPoints::hold(const Vec3& direction, const Features& of, int i, int j, const MovingState& sa) const {
  if (!b_.facet) return Hold::no;
  const bool of_edges = of.of_a && of.of_b;
  const bool exactly = of_edges ? holds_edges(of, i, j) : holds_on(of, of.of_a ? j : i);
  if (by_ == CoreSearch::pill) return exactly ? Hold::exactly : drifts_from(direction, i, j, sa);
  if (of_edges && !along_rim(direction, i, j, sa)) return Hold::no;
  return exactly ? Hold::exactly : of_edges ? Hold::for_now : Hold::no;
}

Hold HeldPoints::drifts_from(const Vec3& direction, int i, int j, const MovingState& sa) const {
  const auto is_vertex = [](FeatureId feature) { return kind_of(feature) == FeatureKind::vertex; };
  const auto is_held = [&](const HeldOnGround& h) {
    if (contactor_of(h.feature) != a_.index || !contains(a_, h.feature, i)) return false;
    const bool of_facet = of_b(h.against);
    if (!(is_vertex(h.feature) && of_facet) && !h.contains(b_.facet->vertex[j])) return false;
    // Two edges have a normal of their own, which only their cross product follows.
    if (!is_vertex(h.feature) && !is_vertex(h.against) && of_facet) return false;
    return agrees(direction, place_of(a_, h.feature, sa), {kind_of(h.against), h.place, h.along, h.upward});
  };
  return std::any_of(b_.held_on_ground.begin(), b_.held_on_ground.end(), is_held) ? Hold::for_now : Hold::no;
}

bool HeldPoints::is_on_ground(int face) const {
  const FeatureId feature = a_.id(FeatureKind::face, face);
  return std::any_of(b_.held_on_ground.begin(), b_.held_on_ground.end(),
                     [&](const HeldOnGround& h) { return h.feature == feature; });
}

std::span<const HeldOnGround> held_on(Workspace& work, const Ground3& ground, const HeldContacts& held) {
  std::vector<HeldOnGround>& found = work.held_on_ground;
  found.clear();
  for (const HeldContact& contact : held.list) {
    HeldOnGround& on = found.emplace_back(HeldOnGround{contact, {}, 1});
    if (kind_of(contact.against) == FeatureKind::vertex) {
      on.vertex[0] = ground_index(contact.against);
      on.place = ground.vertex(on.vertex[0]);
      continue;
    }
    const Facet facet = ground.facet(ground.facet_of(contact.against));
    const int rim = static_cast<int>(ground_index(contact.against) % 3);
    on.vertex = facet.vertex;
    on.vertices = 3;
    on.upward = facet.normal;
    on.place = facet.corner[0];
    if (kind_of(contact.against) != FeatureKind::edge) continue;
    on.vertex = {facet.vertex[rim], facet.vertex[Facet::next(rim)]};
    on.vertices = 2;
    on.place = facet.corner[rim];
    on.along = facet.along(rim);
  }
  return found;
}

TouchSearch without_distant(Workspace& work, const Moving3& c, const Ground3& ground,
                            const TouchSearch& search) {
  constexpr double distant = 1e-4;  // of the size
  work.still_held.clear();
  const Placed3 start{c.shape, {c.motion.x, c.motion.turn(0).rotation}, c.index};
  for (const HeldContact& h : search.held.list)
    if (contactor_of(h.feature) != c.index ||
        feature_gap<3>(work, start, h.feature, ground, h.against, h.normal) <= distant * search.size)
      work.still_held.push_back(h);
  TouchSearch near = search;
  near.held.list = work.still_held;
  return near;
}

}  // namespace flyrock
