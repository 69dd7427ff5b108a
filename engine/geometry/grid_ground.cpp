#include "geometry/grid_ground.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flyrock {

namespace {

constexpr int block = 8;  // cells, or blocks of the level below, along each side

/// Columns and rows of the six neighbours of a vertex, counter-clockwise. Two successive ones and the vertex
/// form a facet.
constexpr std::array<std::array<int, 2>, 6> neighbours_around{
    {{1, 0}, {1, 1}, {0, 1}, {-1, 0}, {-1, -1}, {0, -1}}};

/// The values of the cells, with those at the border repeated once outside.
template <class Value>
void repeat_border(std::vector<Value>& values, int columns, int rows) {
  const std::size_t wide = static_cast<std::size_t>(columns) + 2;
  values.resize(wide * (static_cast<std::size_t>(rows) + 2));
  // From the last row on, so that none is overwritten before it has moved.
  for (int r = rows - 1; r >= 0; --r) {
    const auto from = values.begin() + static_cast<std::ptrdiff_t>(r) * columns;
    const auto to = values.begin() + static_cast<std::ptrdiff_t>((r + 1) * wide);
    std::move_backward(from, from + columns, to + columns + 1);
    to[0] = to[1];
    to[columns + 1] = to[columns];
  }
  const auto row = static_cast<std::ptrdiff_t>(wide);
  std::copy_n(values.begin() + row, row, values.begin());
  std::copy_n(values.end() - 2 * row, row, values.end() - row);
}

HeightGrid with_apron(HeightGrid grid) {
  repeat_border(grid.heights, grid.columns, grid.rows);
  if (!grid.part.empty()) repeat_border(grid.part, grid.columns, grid.rows);
  grid.columns += 2;
  grid.rows += 2;
  return grid;
}

}  // namespace

GridGround::GridGround(HeightGrid grid) : Ground3(grid.parts), grid_(with_apron(std::move(grid))) {
  build_levels();
  cell_ = grid_.cell;
  const Vec2 size = grid_.cell * Vec2(grid_.columns - 3, grid_.rows - 3);
  const Level& all = levels_.back();
  extent_.low << grid_.corner, all.low[0];
  extent_.high << grid_.corner + size, all.high[0];
  whole_ = std::none_of(grid_.heights.begin(), grid_.heights.end(), [](double z) { return std::isnan(z); });
  noise_ = 8e-16 * std::max(extent_.low.cwiseAbs().maxCoeff(), extent_.high.cwiseAbs().maxCoeff());
}

/// Where the centres of a column (axis 0) or row (axis 1) are [m].
double GridGround::coordinate(int axis, int index) const {
  const int last = axis == 0 ? grid_.columns - 1 : grid_.rows - 1;
  if (index == 0) return grid_.corner[axis] - apron;
  if (index == last) return grid_.corner[axis] + grid_.cell * (last - 2) + apron;
  return grid_.corner[axis] + grid_.cell * (index - 1);
}

Vec3 GridGround::place(int column, int row) const {
  return {coordinate(0, column), coordinate(1, row), grid_.at(column, row)};
}

Vec3 GridGround::vertex(std::uint64_t index) const {
  const auto columns = static_cast<std::uint64_t>(grid_.columns);
  return place(static_cast<int>(index % columns), static_cast<int>(index / columns));
}

/// A cell of the apron has ground if the own cell beside it has.
bool GridGround::has_ground(int column, int row) const {
  if (column < 0 || row < 0 || column + 1 >= grid_.columns || row + 1 >= grid_.rows) return false;
  column = std::clamp(column, 1, grid_.columns - 3);
  row = std::clamp(row, 1, grid_.rows - 3);
  return !std::isnan(grid_.at(column, row)) && !std::isnan(grid_.at(column + 1, row)) &&
         !std::isnan(grid_.at(column, row + 1)) && !std::isnan(grid_.at(column + 1, row + 1));
}

