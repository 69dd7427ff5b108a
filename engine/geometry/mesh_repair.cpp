#include "geometry/mesh_repair.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "geometry/fill_hole.h"
#include "geometry/mesh_edges.h"
#include "geometry/mesh_fault.h"
#include "geometry/place_text.h"
#include "geometry/plan_cells_of.h"

namespace flyrock {

namespace {

using Neighbours = std::vector<std::array<int, 3>>;

Neighbours neighbours(const Mesh& mesh) {
  return neighbours_of(mesh.triangles, sorted_sides(mesh.triangles));
}

std::string counted(std::size_t count, const char* one, const char* several) {
  return fmt::format("{} {}", count, count == 1 ? one : several);
}

class Mender {
 public:
  Mender(Mesh& mesh, std::vector<int>& lines) : mesh_(mesh), lines_(lines) {}

  std::vector<std::string> mend(const MeshRepair& repair) {
    drop_twins();
    drop_flat();
    if (repair.weld > 0) weld(repair.weld);
    drop_skirts();
    if (repair.keep_largest) keep_largest();
    turn_over();
    if (repair.fill_holes > 0) fill_holes(repair.fill_holes);
    return std::move(notes_);
  }

 private:
  const Vec3& at(int vertex) const { return mesh_.vertices[vertex]; }
  const Vec3& corner(int t, int k) const { return at(mesh_.triangles[t][k % 3]); }
  int triangles() const { return static_cast<int>(mesh_.triangles.size()); }

  Vec3 twice_area(int t) const { return (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0)); }

  /// " (lines 4, 8, 15, ...)"
  std::string lines_of(const std::vector<int>& of) const {
    constexpr std::size_t most = 5;
    if (lines_.empty() || of.empty()) return {};
    std::string text;
    for (std::size_t i = 0; i < std::min(most, of.size()); ++i)
      text += fmt::format("{}{}", i == 0 ? "" : ", ", lines_[of[i]]);
    return fmt::format(" (line{} {}{})", of.size() == 1 ? "" : "s", text, of.size() > most ? ", ..." : "");
  }

  void add_triangle(const std::array<int, 3>& corners, int like) {
    mesh_.triangles.push_back(corners);
    mesh_.part.push_back(mesh_.part[like]);
    if (!lines_.empty()) lines_.push_back(lines_[like]);
  }

  void erase(const std::vector<bool>& gone) {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (gone[t]) continue;
      mesh_.triangles[kept] = mesh_.triangles[t];
      mesh_.part[kept] = mesh_.part[t];
      if (!lines_.empty()) lines_[kept] = lines_[t];
      ++kept;
    }
    mesh_.triangles.resize(kept);
    mesh_.part.resize(kept);
    if (!lines_.empty()) lines_.resize(kept);
  }

  /// Splits triangle t at a vertex on its side k. The new triangle comes last.
  void split_side(int t, int k, int vertex) {
    const std::array<int, 3> c = mesh_.triangles[t];
    mesh_.triangles[t][(k + 1) % 3] = vertex;
    add_triangle({vertex, c[(k + 1) % 3], c[(k + 2) % 3]}, t);
  }

  // Triangles without an area

  bool is_flat(int t) const { return !has_area(corner(t, 0), corner(t, 1), corner(t, 2)); }

  /// A pass may leave others flat, which the next one drops.
  void drop_flat() {
    const int before = triangles();
    std::vector<int> without_area;
    for (int t = 0; t < before; ++t)
      if (is_flat(t)) without_area.push_back(t);
    if (without_area.empty()) return;
    const std::string where = fmt::format("{}, the first with a corner at {}", lines_of(without_area),
                                          place_text(corner(without_area[0], 0)));
    join_equal_places(mesh_);
    constexpr int most_passes = 20;
    for (int pass = 0; pass < most_passes && drop_flat_once(); ++pass) {
    }
    mesh_ = welded(std::move(mesh_));
    notes_.push_back(fmt::format(
        "dropped {}{}", counted(without_area.size(), "triangle without an area", "triangles without an area"),
        where));
  }

