#include "geometry/delaunay.h"

#include <libqhull_r/qhull_ra.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

namespace flyrock {

namespace {

/// One Delaunay run of Qhull; its messages are written to memory.
class QhullTriangulation {
 public:
  explicit QhullTriangulation(std::vector<double>& coordinates) {
    messages_ = open_memstream(&text_, &size_);
    qh_zero(&qh_, messages_);
    // Delaunay, with scaled paraboloid, a point at infinity for points on a circle, and triangles only.
    char command[] = "qhull d Qbb Qc Qz Qt Pp";
    failed_ = qh_new_qhull(&qh_, 2, static_cast<int>(coordinates.size() / 2), coordinates.data(), False,
                           command, nullptr, messages_) != 0;
  }
  ~QhullTriangulation() {
    qh_freeqhull(&qh_, !qh_ALL);
    int held = 0, total = 0;
    qh_memfreeshort(&qh_, &held, &total);
    std::fclose(messages_);
    std::free(text_);
  }
  QhullTriangulation(const QhullTriangulation&) = delete;
  QhullTriangulation& operator=(const QhullTriangulation&) = delete;

  bool failed() const { return failed_; }

  std::vector<std::array<int, 3>> triangles() {
    std::vector<std::array<int, 3>> list;
    qhT* qh = &qh_;  // the macros of Qhull need this name
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

 private:
  qhT qh_;
  bool failed_ = false;
  std::FILE* messages_ = nullptr;
  char* text_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace

std::vector<std::array<int, 3>> delaunay(const std::vector<Vec2>& points) {
  if (points.size() < 3) throw std::invalid_argument("a triangulation has at least three points");
  std::vector<double> coordinates;
  for (const Vec2& p : points) coordinates.insert(coordinates.end(), {p.x(), p.y()});
  QhullTriangulation run(coordinates);
  if (run.failed()) throw std::invalid_argument("the points to triangulate lie in a line");
  std::vector<std::array<int, 3>> triangles = run.triangles();
  for (auto& [a, b, c] : triangles)
    if (cross(Vec2(points[b] - points[a]), Vec2(points[c] - points[a])) < 0) std::swap(b, c);
  std::sort(triangles.begin(), triangles.end());  // the order of Qhull is its own affair
  return triangles;
}

}  // namespace flyrock
