#include "plugins/shape/deformable/gmsh_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>
#include <unordered_map>

#include "plugin/params.h"

namespace flyrock::plugins {

namespace {

/// A file line by line; errors name the line that was read last.
class GmshLines {
 public:
  explicit GmshLines(const std::string& path) : path_(path), file_(path, std::ios::binary) {
    if (!file_) throw PluginError(fmt::format("plugin deformable: cannot read the file {}", path));
  }

  [[noreturn]] void fail(const std::string& what, int line = 0) const {
    throw PluginError(
        fmt::format("plugin deformable: {}:{}: {}", path_, line > 0 ? line : std::max(1, number_), what));
  }
  int number() const { return number_; }

  /// Whether there is another line.
  bool next() {
    if (!std::getline(file_, text_)) return false;
    ++number_;
    while (!text_.empty() && (text_.back() == '\r' || text_.back() == ' ')) text_.pop_back();
    return true;
  }
  const std::string& text() const { return text_; }

  /// The numbers of the next line, at least `count` of them.
  std::vector<double> numbers(std::size_t count, const char* what) {
    if (!next()) fail(fmt::format("the file ends early, expected {}", what));
    std::vector<double> list;
    for (const char *at = text_.data(), *end = at + text_.size(); at != end;) {
      if (*at == ' ' || *at == '\t') {
        ++at;
        continue;
      }
      double number = 0;
      const auto [after, code] = std::from_chars(at, end, number);
      if (code != std::errc() || (after != end && *after != ' ' && *after != '\t'))
        fail(fmt::format("`{}` is no list of numbers, expected {}", text_, what));
      list.push_back(number);
      at = after;
    }
    if (list.size() < count) fail(fmt::format("has {} numbers, expected {}", list.size(), what));
    return list;
  }

 private:
  std::string path_;
  std::ifstream file_;
  std::string text_;
  int number_ = 0;
};

/// How the elements of a mesh are called, and the order of the nodes of one.
template <int D>
struct ElementWords;
template <>
struct ElementWords<2> {
  static constexpr int type = 2;  // of Gmsh: 3 nodes
  static constexpr const char *one = "triangle", *many = "triangles", *content = "area",
                              *order = "its nodes counter-clockwise";
};
template <>
struct ElementWords<3> {
  static constexpr int type = 4;  // of Gmsh: 4 nodes
  static constexpr const char *one = "tetrahedron", *many = "tetrahedra", *content = "volume",
                              *order = "its first 3 nodes counter-clockwise as seen from the fourth";
};

/// The mesh with what errors name: tags and lines of the file.
template <int D>
struct GmshDraft {
  GivenMesh<D> mesh;
  std::unordered_map<std::int64_t, int> node_of_tag;
  std::vector<std::int64_t> node_tags, cell_tags;
  std::vector<int> node_lines, cell_lines;
  std::vector<double> heights;  ///< z of the nodes

