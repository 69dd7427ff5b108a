#include "survey/mesh_gaps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/box.h"
#include "geometry/mesh_edges.h"
#include "geometry/place_text.h"
#include "geometry/plan_cells_of.h"

namespace flyrock {

namespace {

struct BorderEdge {
  int from = 0, to = 0;  ///< vertices, in the order of the triangle
  int triangle = 0;
};

using Neighbours = std::vector<std::array<int, 3>>;

std::vector<BorderEdge> border_of(const Mesh& mesh, const Neighbours& across) {
  std::vector<BorderEdge> border;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
    for (int k = 0; k < 3; ++k)
      if (across[t][k] < 0) border.push_back({mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3], t});
  return border;
}

class Gaps {
 public:
  Gaps(const Mesh& mesh, const std::vector<int>& lines, const Neighbours& across)
      : mesh_(mesh),
        lines_(lines),
        pieces_(pieces_of(across)),
        border_(border_of(mesh, across)),
        reach_(gap_reach(mesh)) {}

  std::vector<MeshFault> all() {
    find_gaps();
    std::map<Pair, Overlap> overlaps;
    if (std::count(pieces_.is_open.begin(), pieces_.is_open.end(), true) > 1) overlaps = find_overlaps();
    std::vector<MeshFault> found;
    for (const auto& [pair, gap] : gaps_)
      if (!overlaps.contains(pair)) found.push_back(gap_fault(pair, gap));
    for (const auto& [pair, overlap] : overlaps) found.push_back(overlap_fault(overlap));
    return found;
  }

 private:
  using Pair = std::pair<int, int>;  ///< of pieces, the lower first
  struct Gap {
    int places = 0, vertex = 0, triangle = 0;
    double least = 0, greatest = 0;
  };

  const Vec3& at(int vertex) const { return mesh_.vertices[vertex]; }

  /// Each vertex of the border against each edge of the border near it.
  void find_gaps() {
    const std::size_t vertices = mesh_.vertices.size();
    std::vector<double> shortest(vertices, 1e300);  // border edge at a vertex
    std::vector<std::array<int, 2>> beside(vertices, {-1, -1});
    std::vector<int> triangle(vertices, -1);
    double sum = 0;
    for (const BorderEdge& edge : border_) {
      const double length = (at(edge.to) - at(edge.from)).norm();
      sum += length;
      for (const int v : {edge.from, edge.to}) shortest[v] = std::min(shortest[v], length);
      beside[edge.from][0] = edge.to;
      beside[edge.to][1] = edge.from;
      triangle[edge.from] = edge.triangle;
    }
    if (border_.empty()) return;
    PlanCellsOf<int> cells(std::max(2 * reach_, sum / static_cast<double>(border_.size())));
    for (int v = 0; v < static_cast<int>(vertices); ++v)
      if (triangle[v] >= 0) cells.add(at(v).head<2>(), at(v).head<2>(), v);
    cells.sort();
    for (const BorderEdge& edge : border_) {
      const Vec3 &a = at(edge.from), &b = at(edge.to);
      const double length = (b - a).norm();
      const Vec2 low = a.cwiseMin(b).head<2>(), high = a.cwiseMax(b).head<2>();
      cells.visit(low - Vec2::Constant(reach_), high + Vec2::Constant(reach_), [&](int v) {
        const auto meets = [&](int end) {
          return v == end || beside[v][0] == end || beside[v][1] == end || at(v) == at(end);
        };
        if (meets(edge.from) || meets(edge.to)) return;
        const double along = std::clamp((at(v) - a).dot(b - a) / (length * length), 0.0, 1.0);
        const Vec3 away = at(v) - (a + along * (b - a));
        const double width = away.norm();
        if (width > std::min({reach_, 0.25 * length, 0.25 * shortest[v]})) return;
        const Pair pair = std::minmax(pieces_.of[triangle[v]], pieces_.of[edge.triangle]);
        if (pair.first == pair.second && away.dot(outwards(edge)) < -0.5 * width) return;  // a thin triangle
        add(pair, v, triangle[v], width);
      });
    }
  }

