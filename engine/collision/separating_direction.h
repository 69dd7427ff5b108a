#pragma once
// A direction that separates two moving contactors for a time.

#include "collision/advance3.h"
#include "collision/closest.h"
#include "collision/separating_axis.h"

namespace flyrock {

/// A normal that turns with a contactor (of_a, of_b), or the cross product of two edges.
struct SeparatingDirection {
  enum class Kind { of_a, of_b, edges } kind = Kind::of_a;
  Vec3 local = Vec3::UnitZ();  ///< of_a, of_b: in that body's frame, outward
  double support = 0;          ///< of_a, of_b: how far the contactor reaches along it from the body's origin
  FeatureId feature = 0;       ///< of_a, of_b: the feature to which the normal belongs
  int edge_a = 0, edge_b = 0;  ///< edges
  double sign = 1;             ///< edges: of the product that points from b to a
};

/// The normal of a face.
SeparatingDirection face_direction(const MovingContactor& c, SeparatingDirection::Kind kind, int face);

/// A direction in the world that is normal to a feature of the contactor, and turns with it.
SeparatingDirection attached_direction(const MovingContactor& c, const MovingState& state,
                                       SeparatingDirection::Kind kind, const Vec3& outward,
                                       const ShapeFeature& feature);

/// The cross product of an edge of a and an edge of b.
SeparatingDirection across_edges(const EdgeAxis& axis, const Placed3& a, const Placed3& b);

}  // namespace flyrock
