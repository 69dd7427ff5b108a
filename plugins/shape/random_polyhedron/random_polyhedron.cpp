#include <fmt/format.h>

#include <cmath>

#include "geometry/hull.h"
#include "geometry/volume_properties.h"
#include "plugin/models.h"
#include "plugins/factories.h"
#include "random/stream.h"

namespace flyrock::plugins {

namespace {

constexpr double thinnest = 0.05;

/// Points on the unit sphere, evenly spaced along a spiral (Fibonacci lattice). Each point is moved by a
/// random vector of at most `irregularity` times half the distance between neighbours, and then projected
/// back onto the sphere.
std::vector<Vec3> points_on_sphere(int count, double irregularity, RandomStream& rng) {
  const double golden_angle = pi * (3 - std::sqrt(5.0)), half_distance = 0.5 * std::sqrt(4 * pi / count);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count, r = std::sqrt(1 - z * z), angle = golden_angle * i;
    // A random vector in a ball: the direction from height and longitude, the radius from a cube root.
    const double height = rng.uniform(-1, 1), longitude = rng.uniform(0, 2 * pi);
    const double across = std::sqrt(1 - height * height),
                 length = irregularity * half_distance * std::cbrt(rng.uniform());
    const Vec3 move = length * Vec3(across * std::cos(longitude), across * std::sin(longitude), height);
    points.push_back((Vec3(r * std::cos(angle), r * std::sin(angle), z) + move).normalized());
  }
  return points;
}

class RandomPolyhedron : public ShapeModel {
 public:
  explicit RandomPolyhedron(Params& params)
      : vertices_(params.slot("vertices")),
        diameter_(params.slot("diameter")),
        irregularity_(params.slot("irregularity")),
        elongation_(params.slot("elongation")),
        flatness_(params.slot("flatness")) {
    params.require_dimension(3);
  }

  std::vector<Contactor3> build_3d(Values values, RandomStream& rng) const override {
    const double vertices = values[vertices_], diameter = values[diameter_],
                 irregularity = values[irregularity_];
    const double elongation = values[elongation_], flatness = values[flatness_];
    require(vertices >= 6 && vertices <= 100, "vertices", vertices, "from 6 to 100");
    require(diameter > 0, "diameter", diameter, "above 0 m");
    require(irregularity >= 0 && irregularity <= 1, "irregularity", irregularity, "from 0 to 1");
    require(elongation >= thinnest && elongation <= 1, "elongation", elongation, "from 0.05 to 1");
    require(flatness >= thinnest && flatness <= 1, "flatness", flatness, "from 0.05 to 1");

    std::vector<Vec3> points = points_on_sphere(static_cast<int>(std::lround(vertices)), irregularity, rng);
    for (Vec3& p : points) p = p.cwiseProduct(Vec3(1, elongation, elongation * flatness));
    Contactor3 hull = convex_hull(points);
    const double volume = volume_properties({hull}).volume;
    hull.scale(diameter * std::cbrt(pi / 6 / volume));
    return {hull};
  }

 private:
  static void require(bool fine, const char* name, double value, const char* expected) {
    if (!fine)
      throw PluginError(
          fmt::format("plugin random_polyhedron: {} is {:.6g}, must be {}", name, value, expected));
  }

  int vertices_, diameter_, irregularity_, elongation_, flatness_;
};

}  // namespace

std::unique_ptr<ShapeModel> make_random_polyhedron(Params& params) {
  return std::make_unique<RandomPolyhedron>(params);
}

}  // namespace flyrock::plugins
