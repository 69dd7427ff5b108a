#include "geometry/hull.h"

#include <fmt/format.h>
#include <libqhull_r/qhull_ra.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <stdexcept>

namespace flyrock {

namespace {

/// One run of Qhull; its messages are written to memory.
class QhullRun {
 public:
  explicit QhullRun(std::vector<double>& coordinates) {
    messages_ = open_memstream(&text_, &size_);
    qh_zero(&qh_, messages_);
    char command[] = "qhull Pp";  // merges faces of one plane, suppresses warnings
    failed_ = qh_new_qhull(&qh_, 3, static_cast<int>(coordinates.size() / 3), coordinates.data(), False,
                           command, nullptr, messages_) != 0;
  }
  ~QhullRun() {
    qh_freeqhull(&qh_, !qh_ALL);
    int held = 0, total = 0;
    qh_memfreeshort(&qh_, &held, &total);
    std::fclose(messages_);
    std::free(text_);
  }
  QhullRun(const QhullRun&) = delete;
  QhullRun& operator=(const QhullRun&) = delete;

  bool failed() const { return failed_; }

  /// The faces as loops of indices into the points, counter-clockwise seen from outside.
  std::vector<std::vector<int>> faces(const std::vector<Vec3>& points) {
    std::vector<std::vector<int>> loops;
    qhT* qh = &qh_;  // the macros of Qhull need this name
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

 private:
  qhT qh_;
  bool failed_ = false;
  std::FILE* messages_ = nullptr;
  char* text_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace

Contactor3 convex_hull(const std::vector<Vec3>& points) {
  if (points.size() < 4)
    throw std::invalid_argument(
        fmt::format("a polyhedron has {} points, at least 4 are needed", points.size()));
  // Coordinates relative to the first point, so that a rock drawn far from the origin loses no digits.
  std::vector<double> coordinates;
  for (const Vec3& p : points)
    for (const double c : Vec3(p - points[0])) coordinates.push_back(c);
  QhullRun run(coordinates);
  if (run.failed()) throw std::invalid_argument("the points of a polyhedron lie in one plane");
  std::vector<std::vector<int>> faces = run.faces(points);
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

}  // namespace flyrock
