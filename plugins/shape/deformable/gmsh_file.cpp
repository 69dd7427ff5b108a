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

constexpr std::size_t most_nodes = 10'000;
constexpr int triangle_type = 2;  // of Gmsh: 3 nodes

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

/// The mesh with what errors name: tags and lines of the file.
struct GmshDraft {
  GivenMesh mesh;
  std::unordered_map<std::int64_t, int> node_of_tag;
  std::vector<std::int64_t> node_tags, cell_tags;
  std::vector<int> node_lines, cell_lines;
  std::vector<double> heights;  ///< z of the nodes
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

void read_nodes(GmshLines& lines, GmshDraft& draft) {
  const auto head = lines.numbers(4, "numbers of blocks and nodes, least and greatest tag");
  if (head[1] > static_cast<double>(most_nodes))
    lines.fail(fmt::format("the mesh has {:.0f} nodes, expected at most {}", head[1], most_nodes));
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
      draft.mesh.nodes.emplace_back(place[0], place[1]);
      draft.heights.push_back(place[2]);
      draft.node_lines.push_back(lines.number());
    }
  }
}

void read_elements(GmshLines& lines, GmshDraft& draft) {
  const auto head = lines.numbers(4, "numbers of blocks and elements, least and greatest tag");
  for (int block = 0; block < head[0]; ++block) {
    const auto of_block = lines.numbers(4, "a block: dimension, tag, type, number of elements");
    for (int i = 0; i < of_block[3]; ++i) {
      if (of_block[2] != triangle_type) {
        lines.numbers(2, "an element: its tag and nodes");
        ++draft.mesh.ignored;
        continue;
      }
      const auto element = lines.numbers(4, "a triangle: its tag and 3 nodes");
      const auto tag = static_cast<std::int64_t>(element[0]);
      std::array<int, 3> cell{};
      for (std::size_t k = 0; k < 3; ++k) {
        const auto node = draft.node_of_tag.find(static_cast<std::int64_t>(element[k + 1]));
        if (node == draft.node_of_tag.end())
          lines.fail(
              fmt::format("triangle {} has the node {:.0f}, which `$Nodes` has not", tag, element[k + 1]));
        cell[k] = node->second;
      }
      const Vec2 &a = draft.mesh.nodes[static_cast<std::size_t>(cell[0])],
                 &b = draft.mesh.nodes[static_cast<std::size_t>(cell[1])],
                 &c = draft.mesh.nodes[static_cast<std::size_t>(cell[2])];
      if (!(cross(b - a, c - a) > 0))
        lines.fail(
            fmt::format("triangle {} is inverted or has no area, expected its nodes counter-clockwise", tag));
      draft.mesh.cells.push_back(cell);
      draft.cell_tags.push_back(tag);
      draft.cell_lines.push_back(lines.number());
    }
  }
}

void check_nodes(const GmshLines& lines, const GmshDraft& draft) {
  constexpr double flat = 1e-9;  // of the extent
  std::vector<bool> used(draft.mesh.nodes.size(), false);
  Vec2 low = Vec2::Constant(infinite), high = -low;
  for (const auto& cell : draft.mesh.cells)
    for (const int node : cell) {
      used[static_cast<std::size_t>(node)] = true;
      low = low.cwiseMin(draft.mesh.nodes[static_cast<std::size_t>(node)]);
      high = high.cwiseMax(draft.mesh.nodes[static_cast<std::size_t>(node)]);
    }
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i])
      lines.fail(fmt::format("node {} belongs to no triangle", draft.node_tags[i]), draft.node_lines[i]);
    if (std::abs(draft.heights[i] - draft.heights[0]) > flat * (high - low).norm())
      lines.fail(fmt::format("node {} has z = {:g}, expected {:g} as the others: a mesh in the plane",
                             draft.node_tags[i], draft.heights[i], draft.heights[0]),
                 draft.node_lines[i]);
  }
}

/// A side that only one triangle has, from node to node.
struct OuterSide {
  int start, end;
  std::size_t cell;
};

std::vector<OuterSide> outer_sides(const GmshLines& lines, const GmshDraft& draft) {
  std::map<std::pair<int, int>, std::size_t> sides;
  const auto& cells = draft.mesh.cells;
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      if (!sides.try_emplace({cells[i][k], cells[i][(k + 1) % 3]}, i).second)
        lines.fail(
            fmt::format("triangle {} overlaps another one: both have the same side", draft.cell_tags[i]),
            draft.cell_lines[i]);
  std::vector<OuterSide> outer;
  for (const auto& [side, cell] : sides)
    if (!sides.contains({side.second, side.first})) outer.push_back({side.first, side.second, cell});
  return outer;
}

/// A node within a side of a triangle is not held by it.
void check_hanging(const GmshLines& lines, const GmshDraft& draft, const std::vector<OuterSide>& sides) {
  constexpr double near = 1e-9;  // of the side
  const auto place = [&](int node) -> const Vec2& {
    return draft.mesh.nodes[static_cast<std::size_t>(node)];
  };
  for (const OuterSide& side : sides)
    for (const OuterSide& other : sides) {
      const int node = other.start;
      if (node == side.start || node == side.end) continue;
      const Vec2 edge = place(side.end) - place(side.start), to = place(node) - place(side.start);
      const double along = to.dot(edge) / edge.squaredNorm();
      if (along <= 0 || along >= 1 || (to - along * edge).norm() > near * edge.norm()) continue;
      lines.fail(
          fmt::format("node {} hangs on a side of triangle {}, expected triangles that share whole sides",
                      draft.node_tags[static_cast<std::size_t>(node)], draft.cell_tags[side.cell]),
          draft.node_lines[static_cast<std::size_t>(node)]);
    }
}

/// The nodes of the only outline in their order. Other outlines are other pieces or holes.
std::vector<int> outline_of(const GmshLines& lines, const GmshDraft& draft,
                            const std::vector<OuterSide>& sides) {
  std::map<int, const OuterSide*> from;
  for (const OuterSide& side : sides)
    if (!from.try_emplace(side.start, &side).second)
      lines.fail(fmt::format("at node {} parts of the mesh touch in a point only, expected one piece",
                             draft.node_tags[static_cast<std::size_t>(side.start)]),
                 draft.node_lines[static_cast<std::size_t>(side.start)]);
  std::vector<int> nodes;
  int node = sides.front().start;
  do {
    nodes.push_back(node);
    const OuterSide* side = from.at(node);
    from.erase(node);
    node = side->end;
  } while (node != nodes.front());
  if (from.empty()) return nodes;
  const std::size_t cell = from.begin()->second->cell;
  lines.fail(
      fmt::format("triangle {} is at another outline: the mesh has several pieces or a hole, expected one "
                  "piece without holes",
                  draft.cell_tags[cell]),
      draft.cell_lines[cell]);
}

}  // namespace

GivenMesh read_gmsh(const std::string& path) {
  GmshLines lines(path);
  read_format(lines);
  GmshDraft draft;
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
    lines.fail(
        fmt::format("has no triangles of 3 nodes, and {} other elements, expected a mesh of triangles in 2D",
                    draft.mesh.ignored));
  check_nodes(lines, draft);
  const std::vector<OuterSide> sides = outer_sides(lines, draft);
  check_hanging(lines, draft, sides);
  draft.mesh.outline = outline_of(lines, draft, sides);
  return std::move(draft.mesh);
}

}  // namespace flyrock::plugins