  /// In the plane of the triangle of a border edge, away from it.
  Vec3 outwards(const BorderEdge& edge) const {
    const auto& corner = mesh_.triangles[edge.triangle];
    const Vec3 normal = (at(corner[1]) - at(corner[0])).cross(at(corner[2]) - at(corner[0]));
    return (at(edge.to) - at(edge.from)).cross(normal).normalized();
  }

  void add(const Pair& pair, int vertex, int triangle, double width) {
    const auto [found, is_new] = gaps_.try_emplace(pair, Gap{0, vertex, triangle, width, width});
    Gap& gap = found->second;
    ++gap.places;
    gap.least = std::min(gap.least, width);
    gap.greatest = std::max(gap.greatest, width);
  }

  MeshFault gap_fault(const Pair& pair, const Gap& gap) const {
    const std::string least = fmt::format("{:.3g}", 1e3 * gap.least),
                      greatest = fmt::format("{:.3g}", 1e3 * gap.greatest);
    const std::string width =
        least == greatest ? greatest + " mm" : fmt::format("{} to {} mm", least, greatest);
    const std::string where =
        fmt::format("at {}{}", place_text(at(gap.vertex)), lines_text(lines_, gap.triangle));
    const std::string more = gap.places == 1 ? "" : fmt::format(", and at {} other places", gap.places - 1);
    const char* what =
        pair.first == pair.second ? "the mesh has a slit of" : "two pieces of the mesh miss each other by";
    return {MeshFault::Kind::gap,
            fmt::format("{} {} {}{}: rocks fall through there", what, width, where, more), gap.greatest};
  }

  struct Overlap {
    int places = 0, triangle = 0, other = 0;
    Vec2 place = Vec2::Zero();
  };

  /// Pieces that share more in plan than what a weld of their gap closes.
  std::map<Pair, Overlap> find_overlaps() const {
    std::map<Pair, Overlap> overlaps;
    const std::vector<int> open = open_triangles();
    PlanCellsOf<int> cells(plan_size_of(open));
    for (const int t : open) {
      const auto [low, high] = box_of(t);
      cells.add(low, high, t);
    }
    cells.sort();
    for (const int t : open) {
      const auto [low, high] = box_of(t);
      cells.visit(low, high, [&](int other) {
        if (other >= t || pieces_.of[other] == pieces_.of[t]) return;
        const Pair pair = std::minmax(pieces_.of[other], pieces_.of[t]);
        const auto gap = gaps_.find(pair);
        const double closed = gap == gaps_.end() ? 0 : 2 * gap->second.greatest;
        const auto known = overlaps.find(pair);
        Vec2 place;
        if ((known != overlaps.end() && known->second.places > 1000) || !overlap_of(t, other, closed, place))
          return;
        if (known == overlaps.end())
          overlaps[pair] = {1, t, other, place};
        else
          ++known->second.places;
      });
    }
    return overlaps;
  }

  /// Triangles of open pieces that have an area in plan.
  std::vector<int> open_triangles() const {
    std::vector<int> open;
    for (int t = 0; t < static_cast<int>(mesh_.triangles.size()); ++t)
      if (pieces_.is_open[pieces_.of[t]] && std::abs(plan_area(t)) > 1e-9) open.push_back(t);
    return open;
  }

  double plan_area(int t) const {
    const auto& c = mesh_.triangles[t];
    return 0.5 * cross(Vec2((at(c[1]) - at(c[0])).head<2>()), Vec2((at(c[2]) - at(c[0])).head<2>()));
  }

  std::pair<Vec2, Vec2> box_of(int t) const {
    const auto& c = mesh_.triangles[t];
    return {at(c[0]).cwiseMin(at(c[1])).cwiseMin(at(c[2])).head<2>(),
            at(c[0]).cwiseMax(at(c[1])).cwiseMax(at(c[2])).head<2>()};
  }

