#include "geometry/hull.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "geometry/qhull_run.h"

namespace flyrock {

namespace {

/// The faces as loops of indices into the points, counter-clockwise seen from outside.
std::vector<std::vector<int>> faces_of(QhullRun& run, const std::vector<Vec3>& points) {
  std::vector<std::vector<int>> loops;
  qhT* qh = run.get();  // the macros of Qhull need this name
  for (facetT* facet = qh->facet_list; facet && facet->next; facet = facet->next) {
    setT* vertices = qh_facet3vertex(qh, facet);
    std::vector<int> loop;
    for (int i = 0; i < qh_setsize(qh, vertices); ++i)
      loop.push_back(qh_pointid(qh, static_cast<vertexT*>(SETelem_(vertices, i))->point));
    qh_settempfree(qh, &vertices);
    const Vec3 outward(facet->normal[0], facet->normal[1], facet->normal[2]);
    const Vec3 &a = points[loop[0]], &b = points[loop[1]], &c = points[loop[2]];
    if ((b - a).cross(c - a).dot(outward) < 0) std::reverse(loop.begin(), loop.end());
    loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace

Contactor3 convex_hull(const std::vector<Vec3>& points) {
  if (points.size() < 4)
    throw std::invalid_argument(
        fmt::format("a polyhedron has {} points, at least 4 are needed", points.size()));
  // Coordinates relative to the first point, so that a rock drawn far from the origin loses no digits.
  std::vector<double> coordinates;
  for (const Vec3& p : points)
    for (const double c : Vec3(p - points[0])) coordinates.push_back(c);
  QhullRun run(coordinates, 3, "qhull Pp");  // merges faces of one plane, suppresses warnings
  if (run.failed()) throw std::invalid_argument("the points of a polyhedron lie in one plane");
  std::vector<std::vector<int>> faces = faces_of(run, points);
  std::map<int, int> kept;  // from the index of a point to the index of a vertex, in the order of the points
  for (const auto& loop : faces)
    for (const int i : loop) kept[i] = 0;
  std::vector<Vec3> vertices;
  for (auto& [point, vertex] : kept) {
    vertex = static_cast<int>(vertices.size());
    vertices.push_back(points[point]);
  }
  for (auto& loop : faces)
    for (int& i : loop) i = kept[i];
  return Contactor3::polyhedron(std::move(vertices), faces);
}

Contactor3 norm_block(const Vec3& sides) {
  std::vector<Vec3> corners;
  for (int axis = 0; axis < 3; ++axis)
    for (int corner = 0; corner < 8; ++corner) {
      Vec3 p = Vec3::Constant(0.25);
      p[axis] = 0.5;
      for (int k = 0; k < 3; ++k)
        if (corner >> k & 1) p[k] = -p[k];
      corners.push_back(p.cwiseProduct(sides));
    }
  return convex_hull(corners);
}

}  // namespace flyrock
