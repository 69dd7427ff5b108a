#pragma once
// The terrain of a trial, for pictures and exports.

#include <memory>
#include <string>
#include <vector>

#include "collision/ground/terrain_3d.h"
#include "geometry/profile.h"

namespace flyrock {

/// A profile in 2D, a ground in 3D; neither if it could not be built.
struct TerrainPicture {
  std::vector<std::string> parts;
  Profile profile;                         ///< 2D: has points
  std::shared_ptr<const Terrain3> ground;  ///< 3D: points of a sweep with equal terrain share it
  Vec3 origin = Vec3::Zero();              ///< 3D: the place from which the ground counts [m]
};

}  // namespace flyrock
