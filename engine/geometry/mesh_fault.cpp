#include "geometry/mesh_fault.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/mesh_border.h"
#include "geometry/mesh_edges.h"
#include "geometry/place_text.h"

namespace flyrock {

namespace {

constexpr double least_share = 1e-6, least_height = 1e-6;  // see has_area

struct TriangleSize {
  double longest = 0, height = 0;  ///< m
};

TriangleSize size_of(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double longest =
      std::sqrt(std::max({(b - a).squaredNorm(), (c - a).squaredNorm(), (c - b).squaredNorm()}));
  return {longest, longest > 0 ? (b - a).cross(c - a).norm() / longest : 0};
}

std::string more_text(std::size_t count) {
  return count < 2 ? std::string() : fmt::format(", and so {} other{}", count - 1, count == 2 ? "" : "s");
}

class Checks {
 public:
  Checks(const Mesh& mesh, const std::vector<int>& lines) : mesh_(mesh), lines_(lines) {}

  std::vector<MeshFault> all() {
    if (std::string found = indices(); !found.empty()) return {{MeshFault::Kind::broken, found}};
    std::vector<MeshFault> found;
    const auto add = [&](MeshFault::Kind kind, std::string text) {
      if (!text.empty()) found.push_back({kind, std::move(text)});
    };
    sides_ = sorted_sides(mesh_.triangles);
    add(MeshFault::Kind::flat, degenerate());
    add(MeshFault::Kind::crowded, crowded_edges());
    add(MeshFault::Kind::flipped, flipped_neighbours());
    if (!found.empty()) return found;  // no piece has an inside then
    neighbours_ = neighbours_of(mesh_.triangles, sides_);
    add_pieces(found);
    return found;
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
      return fmt::format("the mesh has {} triangles but {} part numbers", triangles, mesh_.part.size());
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
    std::size_t count = 0;
    std::string first;
    for (int t = 0; t < static_cast<int>(mesh_.triangles.size()); ++t) {
      if (has_area(corner(t, 0), corner(t, 1), corner(t, 2)) || count++ > 0) continue;
      const TriangleSize size = size_of(corner(t, 0), corner(t, 1), corner(t, 2));
      first = fmt::format(
          "{} has no area: it is {:.3g} m long and {:.3g} m high, expected a height above "
          "{:.0e} m and above {:.0e} of its length",
          triangle_text(t), size.longest, size.height, least_height, least_share);
    }
    return first + more_text(count);
  }

  std::string edge_text(const MeshSide& side) const {
    return fmt::format("from {} to {}", place_text(mesh_.vertices[side.low]),
                       place_text(mesh_.vertices[side.high]));
  }

  std::string crowded_edges() const {
    std::size_t count = 0;
    std::string first;
    for_edges(sides_, [&](std::size_t begin, std::size_t end) {
      if (end - begin > 2 && count++ == 0) first = crowded_text(begin, end);
    });
    return first + more_text(count);
  }

  std::string crowded_text(std::size_t begin, std::size_t end) const {
    std::string lines;
    for (std::size_t j = begin; j < end && !lines_.empty(); ++j)
      lines += fmt::format("{}{}", j == begin ? " (lines " : ", ", lines_[sides_[j].triangle]);
    if (!lines.empty()) lines += ")";
    return fmt::format("the edge {} has {} triangles{}, expected one or two", edge_text(sides_[begin]),
                       end - begin, lines);
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
    const std::string more = count == 1 ? "" : fmt::format(", and so at {} other edges", count - 1);
    return fmt::format(
        "the two triangles at the edge {}{} face opposite ways{}; expected the corners of all "
        "triangles counter-clockwise, seen from outside of the ground",
        edge_text(*first), lines_text(lines_, first->triangle, other.triangle), more);
  }

