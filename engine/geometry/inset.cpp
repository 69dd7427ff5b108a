#include "geometry/inset.h"

#include <algorithm>

namespace flyrock {

namespace {

/// Where a corner moves to, if the sides move inwards by 1.
Vec2 shift_of(const std::vector<Vec2>& vertices, std::size_t i) {
  const std::size_t count = vertices.size();
  const Vec2 in = (vertices[i] - vertices[(i + count - 1) % count]).normalized();
  const Vec2 out = (vertices[(i + 1) % count] - vertices[i]).normalized();
  return perpendicular(in + out) / (1 + in.dot(out));
}

}  // namespace

double greatest_inset(const std::vector<Vec2>& vertices) {
  double least = 1e300;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const std::size_t next = (i + 1) % vertices.size();
    const Vec2 along = vertices[next] - vertices[i];
    const double lost = (shift_of(vertices, i) - shift_of(vertices, next)).dot(along.normalized());
    least = std::min(least, along.norm() / lost);
  }
  return least;
}

std::vector<Vec2> inset(const std::vector<Vec2>& vertices, double by) {
  std::vector<Vec2> moved;
  for (std::size_t i = 0; i < vertices.size(); ++i) moved.push_back(vertices[i] + by * shift_of(vertices, i));
  return moved;
}

}  // namespace flyrock
