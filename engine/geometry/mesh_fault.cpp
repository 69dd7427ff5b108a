#include "geometry/mesh_fault.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/mesh_edges.h"
#include "geometry/place_text.h"

namespace flyrock {

namespace {

/// A triangle lower than this share of its longest side, or than this length [m], has no normal that can be
/// trusted at 100 km from the origin, where a double resolves 1e-11 m.
constexpr double least_share = 1e-6, least_height = 1e-6;

class Checks {
 public:
  Checks(const Mesh& mesh, const std::vector<int>& lines) : mesh_(mesh), lines_(lines) {}

  std::string first_fault() {
    if (std::string found = indices(); !found.empty()) return found;
    if (std::string found = degenerate(); !found.empty()) return found;
    sides_ = sorted_sides(mesh_.triangles);
    if (std::string found = crowded_edges(); !found.empty()) return found;
    if (std::string found = flipped_neighbours(); !found.empty()) return found;
    neighbours_ = neighbours_of(mesh_.triangles, sides_);
    return pieces();
  }

 private:
  const Vec3& corner(int triangle, int k) const { return mesh_.vertices[mesh_.triangles[triangle][k % 3]]; }

  /// "the triangle (0, 0, 0), (1, 0, 0), (0, 1, 0) in line 7"
  std::string triangle_text(int t) const {
    return fmt::format("the triangle {}, {}, {}{}", place_text(corner(t, 0)), place_text(corner(t, 1)),
                       place_text(corner(t, 2)), line_text(t));
  }
  std::string line_text(int t) const { return lines_.empty() ? "" : fmt::format(" in line {}", lines_[t]); }

  std::string indices() const {
    const int vertices = static_cast<int>(mesh_.vertices.size());
    const int triangles = static_cast<int>(mesh_.triangles.size());
    if (triangles == 0) return "a mesh has no triangles";
    if (mesh_.part.size() != mesh_.triangles.size())
      return fmt::format("a mesh of {} triangles names the parts of {}", triangles, mesh_.part.size());
    for (int t = 0; t < triangles; ++t) {
      const int part = mesh_.part[t];
      if (part < 0 || part >= static_cast<int>(mesh_.parts.size()))
        return fmt::format("a mesh of {} parts has a triangle of part {}{}", mesh_.parts.size(), part,
                           line_text(t));
      for (const int index : mesh_.triangles[t])
        if (index < 0 || index >= vertices)
          return fmt::format("triangle {}{} of a mesh names the vertex {} of {} vertices (from 0)", t,
                             line_text(t), index, vertices);
      for (int k = 0; k < 3; ++k)
        if (!corner(t, k).allFinite())
          return fmt::format("a vertex of triangle {}{} of a mesh is not finite", t, line_text(t));
    }
    return {};
  }

  std::string degenerate() const {
    for (int t = 0; t < static_cast<int>(mesh_.triangles.size()); ++t) {
      const Vec3 a = corner(t, 1) - corner(t, 0), b = corner(t, 2) - corner(t, 0);
      const double longest = std::sqrt(std::max({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()}));
      const double height = longest > 0 ? a.cross(b).norm() / longest : 0;
      if (!(height > least_height && height > least_share * longest))
        return fmt::format(
            "{} has no area: it is {:.3g} m long and {:.3g} m high, expected a height above "
            "{:.0e} m and above {:.0e} of its length",
            triangle_text(t), longest, height, least_height, least_share);
    }
    return {};
  }

  std::string edge_text(const MeshSide& side) const {
    return fmt::format("from {} to {}", place_text(mesh_.vertices[side.low]),
                       place_text(mesh_.vertices[side.high]));
  }

  std::string crowded_edges() const {
    for (std::size_t i = 0; i + 2 < sides_.size(); ++i) {
      if (!sides_[i].same_edge(sides_[i + 2])) continue;
      std::size_t end = i;
      while (end < sides_.size() && sides_[end].same_edge(sides_[i])) ++end;
      std::string lines;
      for (std::size_t j = i; j < end && !lines_.empty(); ++j)
        lines += fmt::format("{}{}", j == i ? " (lines " : ", ", lines_[sides_[j].triangle]);
      if (!lines.empty()) lines += ")";
      return fmt::format("the edge {} has {} triangles{}, expected one or two", edge_text(sides_[i]), end - i,
                         lines);
    }
    return {};
  }

