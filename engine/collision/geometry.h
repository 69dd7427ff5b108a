#pragma once
// The geometric types of a dimension.

#include "collision/ground/terrain_2d.h"
#include "collision/ground/terrain_3d.h"
#include "collision/motion.h"
#include "collision/placed.h"
#include "collision/touch_search.h"

namespace flyrock {

template <int D>
struct Geometry;

template <>
struct Geometry<2> {
  using Terrain = Terrain2;
  using Motion = Motion2;
  using Box = Box2;
  using Pose = Pose2;
  using Contactor = Contactor2;
  using Ground = Ground2;
};

template <>
struct Geometry<3> {
  using Terrain = Terrain3;
  using Motion = Motion3;
  using Box = Box3;
  using Pose = Pose3;
  using Contactor = Contactor3;
  using Ground = Ground3;
};

}  // namespace flyrock
