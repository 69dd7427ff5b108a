#pragma once
// The ground as a mesh: triangles in a tree of boxes, with tables of their neighbours.

#include "geometry/ground.h"

namespace flyrock {

/// The tree is one flat array in depth-first order. Each node knows where its subtree ends, so that a query
/// walks through the array once and needs no stack. It is split at the median of the centres along the
/// longest side and does not depend on anything but the mesh.
class MeshGround final : public Ground3 {
 public:
  explicit MeshGround(Mesh mesh);

  void facets(const Box3& box, std::vector<Facet>& out) const override;
  void triangles(const Box3& box, std::vector<Facet>& out) const override;
  int count(const Box3& box, int limit) const override;
  void triangles_under(const Vec2& a, const Vec2& b, std::vector<Facet>& out) const override;
  Facet facet(std::uint32_t id) const override;
  Vec3 vertex(std::uint64_t index) const override { return mesh_.vertices[index]; }
  bool peak(std::uint64_t vertex, std::vector<Vec3>& edges) const override;
  std::uint32_t facet_at(std::uint64_t vertex) const override;
  int part(std::uint32_t facet) const override { return mesh_.part[facet]; }
  const Box3& extent() const override { return extent_; }

 private:
  Facet triangle(std::uint32_t id) const;
  struct Node {
    Box3 box;
    std::uint32_t end = 0;               ///< index of the first node after this subtree
    std::uint32_t first = 0, count = 0;  ///< of a leaf: its range in order_
  };
  struct Neighbours {
    std::array<std::uint32_t, 3> facet{};
    std::array<std::uint64_t, 3> edge{};
    std::array<Rim, 3> rim{};
  };

  void measure();
  void find_neighbours();
  void find_peaks();
  void split(std::uint32_t first, std::uint32_t count);
  Box3 box_of(std::uint32_t triangle) const;
  /// Collects the triangles whose boxes satisfy `meets`, in the order of their ids, at most `limit`.
  template <class Meets>
  const std::vector<std::uint32_t>& collect(const Meets& meets, std::size_t limit) const;

  Mesh mesh_;
  Box3 extent_;
  std::vector<Vec3> normal_;
  std::vector<Neighbours> around_;
  std::vector<std::uint32_t> fan_start_, fan_;  ///< facets of each vertex; empty unless it is a peak
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;  ///< triangles, leaf after leaf
  std::vector<Box3> boxes_;           ///< theirs, in the same order
};

}  // namespace flyrock
