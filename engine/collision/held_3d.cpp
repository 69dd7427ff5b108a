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
  if (by_ != CoreSearch::ball) return search_.held.hold(feature, against) != Hold::no;
  return std::any_of(search_.held.list.begin(), search_.held.list.end(), [&](const HeldContact& h) {
    return contactor_of(h.feature) == a_.index && of_b(h.against);
  });
}

bool HeldPoints::of_b(FeatureId feature) const {
  if (!b_.facet) return contactor_of(feature) == b_.index;
  bool known = feature == b_.facet->face_feature();
  for (int i = 0; i < 3; ++i)
    known = known || feature == b_.facet->edge_feature(i) || feature == b_.facet->vertex_feature(i);
  return known;
}

bool HeldPoints::over(FeatureId face, int i) const {
  if (!b_.facet || face != b_.facet->face_feature()) return false;
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

bool HeldPoints::holds_beyond(const Features& of, int point, const MovingState& sa,
                              const MovingState& sb) const {
  const bool is_face_of_a = of.of_a.has_value();
  const FeatureId feature = is_face_of_a ? *of.of_a : *of.of_b;
  if (b_.facet || kind_of(feature) != FeatureKind::face) return false;
  const Moving3 &reference = is_face_of_a ? a_ : b_, &other = is_face_of_a ? b_ : a_;
  const MovingState &of_reference = is_face_of_a ? sa : sb, &of_other = is_face_of_a ? sb : sa;
  const Contactor3& shape = reference.shape;
  const int face = index_of(feature);
  return std::any_of(search_.held.list.begin(), search_.held.list.end(), [&](const HeldContact& h) {
    const FeatureId side = is_face_of_a ? h.feature : h.against,
                    crossing = is_face_of_a ? h.against : h.feature;
    if (!is_of_pair(h, a_, b_) || kind_of(side) != FeatureKind::edge ||
        kind_of(crossing) != FeatureKind::edge || !contains(other, crossing, point))
      return false;
    const Contactor3::Edge& edge = shape.edges[index_of(side)];
    if (edge.left != face && edge.right != face) return false;
    const Vec3& start = shape.points[edge.start];
    const Vec3 along =
        edge.left == face ? Vec3(shape.points[edge.end] - start) : Vec3(start - shape.points[edge.end]);
    const Vec3 place = of_reference.turn.rotation.inverse(
        of_other.x + of_other.arm(other.shape.points[point]) - of_reference.x);
    return along.cross(shape.faces[face].normal).dot(place - start) >= 0;
  });
}

bool HeldPoints::holds_edges(const Features& of, int i, int j) const {
  const auto on_edge_of_b = [&] {
    if (!b_.facet) return contains(b_, *of.of_b, j);
    for (int rim = 0; rim < 3; ++rim)
      if (b_.facet->edge_feature(rim) == *of.of_b) return j == rim || j == Facet::next(rim);
    return false;
  };
  return contains(a_, *of.of_a, i) && on_edge_of_b() && has(*of.of_a, *of.of_b);
}

Hold HeldPoints::hold(const Vec3& direction, const Features& of, int i, int j, const MovingState& sa,
                      const MovingState& sb) const {
  const bool of_edges = of.of_a && of.of_b;
  const bool exactly = of_edges ? holds_edges(of, i, j) : holds_on(of, of.of_a ? j : i);
  if (by_ == CoreSearch::pill) return exactly ? Hold::exactly : drifts_from(direction, i, j, sa, sb);
  if (of_edges && b_.facet && !along_rim(direction, i, j, sa)) return Hold::no;
  if (by_ == CoreSearch::hull && !of_edges && !exactly && holds_beyond(of, of.of_a ? j : i, sa, sb))
    return Hold::for_now;
  return exactly ? Hold::exactly : of_edges && b_.facet ? Hold::for_now : Hold::no;
}

Hold HeldPoints::drifts_from(const Vec3& direction, int i, int j, const MovingState& sa,
                             const MovingState& sb) const {
  const auto is_vertex = [](FeatureId feature) { return kind_of(feature) == FeatureKind::vertex; };
  const auto on_ground = [&](const HeldOnGround& h) {
    if (contactor_of(h.feature) != a_.index || !contains(a_, h.feature, i)) return false;
    const bool of_facet = of_b(h.against);
    if (!(is_vertex(h.feature) && of_facet) && !h.contains(b_.facet->vertex[j])) return false;
    // Two edges have a normal of their own, which only their cross product follows.
    if (!is_vertex(h.feature) && !is_vertex(h.against) && of_facet) return false;
    return agrees(direction, place_of(a_, h.feature, sa), {kind_of(h.against), h.place, h.along, h.upward});
  };
  const auto on_body = [&](const HeldContact& h) {
    if (!is_of_pair(h, a_, b_)) return false;
    const bool end_of_a = a_.shape.faces.empty() && h.feature == a_.id(FeatureKind::vertex, i);
    const bool end_of_b = b_.shape.faces.empty() && h.against == b_.id(FeatureKind::vertex, j);
    const bool is_vertex_of_both = (is_vertex(h.feature) || is_vertex(h.against)) &&
                                   contains(a_, h.feature, i) && contains(b_, h.against, j);
    return (end_of_a || end_of_b || is_vertex_of_both) &&
           agrees(direction, place_of(a_, h.feature, sa), place_of(b_, h.against, sb));
  };
  const bool is_held = b_.facet ? std::any_of(b_.held_on_ground.begin(), b_.held_on_ground.end(), on_ground)
                                : std::any_of(search_.held.list.begin(), search_.held.list.end(), on_body);
  return is_held ? Hold::for_now : Hold::no;
}

bool HeldPoints::is_on_ground(int face) const {
  const FeatureId feature = a_.id(FeatureKind::face, face);
  return std::any_of(b_.held_on_ground.begin(), b_.held_on_ground.end(),
                     [&](const HeldOnGround& h) { return h.feature == feature; });
}

HeldPieces::HeldPieces(const Contactor3& shape)
    : shape_(shape), pieces_(static_cast<std::size_t>(pieces_of(shape))) {}

void HeldPieces::add(const ShapeFeature& feature) {
  const auto is_all_round = [](unsigned places) {
    constexpr unsigned half = (1u << rim_places / 2) - 1;
    for (int start = 0; start < rim_places; ++start)
      if (((places >> start | places << (rim_places - start)) & half) == 0) return false;
    return true;
  };
  const bool of_rim = !shape_.circles.empty() && feature.kind == FeatureKind::edge;
  const int place = of_rim ? place_of_rim(feature.index) : rim_places;
  for (int i = 0; i < static_cast<int>(pieces_.size()); ++i) {
    if (!contains_piece(shape_, feature, i)) continue;
    Piece& piece = pieces_[i];
    ++piece.contacts;
    if (place < rim_places) piece.places |= 1u << place;
    piece.whole = piece.whole || place >= rim_places || is_all_round(piece.places);
  }
}

void HeldPieces::add_piece(int piece) {
  ++pieces_[piece].contacts;
  pieces_[piece].whole = true;
}

HeldPair::HeldPair(const Moving3& a, const Moving3& b, const TouchSearch& search)
    : a_(a), b_(b), search_(search), of_a_(a.shape), of_b_(b.shape) {
  if (!b.facet)
    for (const HeldContact& h : search.held.list)
      if (is_of_pair(h, a_, b_)) {
        of_b_.add(feature_of(h.against));
        add(h);
      }
  for (const HeldOnGround& h : b.held_on_ground) {
    if (contactor_of(h.feature) != a.index) continue;
    const bool in_plane = is_in_plane(h, *b.facet, search.size);
    bool of_facet = in_plane;
    for (int j = 0; j < pieces_of(b.shape); ++j)
      if (in_plane || h.contains(b.facet->vertex[j])) {
        of_b_.add_piece(j);
        of_facet = true;
      }
    if (of_facet) add(h);
    in_plane_ = in_plane_ || in_plane;
  }
}

void HeldPair::add(const HeldContact& contact) {
  of_a_.add(feature_of(contact.feature));
  opened_ = opened_ || contact.opened;
  yields_ = yields_ || contact.yields;
  any_ = true;
}

bool HeldPair::has(const Face& face) const {
  if (face.of_b && b_.facet) return in_plane_;
  const FeatureId feature = feature_id(face.of_b ? b_.index : a_.index, FeatureKind::face, face.index);
  if (b_.facet)
    return std::any_of(b_.held_on_ground.begin(), b_.held_on_ground.end(),
                       [&](const HeldOnGround& h) { return h.feature == feature; });
  return std::any_of(search_.held.list.begin(), search_.held.list.end(), [&](const HeldContact& h) {
    return is_of_pair(h, a_, b_) && (face.of_b ? h.against : h.feature) == feature;
  });
}

Hold HeldPair::hold(const Vec3& direction, const Face& of, const Vec3& nearest, bool touches) const {
  const bool is_of_face = of.index >= 0;
  if (!any_ || (is_of_face && !has(of))) return Hold::no;
  const bool in_plane_of_b = b_.facet && of.of_b && of.index == 0;
  const bool is_along = (touches || in_plane_) && direction.dot(nearest) > same_direction;
  if (!in_plane_of_b && !is_along) return Hold::no;
  return is_of_face ? Hold::exactly : Hold::for_now;
}

Counts HeldPair::counts(double t) const {
  return HeldContacts{{}, search_.held.are_solved && !opened_}.counts(Hold::exactly, t);
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
