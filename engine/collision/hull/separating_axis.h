#pragma once
// The axis of greatest separation of two convex polyhedra.

#include <limits>

#include "collision/placed.h"

namespace flyrock {

/// The axis along which two polyhedra are furthest apart, or penetrate least if they penetrate along all
/// axes.
struct FaceAxis {
  int face = 0;
  double separation = 0;  ///< m, distance of the other polyhedron's nearest vertex from the plane of the face
};
struct EdgeAxis {
  int of_a = -1, of_b = -1;     ///< -1: no two edges of the pair form a face of the Minkowski difference
  Vec3 normal = Vec3::UnitZ();  ///< unit, from a to b
  double separation = 0;
};

/// The best axis among the outward face normals of `reference`.
FaceAxis best_face_axis(const Placed3& reference, const Placed3& other);

/// The best axis among the cross products of an edge of a with an edge of b. Only edge pairs that form a face
/// of the Minkowski difference count. On the Gauss sphere, the arc of an edge joins the normals of its two
/// faces; the pair forms such a face if its two arcs cross. Source: Gregorius, The separating axis test
/// between convex polyhedra, GDC 2013.
///
/// Only axes with a separation above `least` [m] are needed; others may be passed over. With balls of radii
/// r_a, r_b inside the polyhedra and d from one centre to the other, no axis n separates by more than
/// n . d - r_a - r_b, so that arcs far from d drop out: of two lumps with 54 edges each, nine of ten.
EdgeAxis best_edge_axis(const Placed3& a, const Placed3& b,
                        double least = -std::numeric_limits<double>::infinity());

}  // namespace flyrock