void GridGround::build_levels() {
  constexpr float most = std::numeric_limits<float>::max();
  const auto blocks = [](int n) { return (n + block - 1) / block; };
  const auto add_level = [&](int columns, int rows, const auto& range_at) {
    Level level{blocks(columns), blocks(rows), {}, {}};
    level.low.assign(static_cast<std::size_t>(level.columns) * level.rows, most);
    level.high.assign(level.low.size(), -most);
    for (int r = 0; r < rows; ++r)
      for (int c = 0; c < columns; ++c) {
        const std::size_t k = static_cast<std::size_t>(r / block) * level.columns + c / block;
        const auto [low, high] = range_at(c, r);
        level.low[k] = std::min(level.low[k], low);
        level.high[k] = std::max(level.high[k], high);
      }
    levels_.push_back(std::move(level));
  };
  add_level(grid_.columns - 1, grid_.rows - 1, [&](int c, int r) {
    if (!has_ground(c, r)) return std::pair(most, -most);
    const auto [low, high] =
        std::minmax({grid_.at(c, r), grid_.at(c + 1, r), grid_.at(c, r + 1), grid_.at(c + 1, r + 1)});
    return std::pair(std::nextafter(static_cast<float>(low), -most),
                     std::nextafter(static_cast<float>(high), most));
  });
  while (levels_.back().low.size() > 1) {
    const Level below = levels_.back();
    add_level(below.columns, below.rows, [&](int c, int r) {
      const std::size_t k = static_cast<std::size_t>(r) * below.columns + c;
      return std::pair(below.low[k], below.high[k]);
    });
  }
}

GridGround::Range GridGround::cells_of(const Vec2& low, const Vec2& high, Cells which) const {
  Range range;
  const std::array<int, 2> cells{grid_.columns - 1, grid_.rows - 1};
  const int border = which == Cells::own ? 1 : 0;
  for (int k = 0; k < 2; ++k) {
    // A box that ends on the line between two cells meets both.
    const double from = (low[k] - grid_.corner[k]) / grid_.cell - 1e-9,
                 to = (high[k] - grid_.corner[k]) / grid_.cell + 1e-9;
    const double first = border, last = cells[k] - 1 - border;
    range.first[k] = static_cast<int>(std::clamp(1 + std::floor(from), first, last + border));
    range.last[k] = static_cast<int>(std::clamp(1 + std::floor(to), first - border, last));
  }
  return range;
}

template <class See>
bool GridGround::visit(const Box3& box, const Range& range, std::size_t level, int column, int row,
                       const See& see) const {
  const Level& here = levels_[level];
  const std::size_t k = static_cast<std::size_t>(row) * here.columns + column;
  if (here.low[k] > box.high.z() || here.high[k] < box.low.z()) return true;
  const std::array<int, 2> at{column, row};
  std::array<int, 2> first, last;  // of the blocks or cells inside this block that are in the range
  int scale = 1;
  for (std::size_t l = 0; l < level; ++l) scale *= block;
  const std::array<int, 2> size{level == 0 ? grid_.columns - 1 : levels_[level - 1].columns,
                                level == 0 ? grid_.rows - 1 : levels_[level - 1].rows};
  for (int i = 0; i < 2; ++i) {
    first[i] = std::max(at[i] * block, range.first[i] / scale);
    last[i] = std::min({at[i] * block + block - 1, range.last[i] / scale, size[i] - 1});
  }
  for (int r = first[1]; r <= last[1]; ++r)
    for (int c = first[0]; c <= last[0]; ++c) {
      if (level > 0) {
        if (!visit(box, range, level - 1, c, r, see)) return false;
        continue;
      }
      if (!has_ground(c, r)) continue;
      const double sw = grid_.at(c, r), se = grid_.at(c + 1, r), nw = grid_.at(c, r + 1),
                   ne = grid_.at(c + 1, r + 1);
      const auto id = 2 * (static_cast<std::uint32_t>(r) * static_cast<std::uint32_t>(grid_.columns - 1) +
                           static_cast<std::uint32_t>(c));
      const auto meets = [&](double a, double b, double d) {
        const auto [low, high] = std::minmax({a, b, d});
        return low <= box.high.z() && high >= box.low.z();
      };
      if (meets(sw, se, ne) && !see(id)) return false;
      if (meets(sw, ne, nw) && !see(id + 1)) return false;
    }
  return true;
}

