#pragma once
// A convex region cut into convex blocks by planes (lines in 2D), one after the other.

#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

#include "geometry/contactor3.h"

namespace flyrock {

/// A face of a block. Seen from outside its points follow each other counter-clockwise; in 2D it is an edge
/// with two points, which go counter-clockwise around the block.
template <int D>
struct BlockFace {
  /// The plane that made the face, as `cut` was told; -1 - i: face i of the region.
  int joint = -1;
  Vec<D> normal = Vec<D>::Zero();  ///< unit, out of the block; that of its plane
  std::vector<int> loop;           ///< indices into the points of all blocks
};

template <int D>
struct Block {
  std::vector<BlockFace<D>> faces;
};

/// The blocks of a region. The points of all blocks are in one list, and each is stored once: a new point is
/// found by the two points of the edge that is cut, so that all blocks at this edge share it. The face
/// between two blocks is then one loop of points, which the two pass in opposite directions. A joint that
/// ends inside the region leaves points in the middle of edges of blocks that it does not cut.
///
/// A point closer to a plane than 1e-9 of the region lies on it, and a block is cut only if it has points on
/// both sides. So a plane through a vertex, an edge or a face makes no block without a volume.
template <int D>
class CutBlocks {
 public:
  /// The place where a plane cuts a block: in 3D the corners of a convex polygon, counter-clockwise seen
  /// against the normal of the plane; in 2D the two ends of a segment.
  using Section = std::vector<Vec<D>>;

  /// The corners of a convex region and its faces.
  CutBlocks(std::vector<Vec<D>> points, std::vector<BlockFace<D>> faces);

  /// Cuts the blocks that the plane { x: normal.x = offset } passes through (`normal` of length 1), or of
  /// these only those for which `wanted` is true. Returns how many were cut.
  int cut(const Vec<D>& normal, double offset, int joint,
          const std::function<bool(const Section&)>& wanted = {});

  const std::vector<Vec<D>>& points() const { return points_; }
  const std::vector<Block<D>>& blocks() const { return blocks_; }
  double size() const { return size_; }  ///< diagonal of the box about the region [m]

 private:
  bool is_crossed(const Block<D>& block) const;
  bool split(std::size_t block, const Vec<D>& normal, int joint,
             const std::function<bool(const Section&)>& wanted);
  int crossing(int a, int b);
  void forget_points_from(std::size_t first);

  std::vector<Vec<D>> points_;
  std::vector<Block<D>> blocks_;
  double size_ = 0;
  // For the present plane:
  std::vector<double> height_;                        ///< of each point above it
  std::vector<signed char> side_;                     ///< 1 above, 0 on it, -1 below
  std::unordered_map<std::uint64_t, int> crossings_;  ///< by the two points of an edge
  std::vector<std::uint64_t> crossed_edges_;  ///< the keys of `crossings_`, in the order of the points
};

/// The region of a convex polygon, counter-clockwise.
CutBlocks<2> blocks_of(const std::vector<Vec2>& polygon);
/// The region of a convex polyhedron (a contactor with faces).
CutBlocks<3> blocks_of(const Contactor3& polyhedron);

/// Measures of a block or a face [m, m2, m3; in 2D a volume is an area, and an area a length].
template <int D>
double volume_of(const std::vector<Vec<D>>& points, const Block<D>& block);
template <int D>
Vec<D> centroid_of(const std::vector<Vec<D>>& points, const Block<D>& block);
/// Area times unit normal, outwards; of a closed block these add up to 0.
template <int D>
Vec<D> area_vector_of(const std::vector<Vec<D>>& points, const BlockFace<D>& face);
template <int D>
double area_of(const std::vector<Vec<D>>& points, const BlockFace<D>& face) {
  return area_vector_of<D>(points, face).norm();
}

}  // namespace flyrock
