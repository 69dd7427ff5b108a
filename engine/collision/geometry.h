#pragma once
// The geometric types of a dimension.

#include "collision/motion.h"
#include "collision/placed.h"
#include "collision/terrain.h"

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
};

}  // namespace flyrock