  const Vec<D>& place(int node) const { return mesh.nodes[static_cast<std::size_t>(node)]; }
  [[noreturn]] void fail_at_node(const GmshLines& lines, int node, const std::string& what) const {
    const auto i = static_cast<std::size_t>(node);
    lines.fail(fmt::format("node {} {}", node_tags[i], what), node_lines[i]);
  }
  [[noreturn]] void fail_at_cell(const GmshLines& lines, std::size_t cell, const std::string& what) const {
    lines.fail(fmt::format("{} {} {}", ElementWords<D>::one, cell_tags[cell], what), cell_lines[cell]);
  }
};

void read_format(GmshLines& lines) {
  if (!lines.next() || lines.text() != "$MeshFormat")
    lines.fail("is no file of Gmsh, expected `$MeshFormat` in its first line");
  const std::vector<double> format =
      lines.numbers(3, "`4.1 0 8`: the version, 0 for ASCII, 8 bytes a number");
  if (format[0] != 4.1)
    lines.fail(fmt::format("has version {:g} of the format, expected 4.1: gmsh FILE -save -format msh41",
                           format[0]));
  if (format[1] != 0) lines.fail("is binary, expected ASCII: gmsh FILE -save -format msh41 -bin 0");
}

template <int D>
void read_nodes(GmshLines& lines, GmshDraft<D>& draft) {
  const auto head = lines.numbers(4, "numbers of blocks and nodes, least and greatest tag");
  if (head[1] > most_mesh_nodes<D>)
    lines.fail(fmt::format("the mesh has {:.0f} nodes, expected at most {}", head[1], most_mesh_nodes<D>));
  for (int block = 0; block < head[0]; ++block) {
    const auto of_block = lines.numbers(4, "a block: dimension, tag, parametric, number of nodes");
    const std::size_t first = draft.node_tags.size();
    if (!(of_block[3] >= 0 && static_cast<double>(first) + of_block[3] <= head[1]))
      lines.fail(fmt::format("a block of {:.0f} nodes, expected {:.0f} nodes in all", of_block[3], head[1]));
    const auto count = static_cast<std::size_t>(of_block[3]);
    for (std::size_t i = 0; i < count; ++i) {
      const auto tag = static_cast<std::int64_t>(lines.numbers(1, "the tag of a node")[0]);
      if (!draft.node_of_tag.try_emplace(tag, static_cast<int>(first + i)).second)
        lines.fail(fmt::format("node {} is given twice", tag));
      draft.node_tags.push_back(tag);
    }
    for (std::size_t i = 0; i < count; ++i) {
      const auto place = lines.numbers(3, "the place of a node: x y z");
      draft.mesh.nodes.push_back(Vec3(place[0], place[1], place[2]).head<D>());
      draft.heights.push_back(place[2]);
      draft.node_lines.push_back(lines.number());
    }
  }
}

/// D! times the volume of a cell.
double determinant(const GmshDraft<2>& draft, const std::array<int, 3>& cell) {
  const Vec2& a = draft.place(cell[0]);
  return cross(draft.place(cell[1]) - a, draft.place(cell[2]) - a);
}
double determinant(const GmshDraft<3>& draft, const std::array<int, 4>& cell) {
  const Vec3& a = draft.place(cell[0]);
  return (draft.place(cell[1]) - a).cross(draft.place(cell[2]) - a).dot(draft.place(cell[3]) - a);
}

template <int D>
void read_elements(GmshLines& lines, GmshDraft<D>& draft) {
  using Words = ElementWords<D>;
  const auto head = lines.numbers(4, "numbers of blocks and elements, least and greatest tag");
  for (int block = 0; block < head[0]; ++block) {
    const auto of_block = lines.numbers(4, "a block: dimension, tag, type, number of elements");
    for (int i = 0; i < of_block[3]; ++i) {
      if (of_block[2] != Words::type) {
        lines.numbers(2, "an element: its tag and nodes");
        ++draft.mesh.ignored;
        continue;
      }
      const auto element =
          lines.numbers(D + 2, fmt::format("a {}: its tag and {} nodes", Words::one, D + 1).c_str());
      const auto tag = static_cast<std::int64_t>(element[0]);
      std::array<int, D + 1> cell{};
      for (std::size_t k = 0; k <= D; ++k) {
        const auto node = draft.node_of_tag.find(static_cast<std::int64_t>(element[k + 1]));
        if (node == draft.node_of_tag.end())
          lines.fail(fmt::format("{} {} has the node {:.0f}, which `$Nodes` has not", Words::one, tag,
                                 element[k + 1]));
        cell[k] = node->second;
      }
      if (!(determinant(draft, cell) > 0))
        lines.fail(fmt::format("{} {} is inverted or has no {}, expected {}", Words::one, tag, Words::content,
                               Words::order));
      draft.mesh.cells.push_back(cell);
      draft.cell_tags.push_back(tag);
      draft.cell_lines.push_back(lines.number());
    }
  }
}

template <int D>
void check_nodes(const GmshLines& lines, const GmshDraft<D>& draft) {
  constexpr double flat = 1e-9;  // of the extent
  std::vector<bool> used(draft.mesh.nodes.size(), false);
  Vec<D> low = Vec<D>::Constant(infinite), high = -low;
  for (const auto& cell : draft.mesh.cells)
    for (const int node : cell) {
      used[static_cast<std::size_t>(node)] = true;
      low = low.cwiseMin(draft.place(node));
      high = high.cwiseMax(draft.place(node));
    }
  for (std::size_t i = 0; i < used.size(); ++i) {
    const int node = static_cast<int>(i);
    if (!used[i]) draft.fail_at_node(lines, node, fmt::format("belongs to no {}", ElementWords<D>::one));
    if (D == 2 && std::abs(draft.heights[i] - draft.heights[0]) > flat * (high - low).norm())
      draft.fail_at_node(lines, node,
                         fmt::format("has z = {:g}, expected {:g} as the others: a mesh in the plane",
                                     draft.heights[i], draft.heights[0]));
  }
}

/// The sides of a cell, each in an order that shows its outside.
std::array<std::array<int, 2>, 3> sides_of(const std::array<int, 3>& cell) {
  const auto& [a, b, c] = cell;
  return {{{a, b}, {b, c}, {c, a}}};
}
std::array<std::array<int, 3>, 4> sides_of(const std::array<int, 4>& cell) {
  const auto& [a, b, c, d] = cell;
  return {{{a, c, b}, {a, b, d}, {b, c, d}, {c, a, d}}};
}
/// The same side with its least node first.
template <std::size_t N>
std::array<int, N> from_least(std::array<int, N> side) {
  std::rotate(side.begin(), std::min_element(side.begin(), side.end()), side.end());
  return side;
}
/// The cell at each side, by its nodes from_least.
template <int D>
using CellAtSide = std::map<std::array<int, D>, std::size_t>;

template <int D>
CellAtSide<D> cells_at_sides(const GmshLines& lines, const GmshDraft<D>& draft) {
  CellAtSide<D> cells;
  for (std::size_t i = 0; i < draft.mesh.cells.size(); ++i)
    for (const auto& side : sides_of(draft.mesh.cells[i]))
      if (!cells.try_emplace(D == 2 ? side : from_least(side), i).second)
        draft.fail_at_cell(lines, i, "overlaps another one: both have the same side");
  return cells;
}

/// A side that only one cell has.
template <int D>
struct OuterSide {
  std::array<int, D> nodes;
  std::size_t cell;
};

template <int D>
std::vector<OuterSide<D>> outer_sides(const CellAtSide<D>& cells) {
  std::vector<OuterSide<D>> outer;
  for (const auto& [side, cell] : cells) {
    auto other = side;
    std::reverse(other.begin(), other.end());
    if (!cells.contains(D == 2 ? other : from_least(other))) outer.push_back({side, cell});
  }
  return outer;
}

/// Whether a place lies within a side, its ends and edges among it.
bool is_within(const GmshDraft<2>& draft, const std::array<int, 2>& side, const Vec2& at) {
  constexpr double near = 1e-9;  // of the side
  const Vec2& start = draft.place(side[0]);
  const Vec2 edge = draft.place(side[1]) - start, to = at - start;
  const double along = to.dot(edge) / edge.squaredNorm();
  return along > 0 && along < 1 && (to - along * edge).norm() <= near * edge.norm();
}
bool is_within(const GmshDraft<3>& draft, const std::array<int, 3>& side, const Vec3& at) {
  constexpr double near = 1e-9;  // of the side
  const Vec3& a = draft.place(side[0]);
  const Vec3 area = (draft.place(side[1]) - a).cross(draft.place(side[2]) - a);
  const double size = std::sqrt(area.norm());
  if (std::abs(area.normalized().dot(at - a)) > near * size) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& start = draft.place(side[k]);
    const Vec3 edge = draft.place(side[(k + 1) % 3]) - start;
    if (edge.cross(at - start).dot(area.normalized()) < -near * size * edge.norm()) return false;
  }
  return true;
}

/// A node within a side of a cell is not held by it.
template <int D>
void check_hanging(const GmshLines& lines, const GmshDraft<D>& draft,
                   const std::vector<OuterSide<D>>& sides) {
  for (const OuterSide<D>& side : sides)
    for (const OuterSide<D>& other : sides)
      for (const int node : other.nodes)
        if (std::find(side.nodes.begin(), side.nodes.end(), node) == side.nodes.end() &&
            is_within(draft, side.nodes, draft.place(node)))
          draft.fail_at_node(
              lines, node,
              fmt::format("hangs on a side of {} {}, expected {} that share whole sides",
                          ElementWords<D>::one, draft.cell_tags[side.cell], ElementWords<D>::many));
}

/// The sides of the only outline in their order. Other outlines are other pieces or holes.
std::vector<std::array<int, 2>> surface_of(const GmshLines& lines, const GmshDraft<2>& draft,
                                           const CellAtSide<2>&, const std::vector<OuterSide<2>>& sides) {
  std::map<int, const OuterSide<2>*> from;
  for (const OuterSide<2>& side : sides)
    if (!from.try_emplace(side.nodes[0], &side).second) {
      const auto node = static_cast<std::size_t>(side.nodes[0]);
      lines.fail(fmt::format("at node {} parts of the mesh touch in a point only, expected one piece",
                             draft.node_tags[node]),
                 draft.node_lines[node]);
    }
  std::vector<std::array<int, 2>> outline;
  int node = sides.front().nodes[0];
  do {
    outline.push_back(from.at(node)->nodes);
    from.erase(node);
    node = outline.back()[1];
  } while (node != sides.front().nodes[0]);
  if (!from.empty())
    draft.fail_at_cell(lines, from.begin()->second->cell,
                       "is at another outline: the mesh has several pieces or a hole, expected one piece "
                       "without holes");
  return outline;
}

/// All outer sides of a mesh whose cells hang together by sides.
std::vector<std::array<int, 3>> surface_of(const GmshLines& lines, const GmshDraft<3>& draft,
                                           const CellAtSide<3>& cells,
                                           const std::vector<OuterSide<3>>& sides) {
  std::vector<bool> reached(draft.mesh.cells.size(), false);
  std::vector<std::size_t> next{0};
  reached[0] = true;
  while (!next.empty()) {
    const std::size_t cell = next.back();
    next.pop_back();
    for (auto side : sides_of(draft.mesh.cells[cell])) {
      std::reverse(side.begin(), side.end());
      const auto other = cells.find(from_least(side));
      if (other == cells.end() || reached[other->second]) continue;
      reached[other->second] = true;
      next.push_back(other->second);
    }
  }
  const auto apart = std::find(reached.begin(), reached.end(), false);
  if (apart != reached.end())
    draft.fail_at_cell(lines, static_cast<std::size_t>(apart - reached.begin()),
                       "shares no side with the others: the mesh has several pieces, expected one");
  std::vector<std::array<int, 3>> surface;
  for (const OuterSide<3>& side : sides) surface.push_back(side.nodes);
  return surface;
}

}  // namespace

