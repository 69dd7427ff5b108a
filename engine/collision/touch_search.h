#pragma once
// What a search for a time of impact knows: the moving contactors, and the contacts that hold them.

#include <algorithm>
#include <cmath>

#include "collision/contact.h"
#include "collision/held.h"
#include "collision/motion.h"
#include "geometry/contactor.h"
#include "geometry/contactor3.h"

namespace flyrock {

/// What is known at the start of a search.
struct TouchSearch {
  HeldContacts held;
  double slack = 0;  ///< m, in a step: a penetration below it is no new touch
  double size =
      1;  ///< m, of the smaller body that moves; the time of impact is exact up to a gap of 1e-12 of it
  std::uint64_t* iterations = nullptr;

  /// The gap at the start for a distance polynomial [m]. A contact that has just opened counts from 0,
  /// because a bounce on the same point must then take 2 v / g to the last bit.
  double start_gap(double gap, Counts counts) const {
    constexpr double rounding = 1e-6;  // of the size
    return counts == Counts::from_zero && std::abs(gap) <= rounding * size ? 0.0 : gap + slack;
  }
};

/// What the contacts of two cores hold: the tables of pairs.cpp choose ball where one is a ball, else pill
/// where one is a pill. A ball has one contact with a convex contactor, whatever its feature; contacts of a
/// pill hold pairs of points, those of hulls features.
enum class CoreSearch { ball, pill, hull };

/// A vertex that is less deep than this share of the size touches each segment, or facet, that it lies below.
/// A deeper vertex, which only fixed time steps produce, is pushed out to the nearest place. At a concave
/// corner or rim, the strip over a segment or facet is longer by as much.
inline constexpr double shallow_share = 1e-3;

/// How deep a point may lie in the ground at time t of a motion [m], before it meets the segment or facet
/// beyond a concave corner or rim. In a step that passes the corner, the contact on this side is not found in
/// the middle of the step, and the point falls until the step is cut at the other side.
template <int D>
double point_sinks(const Path<D>& motion, double t, const TouchSearch& search) {
  constexpr double rounding = 1e-3;  // of the size
  return rounding * search.size + (search.held.are_solved ? 0.5 * motion.a.norm() * t * t : 0);
}

/// A moving contactor. Shape and motion must outlive it.
template <int D>
struct Moving;
using Moving2 = Moving<2>;
using Moving3 = Moving<3>;

template <>
struct Moving<2> {
  const Contactor2& shape;
  const Motion2& motion;
  int index = 0;  ///< of the contactor in its body, for feature ids
};

/// A contact with the ground, and where the ground's feature is. Frame of the ground, metres.
struct HeldOnGround : HeldContact {
  std::array<std::uint64_t, 3> vertex{};  ///< of the feature
  int vertices = 0;
  Vec3 upward = Vec3::UnitZ();  ///< the normal of a facet
  Vec3 place = Vec3::Zero();    ///< a corner of the facet, the start of the edge, or the peak
  Vec3 along = Vec3::Zero();    ///< of an edge

  bool contains(std::uint64_t of_ground) const {
    return std::find(vertex.begin(), vertex.begin() + vertices, of_ground) != vertex.begin() + vertices;
  }
};

template <>
struct Moving<3> {
  const Contactor3& shape;
  const Motion3& motion;
  int index = 0;
  const Facet* facet = nullptr;  ///< for a facet of the ground at rest, as a flat polyhedron or a place
  std::span<const HeldOnGround> held_on_ground{};  ///< for a facet: the contacts of the other body

  /// The id of a feature. A facet has its own; its back has none.
  FeatureId id(FeatureKind kind, int i) const;
};

}  // namespace flyrock
