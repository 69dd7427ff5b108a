#pragma once
// What a population knows of a rock that joints have cut, for the table `blocks`.

#include <memory>
#include <string>
#include <vector>

#include "math/space.h"

namespace flyrock {

/// Which blocks move. The others are fixed, and rows of no table but `blocks`.
enum class MovingBlocks { all, removable, factor_below_1 };

/// The rock of one trial that joints have cut. In 2D volumes are m3 and areas m2 per metre of width.
struct JointedRegion {
  double volume = 0;                ///< m3
  double joint_area = 0;            ///< m2, of the joints between blocks
  double joint_count = 0;           ///< Jv: the sum over the sets of 1 / mean spacing [1/m]
  int planes = 0;                   ///< joints that cut a block
  int left_out = 0;                 ///< blocks smaller than `least_volume`
  double left_out_volume = 0;       ///< m3
  std::vector<std::string> joints;  ///< the name of each joint: that of its set, or of its line in a file
};

/// One block, for its motion without rotation under its weight and more loads.
template <int D>
struct BlockPlan {
  static constexpr int free = -1, ground = -2;
  struct Face {
    int joint = free;                ///< index into JointedRegion::joints, or free, or ground
    Vec<D> normal = Vec<D>::Zero();  ///< unit, out of the block
    double area = 0;                 ///< m2; in 2D m2 per metre of width
  };
  std::vector<Face> faces;
  double volume = 0;             ///< m3; in 2D m3 per metre of width
  Vec<D> push = Vec<D>::Zero();  ///< a force as a share of the weight
  Vec<D> pull = Vec<D>::Zero();  ///< N, of its bolts; in 2D N per metre of width
  double pressure = 0;           ///< Pa, mean, of the water on each face that is not free
  MovingBlocks moving = MovingBlocks::all;
  std::shared_ptr<const JointedRegion> region;
};

}  // namespace flyrock
