#include "geometry/delaunay.h"

#include <algorithm>
#include <stdexcept>

#include "geometry/qhull_run.h"

namespace flyrock {

namespace {

std::vector<std::array<int, 3>> triangles_of(QhullRun& run) {
  std::vector<std::array<int, 3>> list;
  qhT* qh = run.get();  // the macros of Qhull need this name
  for (facetT* facet = qh->facet_list; facet && facet->next; facet = facet->next) {
    if (facet->upperdelaunay || qh_setsize(qh, facet->vertices) != 3) continue;
    std::array<int, 3> triangle{};
    for (int i = 0; i < 3; ++i)
      triangle[static_cast<std::size_t>(i)] =
          qh_pointid(qh, static_cast<vertexT*>(SETelem_(facet->vertices, i))->point);
    list.push_back(triangle);
  }
  return list;
}

}  // namespace

std::vector<std::array<int, 3>> delaunay(const std::vector<Vec2>& points) {
  if (points.size() < 3) throw std::invalid_argument("a triangulation has at least three points");
  std::vector<double> coordinates;
  for (const Vec2& p : points) coordinates.insert(coordinates.end(), {p.x(), p.y()});
  // Delaunay, with scaled paraboloid, a point at infinity for points on a circle, and triangles only.
  QhullRun run(coordinates, 2, "qhull d Qbb Qc Qz Qt Pp");
  if (run.failed()) throw std::invalid_argument("the points to triangulate lie in a line");
  std::vector<std::array<int, 3>> triangles = triangles_of(run);
  for (auto& [a, b, c] : triangles)
    if (cross(Vec2(points[b] - points[a]), Vec2(points[c] - points[a])) < 0) std::swap(b, c);
  std::sort(triangles.begin(), triangles.end());  // the order of Qhull is its own affair
  return triangles;
}

}  // namespace flyrock