template <class See>
void GridGround::visit_all(const Box3& box, Cells which, const See& see) const {
  const Range range = cells_of(box.low.head<2>(), box.high.head<2>(), which);
  if (range.last[0] < range.first[0] || range.last[1] < range.first[1]) return;
  visit(box, range, levels_.size() - 1, 0, 0, see);
}

template <class See>
void GridGround::visit_in_order(const Box3& box, Cells which, const See& see) const {
  thread_local std::vector<std::uint32_t> found;  // keeps its memory between queries
  found.clear();
  visit_all(box, which, [&](std::uint32_t id) {
    found.push_back(id);
    return true;
  });
  std::sort(found.begin(), found.end());
  for (const std::uint32_t id : found) see(id);
}

void GridGround::facets(const Box3& box, std::vector<Facet>& out) const {
  visit_in_order(box, Cells::with_apron, [&](std::uint32_t id) { out.push_back(facet(id)); });
}

void GridGround::triangles(const Box3& box, std::vector<Facet>& out) const {
  visit_in_order(box, Cells::own, [&](std::uint32_t id) { out.push_back(triangle(id)); });
}

int GridGround::count(const Box3& box, int limit) const {
  int found = 0;
  visit_all(box, Cells::with_apron, [&](std::uint32_t) { return ++found < limit; });
  return found;
}

/// Row by row: the cells between the places where the segment enters and leaves the row.
void GridGround::triangles_under(const Vec2& a, const Vec2& b, std::vector<Facet>& out) const {
  const Range range = cells_of(a.cwiseMin(b), a.cwiseMax(b), Cells::own);
  const Vec2 along = b - a;
  for (int row = range.first[1]; row <= range.last[1]; ++row) {
    double from = 0, to = 1;
    if (along.y() != 0) {
      const double slack = 1e-9 * grid_.cell;
      const double south = (coordinate(1, row) - slack - a.y()) / along.y(),
                   north = (coordinate(1, row + 1) + slack - a.y()) / along.y();
      from = std::max(from, std::min(south, north));
      to = std::min(to, std::max(south, north));
    }
    const Vec2 enters = a + from * along, leaves = a + to * along;
    const Range here = cells_of(enters.cwiseMin(leaves), enters.cwiseMax(leaves), Cells::own);
    for (int column = here.first[0]; column <= here.last[0]; ++column) {
      if (!has_ground(column, row)) continue;
      const auto id = 2 * (static_cast<std::uint32_t>(row) * static_cast<std::uint32_t>(grid_.columns - 1) +
                           static_cast<std::uint32_t>(column));
      out.push_back(triangle(id));
      out.push_back(triangle(id + 1));
    }
  }
}

/// South-east: SW, SE, NE. North-west: SW, NE, NW.
Facet GridGround::triangle(std::uint32_t id) const {
  const auto cells = static_cast<std::uint32_t>(grid_.columns - 1);
  const int c = static_cast<int>(id / 2 % cells), r = static_cast<int>(id / 2 / cells);
  const bool upper = id % 2 == 1;
  const std::uint64_t columns = static_cast<std::uint64_t>(grid_.columns),
                      south_west = static_cast<std::uint64_t>(r) * columns + static_cast<std::uint64_t>(c);
  Facet facet;
  facet.id = id;
  facet.corner[0] = place(c, r);
  facet.corner[1] = upper ? place(c + 1, r + 1) : place(c + 1, r);
  facet.corner[2] = upper ? place(c, r + 1) : place(c + 1, r + 1);
  facet.vertex[0] = south_west;
  facet.vertex[1] = upper ? south_west + columns + 1 : south_west + 1;
  facet.vertex[2] = upper ? south_west + columns : south_west + columns + 1;
  facet.normal = facet.along(0).cross(facet.corner[2] - facet.corner[0]).normalized();
  return facet;
}