  /// The mean size of triangles in plan [m].
  double plan_size_of(const std::vector<int>& triangles) const {
    double sum = 1e-3;
    for (const int t : triangles) {
      const auto [low, high] = box_of(t);
      sum += (high - low).maxCoeff();
    }
    return sum / static_cast<double>(std::max<std::size_t>(1, triangles.size()));
  }

  /// Whether two triangles share more in plan than a strip as wide as a gap, or as `closed`; the middle of
  /// what they share.
  bool overlap_of(int t, int other, double closed, Vec2& place) const {
    std::vector<Vec2> shared;
    for (const int v : mesh_.triangles[t]) shared.push_back(at(v).head<2>());
    const auto& by = mesh_.triangles[other];
    const double turn = plan_area(other) > 0 ? 1 : -1;
    for (int k = 0; k < 3 && !shared.empty(); ++k)
      shared = clipped(shared, at(by[k]).head<2>(), at(by[(k + 1) % 3]).head<2>(), turn);
    if (shared.size() < 3) return false;
    double area = 0, longest = 0;
    place = Vec2::Zero();
    for (std::size_t i = 0; i < shared.size(); ++i) {
      const Vec2 &a = shared[i], &b = shared[(i + 1) % shared.size()];
      area += 0.5 * cross(Vec2(a - shared[0]), Vec2(b - shared[0]));
      longest = std::max(longest, (a - shared[0]).norm());
      place += a / static_cast<double>(shared.size());
    }
    const double size = std::sqrt(std::min(std::abs(plan_area(t)), std::abs(plan_area(other))));
    return std::abs(area) > std::max(std::min(reach_, 0.2 * size), closed) * longest;
  }

  /// The part of a convex polygon on the inner side of a line.
  static std::vector<Vec2> clipped(const std::vector<Vec2>& polygon, const Vec2& from, const Vec2& to,
                                   double turn) {
    std::vector<Vec2> rest;
    const auto side = [&](const Vec2& p) { return turn * cross(Vec2(to - from), Vec2(p - from)); };
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      const double of_a = side(a), of_b = side(b);
      if (of_a >= 0) rest.push_back(a);
      if ((of_a < 0) != (of_b < 0)) rest.push_back(a + of_a / (of_a - of_b) * (b - a));
    }
    return rest;
  }

  double height_at(int t, const Vec2& place) const {
    const auto& c = mesh_.triangles[t];
    const Vec3 normal = (at(c[1]) - at(c[0])).cross(at(c[2]) - at(c[0]));
    return at(c[0]).z() - normal.head<2>().dot(place - at(c[0]).head<2>()) / normal.z();
  }

  MeshFault overlap_fault(const Overlap& overlap) const {
    return {MeshFault::Kind::over,
            fmt::format(
                "two surfaces lie over each other at {}, at heights of {:.6g} m and {:.6g} m{}{}; expected "
                "one surface",
                place_text(overlap.place), height_at(overlap.triangle, overlap.place),
                height_at(overlap.other, overlap.place), lines_text(lines_, overlap.triangle, overlap.other),
                overlap.places == 1 ? ""
                                    : fmt::format(", and so {}{} other pairs of triangles",
                                                  overlap.places > 1000 ? "over " : "", overlap.places - 1))};
  }

  const Mesh& mesh_;
  const std::vector<int>& lines_;
  MeshPieces pieces_;
  std::vector<BorderEdge> border_;
  double reach_;  ///< m
  std::map<Pair, Gap> gaps_;
};

}  // namespace

double gap_reach(const Mesh& mesh) {
  if (mesh.vertices.empty()) return 0;
  return std::max(1e-4 * Box3::around(mesh.vertices).size().maxCoeff(), 0.02);
}

std::vector<MeshFault> gap_faults(const Mesh& mesh, const std::vector<int>& lines) {
  return Gaps(mesh, lines, neighbours_of(mesh.triangles, sorted_sides(mesh.triangles))).all();
}

}  // namespace flyrock