template <int D>
GivenMesh<D> read_gmsh(const std::string& path) {
  GmshLines lines(path);
  read_format(lines);
  GmshDraft<D> draft;
  bool has_nodes = false, has_elements = false;
  while (lines.next()) {
    if (lines.text() == "$Nodes") {
      read_nodes(lines, draft);
      has_nodes = true;
    } else if (lines.text() == "$Elements") {
      if (!has_nodes) lines.fail("`$Elements` comes without `$Nodes` above it");
      read_elements(lines, draft);
      has_elements = true;
    }
  }
  if (!has_elements) lines.fail("the file ends without `$Elements`");
  if (draft.mesh.cells.empty())
    lines.fail(fmt::format("has no {0} of {1} nodes, and {2} other elements, expected a mesh of {0} in {3}D",
                           ElementWords<D>::many, D + 1, draft.mesh.ignored, D));
  check_nodes(lines, draft);
  const CellAtSide<D> cells = cells_at_sides(lines, draft);
  const std::vector<OuterSide<D>> sides = outer_sides<D>(cells);
  check_hanging(lines, draft, sides);
  draft.mesh.sides = surface_of(lines, draft, cells, sides);
  return std::move(draft.mesh);
}

template GivenMesh<2> read_gmsh(const std::string&);
template GivenMesh<3> read_gmsh(const std::string&);

}  // namespace flyrock::plugins
