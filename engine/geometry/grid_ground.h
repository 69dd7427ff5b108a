#pragma once
// The ground as a grid of heights: facets by index arithmetic, without storing triangles.

#include "geometry/ground.h"

namespace flyrock {

/// The cell (c, r) lies between the four centres (c, r) to (c + 1, r + 1). Its facets are 2 k (south-east of
/// the diagonal) and 2 k + 1 (north-west), k = r (columns - 1) + c; the vertex (c, r) has the index r columns
/// + c. A facet has the part of its corner with the right angle. Blocks of 8 x 8 cells, and of 8 x 8 blocks,
/// keep their least and greatest heights, so that a query over empty air ends early.
///
/// Bodies that hang over the border of the grid need ground there: the outermost cells are an apron, which
/// continues the ground level for `apron` m. For points and places in plan the ground ends at its extent.
class GridGround final : public Ground3 {
 public:
  static constexpr double apron = 100;  ///< m, more than any body reaches

  explicit GridGround(HeightGrid grid);

  void facets(const Box3& box, std::vector<Facet>& out) const override;
  void triangles(const Box3& box, std::vector<Facet>& out) const override;
  int count(const Box3& box, int limit) const override;
  void triangles_under(const Vec2& a, const Vec2& b, std::vector<Facet>& out) const override;
  Facet facet(std::uint32_t id) const override;
  Vec3 vertex(std::uint64_t index) const override;
  bool peak(std::uint64_t vertex, std::vector<Vec3>& edges) const override;
  std::uint32_t facet_at(std::uint64_t vertex) const override;
  int part(std::uint32_t facet) const override;
  const Box3& extent() const override { return extent_; }

 private:
  struct Level {
    int columns, rows;
    std::vector<float> low, high;  ///< rounded outwards; low > high where there is no ground
  };
  /// Cells first to last in x and y, both included; empty if last < first.
  struct Range {
    std::array<int, 2> first, last;
  };

  enum class Cells { own, with_apron };
  Range cells_of(const Vec2& low, const Vec2& high, Cells which) const;
  double coordinate(int axis, int index) const;
  Vec3 place(int column, int row) const;
  bool has_ground(int column, int row) const;  ///< of a cell
  Facet triangle(std::uint32_t id) const;
  /// Calls see(id) for the facets whose boxes meet `box`, in the order of their ids.
  template <class See>
  void visit_in_order(const Box3& box, Cells which, const See& see) const;
  void build_levels();
  /// Calls see(id) for the facets whose boxes meet `box`; stops when it returns false.
  template <class See>
  bool visit(const Box3& box, const Range& range, std::size_t level, int column, int row,
             const See& see) const;
  template <class See>
  void visit_all(const Box3& box, Cells which, const See& see) const;

  HeightGrid grid_;  ///< with the apron; its corner is that of the own cells
  Box3 extent_;
  double noise_ = 0;
  std::vector<Level> levels_;  ///< of 8 x 8 cells first, one block last
};

}  // namespace flyrock
