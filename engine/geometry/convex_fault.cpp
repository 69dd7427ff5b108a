#include "geometry/convex_fault.h"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/mesh_edges.h"
#include "geometry/place_text.h"
#include "geometry/volume_properties.h"

namespace flyrock {

namespace {

/// Shares of the size and of the volume: coordinates in single precision, as STL has them, stay within.
constexpr double depth_share = 1e-6, volume_share = 1e-5;

const Vec3& corner(const Mesh& mesh, int triangle, int k) {
  return mesh.vertices[mesh.triangles[triangle][k]];
}

std::string line_text(const std::vector<int>& lines, int triangle) {
  return lines.empty() ? "" : fmt::format(" in line {}", lines[triangle]);
}

std::string flat_triangle(const Mesh& mesh, const std::vector<int>& lines) {
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const Vec3 a = corner(mesh, t, 1) - corner(mesh, t, 0), b = corner(mesh, t, 2) - corner(mesh, t, 0);
    if (a.cross(b).norm() > 1e-12 * std::max(a.squaredNorm(), b.squaredNorm())) continue;
    return fmt::format("the triangle {}, {}, {}{} has no area", place_text(corner(mesh, t, 0)),
                       place_text(corner(mesh, t, 1)), place_text(corner(mesh, t, 2)), line_text(lines, t));
  }
  return {};
}

std::string open_edge(const Mesh& mesh) {
  const std::vector<MeshSide> sides = sorted_sides(mesh.triangles);
  for (std::size_t i = 0; i < sides.size(); i += 2) {
    std::size_t end = i;
    while (end < sides.size() && sides[end].same_edge(sides[i])) ++end;
    const std::string edge = fmt::format("the edge from {} to {}", place_text(mesh.vertices[sides[i].low]),
                                         place_text(mesh.vertices[sides[i].high]));
    if (end - i != 2)
      return fmt::format("{} has {} triangle{}, expected two: a surface that closes", edge, end - i,
                         end - i == 1 ? "" : "s");
    if (sides[i].forward == sides[i + 1].forward)
      return edge + " has triangles that face opposite ways, expected all to face outwards";
  }
  return {};
}

double volume_of(const Mesh& mesh) {
  const Vec3& origin = mesh.vertices.front();
  double six = 0;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
    six +=
        (corner(mesh, t, 0) - origin).dot((corner(mesh, t, 1) - origin).cross(corner(mesh, t, 2) - origin));
  return six / 6;
}

/// How far a place lies inside of a hull.
double depth_in(const Contactor3& hull, const Vec3& place) {
  double depth = 1e300;
  for (const Contactor3::Face& face : hull.faces)
    depth = std::min(depth, face.normal.dot(hull.points[hull.vertex(face, 0)] - place));
  return depth;
}

}  // namespace

std::string convex_fault(const Mesh& mesh, const Contactor3& hull, const std::vector<int>& lines) {
  if (std::string found = flat_triangle(mesh, lines); !found.empty()) return found;
  if (std::string found = open_edge(mesh); !found.empty()) return found;
  const double volume = volume_of(mesh), hull_volume = volume_properties({hull}).volume;
  if (volume <= 0)
    return "its faces look inwards, expected their corners counter-clockwise, seen from outside";
  double size = 0, deepest = 0;
  const Vec3* dent = nullptr;
  for (const Vec3& place : mesh.vertices) {
    size = std::max(size, (place - mesh.vertices.front()).norm());
    if (const double depth = depth_in(hull, place); depth > deepest) {
      deepest = depth;
      dent = &place;
    }
  }
  if (deepest > depth_share * size)
    return fmt::format("it is not convex: its vertex {} lies {:.3g} m inside the hull of the others",
                       place_text(*dent), deepest);
  if (volume < hull_volume * (1 - volume_share))
    return fmt::format("it is not convex: it encloses {:.6g} m3 and the hull of its vertices {:.6g} m3",
                       volume, hull_volume);
  return {};
}

}  // namespace flyrock
