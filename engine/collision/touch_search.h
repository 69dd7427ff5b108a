#pragma once
// What a search for a time of impact knows: the moving contactors, and the contacts that hold them.

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "collision/contact.h"
#include "collision/motion.h"
#include "geometry/contactor.h"
#include "geometry/contactor3.h"

namespace flyrock {

/// A contact that exists when the search begins, by its feature ids.
struct HeldContact {
  FeatureId feature = 0;
  FeatureId against = 0;
  bool opened = false;  ///< in a step: the last impact opened it, and the step holds no contact of the pair
  bool yields = false;  ///< a spring: its bodies sink into each other
  Vec3 normal = Vec3::Zero();  ///< in 3D, from the antagonist; zero where it is not known
};

/// What is known at the start of a search. In free flight, the held contacts are those that have just opened.
/// They may close again, and their gap counts from 0. In a contact step, the solver handles the held contacts
/// and the search skips them (`held_are_solved`). `slack` [m] is then the penetration below which a touch
/// does not count as new.
struct TouchSearch {
  std::span<const HeldContact> held;
  bool held_are_solved = false;
  double slack = 0;
  double size = 1;  ///< m, of the body; the time of impact is exact up to a gap of 1e-12 of it
  std::uint64_t* iterations = nullptr;

  bool holds(FeatureId feature, FeatureId against) const {
    for (const HeldContact& h : held)
      if (h.feature == feature && h.against == against) return true;
    return false;
  }
  /// The gap at the start for a distance polynomial [m]. A contact that has just opened counts from 0,
  /// because a bounce on the same point must then take 2 v / g to the last bit.
  double start_gap(double gap, bool just_opened) const;
};

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
  return rounding * search.size + (search.held_are_solved ? 0.5 * motion.a.norm() * t * t : 0);
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

/// A contact with the ground that exists when the search begins, with the vertices of the ground's feature.
struct HeldOnGround {
  FeatureId feature = 0;  ///< of the body
  FeatureId against = 0;
  bool opened = false, yields = false;  ///< as HeldContact
  std::array<std::uint64_t, 3> vertex{};
  int vertices = 0;
  Vec3 normal = Vec3::UnitZ();  ///< of a facet
  Vec3 place = Vec3::Zero();    ///< a corner of the facet, the start of the edge, or the peak
  Vec3 along = Vec3::Zero();    ///< of an edge [m]

  bool contains(std::uint64_t of_ground) const {
    return std::find(vertex.begin(), vertex.begin() + vertices, of_ground) != vertex.begin() + vertices;
  }
};

template <>
struct Moving<3> {
  const Contactor3& shape;
  const Motion3& motion;
  int index = 0;
  const Facet* facet = nullptr;          ///< for a facet of the ground at rest, as a flat polyhedron
  std::span<const HeldOnGround> held{};  ///< for a facet: the contacts of the other contactor with the ground

  /// The id of a feature. A facet has its own; its back has none.
  FeatureId id(FeatureKind kind, int i) const;
};

}  // namespace flyrock