Facet GridGround::facet(std::uint32_t id) const {
  const auto cells = static_cast<std::uint32_t>(grid_.columns - 1);
  const int c = static_cast<int>(id / 2 % cells), r = static_cast<int>(id / 2 / cells);
  const bool upper = id % 2 == 1;
  struct Across {
    int column, row, off_column, off_row, rim;  ///< rim: of the other facet
  };
  std::array<Across, 3> across;
  if (!upper)
    across = {{{c, r - 1, c, r - 1, 1}, {c + 1, r, c + 2, r + 1, 2}, {c, r, c, r + 1, 0}}};
  else
    across = {{{c, r, c + 1, r, 2}, {c, r + 1, c + 1, r + 2, 0}, {c - 1, r, c - 1, r, 1}}};
  Facet facet = triangle(id);
  for (int i = 0; i < 3; ++i) {
    const Across& other = across[i];
    facet.edge[i] = 3 * static_cast<std::uint64_t>(id) + static_cast<std::uint64_t>(i);
    if (!has_ground(other.column, other.row)) continue;
    const std::uint64_t neighbour =
        2 * (static_cast<std::uint64_t>(other.row) * cells + static_cast<std::uint64_t>(other.column)) +
        (upper ? 0 : 1);
    if (neighbour < id) facet.edge[i] = 3 * neighbour + static_cast<std::uint64_t>(other.rim);
    const Vec3 &start = facet.corner[i], off = place(other.off_column, other.off_row);
    facet.beyond[i] = (off - start).cross(facet.along(i)).normalized();
    facet.rim[i] = rim_between(facet.normal, facet.corner[Facet::next(Facet::next(i))], facet.beyond[i], off,
                               start, noise_);
  }
  return facet;
}

/// The south-eastern facet of the cell in the south-west, where there is ground around a peak.
std::uint32_t GridGround::facet_at(std::uint64_t vertex) const {
  const auto columns = static_cast<std::uint64_t>(grid_.columns);
  const std::uint64_t c = vertex % columns, r = vertex / columns;
  const std::uint64_t west = c > 0 ? c - 1 : 0, south = r > 0 ? r - 1 : 0;
  return static_cast<std::uint32_t>(2 * (south * (columns - 1) + west));
}

bool GridGround::peak(std::uint64_t vertex, std::vector<Vec3>& edges) const {
  const auto columns = static_cast<std::uint64_t>(grid_.columns);
  const int c = static_cast<int>(vertex % columns), r = static_cast<int>(vertex / columns);
  if (!has_ground(c - 1, r - 1) || !has_ground(c, r - 1) || !has_ground(c - 1, r) || !has_ground(c, r))
    return false;
  const Vec3 top = place(c, r);
  std::array<Vec3, 6> to, normal;
  for (int k = 0; k < 6; ++k) to[k] = place(c + neighbours_around[k][0], r + neighbours_around[k][1]) - top;
  for (int k = 0; k < 6; ++k) normal[k] = to[k].cross(to[(k + 1) % 6]).normalized();
  int convex = 0;
  for (int k = 0; k < 6; ++k)
    convex += rim_between(normal[(k + 5) % 6], to[(k + 5) % 6], normal[k], to[(k + 1) % 6], Vec3::Zero(),
                          noise_) == Rim::convex;
  if (convex < 3) return false;
  edges.insert(edges.end(), to.begin(), to.end());
  return true;
}

int GridGround::part(std::uint32_t facet) const {
  if (grid_.part.empty()) return 0;
  const auto cells = static_cast<std::uint32_t>(grid_.columns - 1);
  const std::uint32_t c = facet / 2 % cells, r = facet / 2 / cells;
  const bool upper = facet % 2 == 1;
  return grid_.part[static_cast<std::size_t>(r + upper) * grid_.columns + c + !upper];
}

}  // namespace flyrock
