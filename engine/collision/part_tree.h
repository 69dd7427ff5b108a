#pragma once
// Which parts of a body may be near to another body or to the ground: a tree of balls about the parts.

#include <utility>
#include <vector>

#include "collision/geometry.h"
#include "collision/workspace.h"

namespace flyrock {

/// A binary tree of balls, in the body's frame. A leaf contains one contactor, and each other ball the two
/// below it.
template <int D>
class PartTree {
 public:
  struct Ball {
    Vec<D> centre = Vec<D>::Zero();
    double radius = 0;  ///< m
  };
  struct Node {
    Ball ball;
    int part = -1;   ///< of a leaf: the index of its contactor
    int second = 0;  ///< the other child; the first child is the next node
    bool is_leaf() const { return part >= 0; }
  };

  PartTree() = default;
  explicit PartTree(const std::vector<typename Geometry<D>::Contactor>& parts);

  int parts() const { return static_cast<int>(nodes_.size() + 1) / 2; }
  const Node& operator[](int i) const { return nodes_[static_cast<std::size_t>(i)]; }

 private:
  std::vector<Node> nodes_;  ///< the root is the first
};

/// Replaces `found` by the parts of a body that may have a gap of at most `reach` [m] to the ground, in
/// order. Up to `few_parts` these are all parts: trying them costs less than the tree.
template <int D>
void near_parts(Workspace& work, const PartTree<D>& body, const typename Geometry<D>::Pose& pose,
                const typename Geometry<D>::Terrain& ground, double reach, std::vector<int>& found);

/// The same for the pairs of parts of two bodies, in order of the first part and then of the second.
template <int D>
void near_parts(Workspace& work, const PartTree<D>& a, const typename Geometry<D>::Pose& pose_a,
                const PartTree<D>& b, const typename Geometry<D>::Pose& pose_b, double reach,
                std::vector<std::pair<int, int>>& found);

inline constexpr int few_parts = 16;

}  // namespace flyrock
