#pragma once
// What a block between planes without tension can do under a load: fall, slide on one plane or on two, or
// nothing.

#include <vector>

#include "math/space.h"

namespace flyrock {

/// A block that rests against planes with the unit normals n_i, out of the planes into the block, can be
/// displaced without rotation along s if n_i . s >= 0 for all i: these s are the cone of motions. Of the load
/// L, the projection on this cone drives the block, and the rest is carried by the planes (Moreau):
///   L = drive - sum_i pressing_i n_i,  pressing_i >= 0,  drive . n_i >= 0,  pressing_i drive . n_i = 0.
/// With drive = 0 the block cannot move along its load, at any friction. Otherwise the planes that press are
/// none (it falls), one (it slides on a plane) or two (it slides along their line, a wedge), because the
/// drive is at right angles to all of them.
template <int D>
struct BlockMotion {
  bool removable = false;           ///< the cone has any motion
  Vec<D> drive = Vec<D>::Zero();    ///< N; 0 where it is below 1e-9 of the load
  std::vector<double> pressing;     ///< N, of each plane
  std::vector<int> active() const;  ///< the planes that press
};

/// Solved by nonnegative least squares: min |sum_i pressing_i n_i + L|.
template <int D>
BlockMotion<D> block_motion(const std::vector<Vec<D>>& normals, const Vec<D>& load);

}  // namespace flyrock
