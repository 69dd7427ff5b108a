#include "survey/face_survey.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "geometry/delaunay.h"
#include "geometry/mesh_edges.h"

namespace flyrock {

namespace {

/// The place of a triangle nearest to p, by its barycentric weights. Source: C. Ericson, Real-Time Collision
/// Detection, 2005, 5.1.5.
Vec3 nearest_weights(const std::array<Vec3, 3>& corner, const Vec3& p) {
  const Vec3 ab = corner[1] - corner[0], ac = corner[2] - corner[0], ap = p - corner[0];
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  const Vec3 bp = p - corner[1];
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
  const Vec3 cp = p - corner[2];
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6) {
    const double share = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - share, share};
  }
  const double sum = va + vb + vc;
  return {va / sum, vb / sum, vc / sum};
}

Vec3 at_weights(const std::array<Vec3, 3>& corner, const Vec3& weights) {
  return weights.x() * corner[0] + weights.y() * corner[1] + weights.z() * corner[2];
}

/// Whether a segment goes through a triangle.
bool pierces(const std::array<Vec3, 3>& corner, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a, e1 = corner[1] - corner[0], e2 = corner[2] - corner[0];
  const Vec3 h = along.cross(e2);
  const double det = e1.dot(h);
  if (det == 0) return false;  // parallel: the ends or the sides are nearest
  const Vec3 s = a - corner[0];
  const double u = s.dot(h) / det;
  const Vec3 q = s.cross(e1);
  const double v = along.dot(q) / det, t = e2.dot(q) / det;
  return u >= 0 && v >= 0 && u + v <= 1 && t >= 0 && t <= 1;
}

double distance_of(const std::array<Vec3, 3>& corner, const Vec3& a, const Vec3& b) {
  if (pierces(corner, a, b)) return 0;
  double least = std::min((a - at_weights(corner, nearest_weights(corner, a))).norm(),
                          (b - at_weights(corner, nearest_weights(corner, b))).norm());
  for (std::size_t k = 0; k < 3; ++k)
    least = std::min(least, segment_distance(a, b, corner[k], corner[(k + 1) % 3]));
  return least;
}

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The triangles without a side much longer than the others.
std::vector<std::array<int, 3>> without_gaps(const std::vector<Vec3>& points,
                                             std::vector<std::array<int, 3>> triangles) {
  constexpr double most_sides = 5;
  const auto longest = [&](const std::array<int, 3>& t) {
    double side = 0;
    for (std::size_t k = 0; k < 3; ++k) side = std::max(side, (points[t[k]] - points[t[(k + 1) % 3]]).norm());
    return side;
  };
  std::vector<double> sides;
  for (const auto& triangle : triangles) sides.push_back(longest(triangle));
  const double limit = most_sides * median_of(sides);
  std::erase_if(triangles, [&](const std::array<int, 3>& triangle) { return longest(triangle) > limit; });
  return triangles;
}

/// Points in the plane that fits them best.
std::vector<Vec2> flattened(const std::vector<Vec3>& points) {
  Vec3 centre = Vec3::Zero();
  for (const Vec3& p : points) centre += p / static_cast<double>(points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vec3& p : points) spread += (p - centre) * (p - centre).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  std::vector<Vec2> in_plane;
  for (const Vec3& p : points)
    in_plane.emplace_back(axes.eigenvectors().col(2).dot(p - centre),
                          axes.eigenvectors().col(1).dot(p - centre));
  return in_plane;
}

/// The residual of a place against the plane z = a + b x + c y through others, in units of its standard
/// deviation if all have the same error; nothing if the others lie in a line.
bool residual_of(const Vec3& place, const std::vector<Vec3>& others, double& residual) {
  if (others.size() < 4) return false;
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  Vec3 right = Vec3::Zero();
  for (const Vec3& p : others) {
    const Vec3 row(1, p.x() - place.x(), p.y() - place.y());
    moments += row * row.transpose();
    right += row * (p.z() - place.z());
  }
  const Eigen::LDLT<Eigen::Matrix3d> solver(moments);
  if (solver.rcond() < 1e-9) return false;
  const double spread = 1 + solver.solve(Vec3::UnitX()).x();
  residual = solver.solve(right).x() / std::sqrt(spread);
  return true;
}

}  // namespace

double segment_distance(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = b - a, v = d - c, w = a - c;
  const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), det = uu * vv - uv * uv;
  double least = std::min({distance_to_segment(a, c, d), distance_to_segment(b, c, d),
                           distance_to_segment(c, a, b), distance_to_segment(d, a, b)});
  if (det > 1e-12 * uu * vv) {
    const double s = (uv * v.dot(w) - vv * u.dot(w)) / det, t = (uu * v.dot(w) - uv * u.dot(w)) / det;
    if (s >= 0 && s <= 1 && t >= 0 && t <= 1) least = std::min(least, (w + s * u - t * v).norm());
  }
  return least;
}