  bool drop_flat_once() {
    const Neighbours across = neighbours(mesh_);
    const int known = triangles();
    std::vector<bool> gone(mesh_.triangles.size(), false), touched = gone;
    std::vector<int> joined(mesh_.vertices.size());
    std::iota(joined.begin(), joined.end(), 0);
    bool any = false, joins = false;
    for (int t = 0; t < known; ++t) {
      if (touched[t] || !is_flat(t)) continue;
      any = true;
      const auto [shortest, longest] = ends_of_sizes(t);
      const auto c = mesh_.triangles[t];
      const int a = c[shortest], b = c[(shortest + 1) % 3];
      if (a == b || c[(shortest + 2) % 3] == a) {
        gone[t] = touched[t] = true;
      } else if ((at(a) - at(b)).norm() < 2e-6) {  // has_area: such a side makes all triangles at it flat
        joined[std::max(a, b)] = std::min(a, b);
        joins = true;
        gone[t] = touched[t] = true;
      } else {
        const int other = across[t][longest];
        if (other >= 0 && touched[other]) continue;  // in the next pass
        gone[t] = touched[t] = true;
        if (other < 0) continue;
        touched[other] = true;
        int side = 0;
        while (mesh_.triangles[other][side] != c[(longest + 1) % 3]) side = (side + 1) % 3;
        if (mesh_.triangles[other][(side + 1) % 3] == c[longest]) {
          split_side(other, side, c[(longest + 2) % 3]);
          gone.push_back(false);
          touched.push_back(true);
        }
      }
    }
    if (joins)
      for (auto& triangle : mesh_.triangles)
        for (int& v : triangle)
          while (joined[v] != v) v = joined[v];
    erase(gone);
    return any;
  }

  // Triangles that stand twice