  std::string flipped_neighbours() const {
    int count = 0;
    const MeshSide* first = nullptr;
    for (std::size_t i = 0; i + 1 < sides_.size(); ++i) {
      if (!sides_[i].same_edge(sides_[i + 1]) || sides_[i].forward != sides_[i + 1].forward) continue;
      if (count++ == 0) first = &sides_[i];
    }
    if (count == 0) return {};
    const MeshSide& other = *(first + 1);
    const std::string lines =
        lines_.empty() ? ""
                       : fmt::format(" (lines {} and {})", lines_[first->triangle], lines_[other.triangle]);
    const std::string more = count == 1 ? "" : fmt::format(", and so at {} other edges", count - 1);
    return fmt::format(
        "the two triangles at the edge {}{} face opposite ways{}; expected the corners of all "
        "triangles counter-clockwise, seen from outside of the ground",
        edge_text(*first), lines, more);
  }

  /// Triangles that hang together by edges, and their borders.
  std::string pieces() {
    piece_.assign(mesh_.triangles.size(), -1);
    std::vector<int> triangles;
    for (int seed = 0; seed < static_cast<int>(mesh_.triangles.size()); ++seed) {
      if (piece_[seed] >= 0) continue;
      triangles.assign(1, seed);
      piece_[seed] = seed;
      for (std::size_t next = 0; next < triangles.size(); ++next)
        for (const int other : neighbours_[triangles[next]])
          if (other >= 0 && piece_[other] < 0) {
            piece_[other] = seed;
            triangles.push_back(other);
          }
      if (std::string found = piece_fault(triangles); !found.empty()) return found;
    }
    return {};
  }

  std::string piece_fault(const std::vector<int>& triangles) {
    const Vec3 origin = corner(triangles.front(), 0);  // near it the sums keep their digits
    double area = 0, surface = 0, volume = 0;
    for (const int t : triangles) {
      const Vec3 a = corner(t, 0) - origin, b = corner(t, 1) - origin, c = corner(t, 2) - origin;
      const Vec3 twice = (b - a).cross(c - a);
      area += twice.z() / 2;
      surface += twice.norm() / 2;
      volume += a.dot(b.cross(c)) / 6;
    }
    const std::vector<Loop> loops = borders(triangles);
    const std::string piece =
        fmt::format("the piece of {} triangles with {}", triangles.size(), triangle_text(triangles.front()));
    if (loops.empty() && volume <= 0)
      return fmt::format(
          "{} is closed and faces inwards; expected the corners of its triangles "
          "counter-clockwise, seen from outside of the ground",
          piece);
    if (!loops.empty() && area <= 1e-12 * surface)
      return fmt::format(
          "{} faces down{}: it has the ground above it; expected the corners of its triangles "
          "counter-clockwise, seen from above",
          piece, area < -1e-12 * surface ? "" : " or stands upright");
    return loops.size() < 2 ? std::string() : hole_text(loops);
  }

  struct Loop {
    int edges = 0;
    Vec3 low = Vec3::Constant(1e300), high = Vec3::Constant(-1e300);
    double size() const { return (high - low).norm(); }
  };

  std::vector<Loop> borders(const std::vector<int>& triangles) {
    std::vector<Loop> loops;
    visited_.resize(mesh_.triangles.size(), {false, false, false});
    for (const int seed : triangles) {
      for (int side = 0; side < 3; ++side) {
        if (neighbours_[seed][side] >= 0 || visited_[seed][side]) continue;
        Loop loop;
        for (int t = seed, k = side; !visited_[t][k];) {
          visited_[t][k] = true;
          ++loop.edges;
          loop.low = loop.low.cwiseMin(corner(t, k));
          loop.high = loop.high.cwiseMax(corner(t, k));
          next_border(t, k);
        }
        loops.push_back(loop);
      }
    }
    return loops;
  }

  /// From a side at the border to the one that follows it: turns about its end through the fan.
  void next_border(int& triangle, int& side) const {
    const int end = mesh_.triangles[triangle][(side + 1) % 3];
    side = (side + 1) % 3;
    while (neighbours_[triangle][side] >= 0) {
      triangle = neighbours_[triangle][side];
      side = 0;
      while (mesh_.triangles[triangle][side] != end) ++side;
    }
  }

  static std::string hole_text(std::vector<Loop> loops) {
    std::stable_sort(loops.begin(), loops.end(),
                     [](const Loop& a, const Loop& b) { return a.size() > b.size(); });
    const Loop& hole = loops[1];  // the greatest border is the end of the piece
    const std::string more = loops.size() == 2 ? "" : fmt::format(", and {} more", loops.size() - 2);
    return fmt::format(
        "the mesh has a hole of {} edges from {} to {}{}; expected ground without holes inside", hole.edges,
        place_text(hole.low), place_text(hole.high), more);
  }

  const Mesh& mesh_;
  const std::vector<int>& lines_;
  std::vector<MeshSide> sides_;
  std::vector<std::array<int, 3>> neighbours_;
  std::vector<int> piece_;
  std::vector<std::array<bool, 3>> visited_;
};

}  // namespace

std::string fault(const Mesh& mesh, const std::vector<int>& lines) {
  return Checks(mesh, lines).first_fault();
}

}  // namespace flyrock
