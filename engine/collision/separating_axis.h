#pragma once
// The axis of greatest separation of two convex polyhedra.

#include "collision/placed.h"

namespace flyrock {

/// An axis along which two polyhedra are furthest apart, or overlap least where all overlap.
struct FaceAxis {
  int face = 0;
  double separation = 0;  ///< m, of the other's nearest vertex from the plane of the face
};
struct EdgeAxis {
  int of_a = -1, of_b = -1;     ///< -1: no two edges of the pair meet
  Vec3 normal = Vec3::UnitZ();  ///< unit, from a to b
  double separation = 0;
};

/// Among the outward normals of the faces of `reference`.
FaceAxis best_face_axis(const Placed3& reference, const Placed3& other);

/// Among the products of an edge of a with an edge of b that make a face of the Minkowski difference: whose
/// arcs on the Gauss sphere, between the normals of an edge's two faces, cross (Gregorius, The separating
/// axis test between convex polyhedra, GDC 2013).
EdgeAxis best_edge_axis(const Placed3& a, const Placed3& b);

}  // namespace flyrock