  /// The faults of pieces: each that faces down, and all holes together.
  void add_pieces(std::vector<MeshFault>& found) {
    const MeshPieces pieces = pieces_of(neighbours_);
    std::vector<std::vector<int>> triangles(pieces.is_open.size());
    for (int t = 0; t < static_cast<int>(mesh_.triangles.size()); ++t) triangles[pieces.of[t]].push_back(t);
    std::vector<std::vector<MeshBorder>> borders(pieces.is_open.size());
    for (MeshBorder& border : borders_of(mesh_, neighbours_))
      borders[pieces.of[border.triangle]].push_back(std::move(border));
    for (int piece = 0; piece < pieces.count(); ++piece) {
      if (std::string text = piece_fault(triangles[piece], pieces.is_open[piece]); !text.empty()) {
        found.push_back({MeshFault::Kind::down, std::move(text)});
        continue;
      }
      take_end(borders[piece]);
      std::move(borders[piece].begin(), borders[piece].end(), std::back_inserter(holes_));
    }
    if (holes_.empty()) return;
    int most = 0;
    for (const MeshBorder& hole : holes_) most = std::max(most, hole.edges());
    found.push_back({MeshFault::Kind::hole, hole_text(), static_cast<double>(most)});
  }

  std::string piece_fault(const std::vector<int>& triangles, bool is_open) const {
    const Vec3 origin = corner(triangles.front(), 0);  // near it the sums keep their digits
    double area = 0, surface = 0, volume = 0;
    for (const int t : triangles) {
      const Vec3 a = corner(t, 0) - origin, b = corner(t, 1) - origin, c = corner(t, 2) - origin;
      const Vec3 twice = (b - a).cross(c - a);
      area += twice.z() / 2;
      surface += twice.norm() / 2;
      volume += a.dot(b.cross(c)) / 6;
    }
    const std::string piece =
        fmt::format("the piece of {} triangles with {}", triangles.size(), triangle_text(triangles.front()));
    if (!is_open && volume <= 0)
      return fmt::format(
          "{} is closed and faces inwards; expected the corners of its triangles "
          "counter-clockwise, seen from outside of the ground",
          piece);
    if (is_open && area <= 1e-12 * surface)
      return fmt::format(
          "{} faces down{}: it has the ground above it; expected the corners of its triangles "
          "counter-clockwise, seen from above",
          piece, area < -1e-12 * surface ? "" : " or stands upright");
    return {};
  }

  std::string hole_text() const {
    const MeshBorder& hole =
        *std::max_element(holes_.begin(), holes_.end(),
                          [](const MeshBorder& a, const MeshBorder& b) { return a.size() < b.size(); });
    const std::string more = holes_.size() == 1 ? "" : fmt::format(", and {} more", holes_.size() - 1);
    return fmt::format(
        "the mesh has a hole of {} edges from {} to {}{}; expected ground without holes inside", hole.edges(),
        place_text(hole.box.low), place_text(hole.box.high), more);
  }

  const Mesh& mesh_;
  const std::vector<int>& lines_;
  std::vector<MeshSide> sides_;
  std::vector<std::array<int, 3>> neighbours_;
  std::vector<MeshBorder> holes_;
};

}  // namespace

bool has_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  const TriangleSize size = size_of(a, b, c);
  return size.height > least_height && size.height > least_share * size.longest;
}

std::string lines_text(const std::vector<int>& lines, int triangle, int other) {
  if (lines.empty()) return {};
  if (other < 0) return fmt::format(" (line {})", lines[triangle]);
  return fmt::format(" (lines {} and {})", lines[triangle], lines[other]);
}

MeshPieces pieces_of(const std::vector<std::array<int, 3>>& across) {
  MeshPieces pieces;
  pieces.of.assign(across.size(), -1);
  std::vector<int> reached;
  for (int seed = 0; seed < static_cast<int>(across.size()); ++seed) {
    if (pieces.of[seed] >= 0) continue;
    const int piece = pieces.count();
    pieces.is_open.push_back(false);
    reached.assign(1, seed);
    pieces.of[seed] = piece;
    for (std::size_t next = 0; next < reached.size(); ++next)
      for (const int other : across[reached[next]]) {
        if (other < 0) pieces.is_open[piece] = true;
        if (other < 0 || pieces.of[other] >= 0) continue;
        pieces.of[other] = piece;
        reached.push_back(other);
      }
  }
  return pieces;
}

std::vector<MeshFault> faults(const Mesh& mesh, const std::vector<int>& lines) {
  return Checks(mesh, lines).all();
}

std::string fault(const Mesh& mesh, const std::vector<int>& lines) {
  const std::vector<MeshFault> found = faults(mesh, lines);
  return found.empty() ? std::string() : found.front().text;
}

}  // namespace flyrock
