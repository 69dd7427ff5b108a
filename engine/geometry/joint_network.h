#pragma once
// Joints of rock: planes and discs (in 2D lines and segments) drawn from sets, and the blocks that they cut.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/cut_blocks.h"
#include "random/distribution.h"

namespace flyrock {

/// A set of joints.
///
/// Planes: plane k lies at origin + d_k n_k along its own normal n_k, and the differences of the d_k are
/// independent draws of `spacing`. The area of joint a volume is 1/E(spacing), with scatter too. Without an
/// origin the d_k are stationary about the region.
///
/// Discs (with `radius`): their centres are a Poisson process with so many a volume that their area a volume
/// is 1/E(spacing).
template <int D>
struct JointSet {
  std::string name;
  Vec<D> normal = Vec<D>::Unit(D - 1);  ///< mean, unit
  double fisher_k = 0;                  ///< concentration of the normals about it; 0: no scatter
  std::shared_ptr<const Distribution> spacing;
  double persistence = 1;  ///< probability with which a plane cuts a block that it meets
  std::shared_ptr<const Distribution> radius = nullptr;
  std::optional<Vec<D>> origin = std::nullopt;
};

/// One joint.
template <int D>
struct Joint {
  int set = 0;
  Vec<D> normal = Vec<D>::Unit(D - 1);
  double offset = 0;  ///< normal . x
  double persistence = 1;
  double radius = infinite;        ///< of a disc
  Vec<D> centre = Vec<D>::Zero();  ///< of a disc
};

/// The joints of a set that may meet a region with these corners: planes in the order of d, discs in falling
/// order of their radius. Throws std::length_error if they are more than `most_places` (random/spacings.h).
template <int D>
std::vector<Joint<D>> draw_joints(const JointSet<D>& set, int index, const std::vector<Vec<D>>& corners,
                                  RandomStream& rng);

/// Cuts the blocks by a joint with the number `index`; returns how many. A plane cuts each block that it
/// meets with the probability `persistence`. A disc cuts a block if its centre lies in the block, or if it
/// covers more than half of the section: a joint runs on to the next joint, and one that ends inside a block
/// is left out.
template <int D>
int cut_by(CutBlocks<D>& blocks, const Joint<D>& joint, int index, RandomStream& rng);

}  // namespace flyrock