  /// Of triangles with the same corners one stays: of two that face opposite ways, as files for drawing have
  /// them, the one that looks up.
  void drop_twins() {
    Mesh joined =
        mesh_;  // twins meet others at edges of more than two triangles, where vertices are repeated
    join_equal_places(joined);
    for (auto& triangle : joined.triangles) std::sort(triangle.begin(), triangle.end());
    const auto corners = [&joined](int t) -> const std::array<int, 3>& { return joined.triangles[t]; };
    std::vector<int> order(mesh_.triangles.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return corners(a) < corners(b); });
    std::vector<bool> gone(mesh_.triangles.size(), false);
    std::vector<int> dropped;
    for (std::size_t i = 0, end = 0; i < order.size(); i = end) {
      int kept = order[i];
      for (end = i + 1; end < order.size() && corners(order[end]) == corners(order[i]); ++end) {
        int other = order[end];
        if (twice_area(other).z() > twice_area(kept).z()) std::swap(kept, other);
        gone[other] = true;
        dropped.push_back(other);
      }
    }
    if (dropped.empty()) return;
    std::sort(dropped.begin(), dropped.end());
    notes_.push_back(fmt::format("dropped {} with the corners of another one{}",
                                 counted(dropped.size(), "triangle", "triangles"), lines_of(dropped)));
    erase(gone);
    join_equal_places(mesh_);
    mesh_ = welded(std::move(mesh_));
  }

  /// The shortest and the longest side of a triangle.
  std::pair<int, int> ends_of_sizes(int t) const {
    double length[3];
    for (int k = 0; k < 3; ++k) length[k] = (corner(t, k + 1) - corner(t, k)).squaredNorm();
    return {static_cast<int>(std::min_element(length, length + 3) - length),
            static_cast<int>(std::max_element(length, length + 3) - length)};
  }

  // Borders that nearly touch

  void weld(double width) {
    const std::size_t joined = join_border_vertices(width), split = split_border_edges(width);
    if (joined + split == 0) return;
    drop_flat_after_weld();
    mesh_ = welded(std::move(mesh_));
    notes_.push_back(fmt::format(
        "welded {} within {:.3g} m{}", counted(joined, "vertex", "vertices"), width,
        split == 0 ? "" : fmt::format(" and {} to vertices near them", counted(split, "edge", "edges"))));
  }

  void drop_flat_after_weld() {
    const std::size_t notes = notes_.size();
    drop_flat();
    notes_.resize(notes);  // the weld says it
  }

  std::vector<int> border_vertices(const Neighbours& across) const {
    std::set<int> border;
    for (int t = 0; t < triangles(); ++t)
      for (int k = 0; k < 3; ++k)
        if (across[t][k] < 0) border.insert({mesh_.triangles[t][k], mesh_.triangles[t][(k + 1) % 3]});
    return {border.begin(), border.end()};
  }

  /// Each vertex of a border goes to the nearest earlier one within `width`, which itself stays.
  std::size_t join_border_vertices(double width) {
    const std::vector<int> border = border_vertices(neighbours(mesh_));
    PlanCellsOf<int> cells(4 * width);
    for (const int v : border) cells.add(at(v).head<2>(), at(v).head<2>(), v);
    cells.sort();
    std::vector<int> joined(mesh_.vertices.size());
    std::iota(joined.begin(), joined.end(), 0);
    std::size_t count = 0;
    for (const int v : border) {
      double least = width;
      const Vec2 place = at(v).head<2>(), reach = Vec2::Constant(width);
      int nearest = v;
      cells.visit(place - reach, place + reach, [&](int other) {
        if (other >= v || joined[other] != other) return;
        const double distance = (at(other) - at(v)).norm();
        if (distance > least || (distance == least && nearest != v && other >= nearest)) return;
        least = distance;
        nearest = other;
      });
      joined[v] = nearest;
      count += nearest != v && at(nearest) != at(v);
    }
    for (auto& triangle : mesh_.triangles)
      for (int& v : triangle) v = joined[v];
    return count;
  }

  /// Splits each edge of a border at the vertices of borders within `width` of it, one a pass.
  std::size_t split_border_edges(double width) {
    std::size_t count = 0;
    for (std::size_t before = 1; before > 0; count += before) before = split_once(width);
    return count;
  }

  std::size_t split_once(double width) {
    const Neighbours across = neighbours(mesh_);
    const std::vector<int> border = border_vertices(across);
    double sum = 0;
    std::vector<std::pair<int, int>> edges;
    for (int t = 0; t < triangles(); ++t)
      for (int k = 0; k < 3; ++k)
        if (across[t][k] < 0) {
          edges.emplace_back(t, k);
          sum += (corner(t, k + 1) - corner(t, k)).norm();
        }
    if (edges.empty()) return 0;
    PlanCellsOf<int> cells(std::max(2 * width, sum / static_cast<double>(edges.size())));
    for (const int v : border) cells.add(at(v).head<2>(), at(v).head<2>(), v);
    cells.sort();
    std::vector<bool> touched(mesh_.triangles.size(), false);
    std::size_t count = 0;
    for (const auto& [t, k] : edges) {
      if (touched[t]) continue;
      const int vertex = vertex_on(t, k, width, cells);
      if (vertex < 0) continue;
      touched[t] = true;
      split_side(t, k, vertex);
      ++count;
    }
    return count;
  }

  /// The vertex nearest to a side, within `width` of it and not near its ends; -1: none.
  int vertex_on(int t, int k, double width, const PlanCellsOf<int>& cells) const {
    const Vec3 &a = corner(t, k), &b = corner(t, k + 1);
    const auto& own = mesh_.triangles[t];
    const double length = (b - a).norm();
    const Vec2 reach = Vec2::Constant(width);
    double least = width;
    int nearest = -1;
    cells.visit(a.cwiseMin(b).head<2>() - reach, a.cwiseMax(b).head<2>() + reach, [&](int v) {
      if (v == own[0] || v == own[1] || v == own[2]) return;
      const double along = (at(v) - a).dot(b - a) / length;
      if (along < width || along > length - width) return;
      const double away = (at(v) - a - along / length * (b - a)).norm();
      if (away > least || (away == least && nearest >= 0 && v >= nearest)) return;
      if (!has_area(a, at(v), corner(t, k + 2)) || !has_area(at(v), b, corner(t, k + 2))) return;
      least = away;
      nearest = v;
    });
    return nearest;
  }

  // Skirts

  /// Upright strips that hang from edges with more than two triangles, or with two that face opposite ways,
  /// and that hold nothing: no other edge of theirs meets the rest.
  void drop_skirts() {
    const std::vector<MeshSide> sides = sorted_sides(mesh_.triangles);
    std::vector<bool> upright(mesh_.triangles.size());
    for (int t = 0; t < triangles(); ++t) {
      const Vec3 normal = twice_area(t);
      upright[t] = std::abs(normal.z()) < 1e-3 * normal.norm();
    }
    std::vector<int> strip(mesh_.triangles.size());
    std::iota(strip.begin(), strip.end(), 0);
    const auto root = [&strip](int t) {
      while (strip[t] != t) t = strip[t] = strip[strip[t]];
      return t;
    };
    const auto for_edges = [&](auto use) {
      for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
        for (end = i; end < sides.size() && sides[end].same_edge(sides[i]); ++end) {
        }
        use(i, end);
      }
    };
    for_edges([&](std::size_t begin, std::size_t end) {  // strips are joined by their own edges
      if (end - begin == 2 && upright[sides[begin].triangle] && upright[sides[begin + 1].triangle])
        strip[root(sides[begin].triangle)] = root(sides[begin + 1].triangle);
    });
    std::map<int, bool> hangs_wrong;  // of a strip: from a faulty edge
    std::set<int> holds;              // strips with a low edge that the rest meets
    for_edges([&](std::size_t begin, std::size_t end) {
      std::size_t others = 0;
      for (std::size_t i = begin; i < end; ++i) others += !upright[sides[i].triangle];
      if (others == 0) return;
      const bool is_faulty =
          end - begin > 2 || (end - begin == 2 && sides[begin].forward == sides[begin + 1].forward);
      for (std::size_t i = begin; i < end; ++i) {
        const int t = sides[i].triangle;
        if (!upright[t]) continue;
        if (is_faulty) hangs_wrong[root(t)] = true;
        const int third = mesh_.triangles[t][0] + mesh_.triangles[t][1] + mesh_.triangles[t][2] -
                          sides[i].low - sides[i].high;
        const double top = std::max(at(sides[i].low).z(), at(sides[i].high).z());
        if (at(third).z() > top) holds.insert(root(t));  // the rest meets it from below: a face
      }
    });
    std::vector<bool> gone(mesh_.triangles.size(), false);
    std::vector<int> dropped;
    for (int t = 0; t < triangles(); ++t)
      if (upright[t] && hangs_wrong.contains(root(t)) && !holds.contains(root(t))) {
        gone[t] = true;
        dropped.push_back(t);
      }
    if (dropped.empty()) return;
    notes_.push_back(fmt::format("dropped skirts of {} that hang from the edges of tiles{}",
                                 counted(dropped.size(), "triangle", "triangles"), lines_of(dropped)));
    erase(gone);
    mesh_ = welded(std::move(mesh_));
  }

  // Pieces

  void keep_largest() {
    const MeshPieces pieces = pieces_of(neighbours(mesh_));
    if (pieces.count() < 2) return;
    std::vector<double> surface(pieces.count(), 0);
    for (int t = 0; t < triangles(); ++t) surface[pieces.of[t]] += twice_area(t).norm();
    const int largest = static_cast<int>(std::max_element(surface.begin(), surface.end()) - surface.begin());
    std::vector<bool> gone(mesh_.triangles.size());
    for (int t = 0; t < triangles(); ++t) gone[t] = pieces.of[t] != largest;
    const auto dropped = static_cast<std::size_t>(std::count(gone.begin(), gone.end(), true));
    notes_.push_back(fmt::format("kept the largest of {} pieces and left out {}", pieces.count(),
                                 counted(dropped, "triangle", "triangles")));
    erase(gone);
    mesh_ = welded(std::move(mesh_));
  }

  /// Pieces that look down. One that looks sideways is left to the faults: up may be another axis.
  void turn_over() {
    const MeshPieces pieces = pieces_of(neighbours(mesh_));
    std::vector<Vec3> area(pieces.count(), Vec3::Zero());
    for (int t = 0; t < triangles(); ++t) area[pieces.of[t]] += twice_area(t);
    std::size_t turned = 0, count = 0;
    for (int p = 0; p < pieces.count(); ++p) turned += looks_down(pieces, area, p);
    if (turned == 0) return;
    for (int t = 0; t < triangles(); ++t)
      if (looks_down(pieces, area, pieces.of[t])) {
        std::swap(mesh_.triangles[t][1], mesh_.triangles[t][2]);
        ++count;
      }
    notes_.push_back(
        pieces.count() == 1
            ? fmt::format("turned the surface over: its corners are clockwise, seen from above ({})",
                          counted(count, "triangle", "triangles"))
            : fmt::format("turned {} over: their corners are clockwise, seen from above ({})",
                          counted(turned, "piece", "pieces"), counted(count, "triangle", "triangles")));
  }

  static bool looks_down(const MeshPieces& pieces, const std::vector<Vec3>& area, int piece) {
    return pieces.is_open[piece] && area[piece].z() < -0.5 * area[piece].norm();
  }

  // Holes

  void fill_holes(int most_edges) {
    if (!faults_at_edges().empty()) return;  // which are reported
    std::size_t holes = 0, added = 0;
    for (const std::vector<int>& hole : holes_of(mesh_)) {
      if (static_cast<int>(hole.size()) > most_edges) continue;
      const int like = triangle_at(hole[0], hole[1]);
      for (const auto& triangle : fill_hole(mesh_.vertices, hole)) {
        add_triangle(triangle, like);
        ++added;
      }
      ++holes;
    }
    if (holes > 0)
      notes_.push_back(fmt::format("filled {} with {}", counted(holes, "hole", "holes"),
                                   counted(added, "triangle", "triangles")));
  }

  std::vector<MeshFault> faults_at_edges() const {
    std::vector<MeshFault> found = faults(mesh_, lines_);
    std::erase_if(found, [](const MeshFault& f) { return f.kind == MeshFault::Kind::hole; });
    return found;
  }

  /// A triangle with the side from `from` to `to`.
  int triangle_at(int from, int to) const {
    for (int t = 0; t < triangles(); ++t)
      for (int k = 0; k < 3; ++k)
        if (mesh_.triangles[t][k] == from && mesh_.triangles[t][(k + 1) % 3] == to) return t;
    return 0;
  }

  Mesh& mesh_;
  std::vector<int>& lines_;
  std::vector<std::string> notes_;
};

}  // namespace

std::vector<std::string> mend(Mesh& mesh, std::vector<int>& lines, const MeshRepair& repair) {
  return Mender(mesh, lines).mend(repair);
}

}  // namespace flyrock
