#pragma once
// The surface of a rock, for pictures.

#include <vector>

#include "geometry/contactor.h"
#include "geometry/contactor3.h"

namespace flyrock {

/// A corner of a face of a contactor, in the body's frame: the origin is the centre of mass. In 3D a face is
/// a polygon, counter-clockwise as seen from outside; in 2D a contactor is one face. A disk or a sphere is
/// one corner, its centre, with a radius; a wall or a pill is the two ends of its axis with a radius. The
/// wall of a hollow disk or cylinder is cut into pieces, each a face; of a mesh each triangle is one. A
/// square of 1 m stands for a half space.
struct SurfaceCorner {
  int contactor = 0, face = 0;  ///< from 0; corners of a face follow each other
  Vec3 place = Vec3::Zero();    ///< m
  double radius = 0;            ///< m
};

/// The corners of all faces.
std::vector<SurfaceCorner> surface_of(const std::vector<Contactor2>& contactors);
std::vector<SurfaceCorner> surface_of(const std::vector<Contactor3>& contactors);

}  // namespace flyrock
