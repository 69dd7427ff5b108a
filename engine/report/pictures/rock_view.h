#pragma once
// How pictures show rocks and ground without a third dimension: directions, faces, light.

#include <string>
#include <vector>

#include "record/scenery.h"

namespace flyrock {

/// The directions of a picture: right, up, and towards the eye. In 3D the eye is in front, on the right and
/// above; there is no perspective.
struct PictureView {
  Vec3 right = Vec3::UnitX(), up = Vec3::UnitY(), near = Vec3::UnitZ();

  Vec2 operator()(const Vec3& place) const { return {right.dot(place), up.dot(place)}; }
};
PictureView view_of(int dimension);

/// One face, or a ball, in the picture.
struct Piece {
  std::vector<Vec2> outline;  ///< m; right and up
  double radius = 0;          ///< m, by which the outline is grown
  double part_depth = 0;      ///< of its contactor, m towards the eye
  double light = 0;           ///< from 0 to 1
};

/// What can be seen, the farthest contactor first. The faces of a convex contactor that look towards the eye
/// do not hide each other.
std::vector<Piece> pieces_of(const std::vector<SurfaceCorner>& corners, const PictureView& view);

/// Twice the area of a face times its normal; 0 for a ball.
Vec3 area_of(const std::vector<Vec3>& places);

/// How light a face is, from its area_of: the more it looks up, the lighter.
double light_of(const Vec3& area);

/// The colour of stone; `light` from 0 to 1.
std::string colour_of(double light);

}  // namespace flyrock
