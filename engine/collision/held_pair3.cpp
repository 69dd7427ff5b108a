#include "collision/held_pair3.h"

#include <algorithm>
#include <cmath>

namespace flyrock {

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

bool HeldPair::over(FeatureId face, int i) const {
  constexpr double same = 1e-10;  // rad, and m per m
  if (!b_.facet || face != b_.facet->face_feature()) return false;
  const FeatureId point = a_.id(FeatureKind::vertex, i);
  return std::any_of(b_.held.begin(), b_.held.end(), [&](const HeldOnGround& h) {
    return h.feature == point && kind_of(h.against) == FeatureKind::face &&
           (h.normal - b_.facet->normal).squaredNorm() <= same * same &&
           std::abs(b_.facet->distance(h.place)) <= same * search_.size;
  });
}

bool HeldPair::along(const Vec3& direction, int i, int j, const MovingState& state_of_a) const {
  return std::any_of(b_.held.begin(), b_.held.end(), [&](const HeldOnGround& h) {
    constexpr double same = 1 - 5e-7;  // cosine of 1e-3 rad
    if (contactor_of(h.feature) != a_.index || !h.contains(b_.facet->vertex[j])) return false;
    const int feature = index_of(h.feature);
    if (kind_of(h.feature) == FeatureKind::vertex) return feature == i && direction.dot(h.normal) > same;
    if (kind_of(h.feature) == FeatureKind::face) {
      const Contactor3::Face& face = a_.shape.faces[feature];
      const auto* loop = &a_.shape.loop[face.first];
      return std::find(loop, loop + face.count, i) != loop + face.count &&
             -direction.dot(state_of_a.arm(face.normal)) > same;
    }
    const Contactor3::Edge& edge = a_.shape.edges[feature];
    if (edge.start != i && edge.end != i) return false;
    const Vec3 along = state_of_a.arm(a_.shape.points[edge.end] - a_.shape.points[edge.start]);
    for (int rim = 0; rim < 3; ++rim) {
      if (h.against != b_.facet->edge_feature(rim)) continue;
      const Vec3 normal = along.cross(b_.facet->along(rim));
      return std::abs(direction.dot(normal)) > same * normal.norm();
    }
    return false;
  });
}

bool HeldPair::touches(int face) const {
  const FeatureId feature = a_.id(FeatureKind::face, face);
  return std::any_of(b_.held.begin(), b_.held.end(),
                     [&](const HeldOnGround& h) { return h.feature == feature; });
}

}  // namespace flyrock