FaceSurvey::FaceSurvey(const Mesh& mesh) {
  const Mesh joined = welded(mesh);
  take(joined.vertices, joined.triangles);
}

FaceSurvey::FaceSurvey(const std::vector<Vec3>& points) {
  if (points.size() < 3) throw std::invalid_argument("a face has at least three points");
  take(points, without_gaps(points, delaunay(flattened(points))));
}

void FaceSurvey::take(const std::vector<Vec3>& vertices, const std::vector<std::array<int, 3>>& triangles) {
  const auto neighbours = neighbours_of(triangles, sorted_sides(triangles));
  std::vector<bool> on_border(vertices.size(), false);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      if (neighbours[t][k] < 0) on_border[triangles[t][k]] = on_border[triangles[t][(k + 1) % 3]] = true;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    Triangle& triangle = triangles_.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      triangle.corner[k] = vertices[triangles[t][k]];
      triangle.is_border[k] = neighbours[t][k] < 0;
      triangle.is_end[k] = on_border[triangles[t][k]];
    }
    triangle.centre = (triangle.corner[0] + triangle.corner[1] + triangle.corner[2]) / 3;
    triangle.radius = 0;
    for (const Vec3& corner : triangle.corner)
      triangle.radius = std::max(triangle.radius, (corner - triangle.centre).norm());
  }
  vertices_ = vertices.size();
  measure_noise(vertices, triangles, on_border);
}

void FaceSurvey::measure_noise(const std::vector<Vec3>& vertices,
                               const std::vector<std::array<int, 3>>& triangles,
                               const std::vector<bool>& on_border) {
  std::vector<std::vector<int>> around(vertices.size());
  for (const auto& triangle : triangles)
    for (std::size_t k = 0; k < 3; ++k) around[triangle[k]].push_back(triangle[(k + 1) % 3]);
  std::vector<double> residuals;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (on_border[v] || around[v].size() < 4) continue;
    // In a frame whose third axis is normal to the face there.
    Vec3 centre = Vec3::Zero();
    for (const int other : around[v]) centre += vertices[other] / static_cast<double>(around[v].size());
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const int other : around[v])
      spread += (vertices[other] - centre) * (vertices[other] - centre).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
    const auto local = [&](const Vec3& p) -> Vec3 {
      return {axes.eigenvectors().col(2).dot(p), axes.eigenvectors().col(1).dot(p),
              axes.eigenvectors().col(0).dot(p)};
    };
    std::vector<Vec3> others;
    for (const int other : around[v]) others.push_back(local(vertices[other] - vertices[v]));
    double residual = 0;
    if (residual_of(Vec3::Zero(), others, residual)) residuals.push_back(std::abs(residual));
  }
  constexpr std::size_t least_residuals = 20;
  constexpr double normal_share = 1.4826;  // standard deviation over the median of |x| of a normal x
  if (residuals.size() >= least_residuals) noise_ = normal_share * median_of(residuals);
}

FaceSurvey::Nearest FaceSurvey::nearest(const Vec3& place) const {
  Nearest nearest{infinite, false};
  for (const Triangle& triangle : triangles_) {
    if ((place - triangle.centre).norm() - triangle.radius > nearest.distance) continue;
    const Vec3 weights = nearest_weights(triangle.corner, place);
    const double distance = (place - at_weights(triangle.corner, weights)).norm();
    constexpr double rounding = 1e-9;
    bool is_inside = true;
    for (std::size_t k = 0; k < 3; ++k) {
      if (weights[static_cast<int>((k + 2) % 3)] < rounding && triangle.is_border[k]) is_inside = false;
      if (weights[static_cast<int>(k)] > 1 - rounding && triangle.is_end[k]) is_inside = false;
    }
    if (distance < nearest.distance) nearest = {distance, is_inside};
  }
  return nearest;
}

double FaceSurvey::distance_to(const std::vector<Vec3>& line) const {
  double least = infinite;
  for (std::size_t i = 1; i < line.size(); ++i)
    for (const Triangle& triangle : triangles_)
      if (distance_to_segment(triangle.centre, line[i - 1], line[i]) - triangle.radius < least)
        least = std::min(least, distance_of(triangle.corner, line[i - 1], line[i]));
  return least;
}

double FaceSurvey::error_of_least() const {
  return vertices_ > 1 ? noise_ * (1 + std::sqrt(2 * std::log(static_cast<double>(vertices_)))) : 0;
}

}  // namespace flyrock
