#pragma once
// The faces of the ground as a point meets them: segments in 2D, facets in 3D, and when a path first touches
// one.

#include <array>
#include <vector>

#include "collision/geometry.h"
#include "flight/ballistic.h"

namespace flyrock {

/// A point at most this far from a face or from its rim is on it [m].
inline constexpr double face_reach = 1e-9;

/// A flat part of the ground, which lies behind it, between rims: the ends of a segment in 2D, the sides of a
/// facet in 3D. A plane has no rims.
template <int D>
struct Face {
  int id = 0;
  int part = 0;  ///< of the terrain
  int rims = 0;
  Vec<D> normal;
  std::array<Vec<D>, D> corner;  ///< a point of each rim [m]; the first one is also a point of the face
  std::array<Vec<D>, D> inward;  ///< unit, along the face, from each rim into it

  double height(const Vec<D>& p) const { return normal.dot(p - corner[0]); }
  /// How far p is from rim i, towards the inside [m].
  double inside(int i, const Vec<D>& p) const { return inward[i].dot(p - corner[i]); }
  bool is_over(const Vec<D>& p, double reach) const {
    for (int i = 0; i < rims; ++i)
      if (inside(i, p) < -reach) return false;
    return true;
  }
};

/// The faces on which a point lies, by their ids; at most one unless it is on a rim. `near`: a segment close
/// to it in 2D (-1: not known).
void faces_at(const Terrain2& terrain, const Vec2& at, int near, std::vector<Face<2>>& faces);
void faces_at(const Terrain3& terrain, const Vec3& at, int near, std::vector<Face<3>>& faces);

/// The ground of a point that goes on after a touch. A point that starts on a face is taken to be exactly on
/// it: it touches this face again only after it has risen from it.
template <int D>
struct PointGround {
  const typename Geometry<D>::Terrain& terrain;
  int near = -1;  ///< a segment close to the start, in 2D; -1: not known
};

/// Where a flight first touches the ground, passes an end of the terrain, or comes to a place without ground.
/// In closed form on a parabola, whose acceleration is upright, in increasing order along its x in 2D.
ArcEnd end_of(const Parabola<2>& path, const PointGround<2>& ground);
ArcEnd end_of(const Parabola<3>& path, const PointGround<3>& ground);
ArcEnd end_of(const Arc<2>& arc, const PointGround<2>& ground);
ArcEnd end_of(const Arc<3>& arc, const PointGround<3>& ground);

/// Where an arc along a face passes one of its rims, as s in [0, 1]; nothing if it does not. An arc that
/// starts on a rim must not leave through it.
template <int D>
std::optional<double> end_on(const Arc<D>& arc, const Face<D>& face);

}  // namespace flyrock
