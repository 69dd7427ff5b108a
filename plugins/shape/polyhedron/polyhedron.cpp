#include <stdexcept>

#include "geometry/hull.h"
#include "plugins/factories.h"
#include "plugins/read_points.h"

namespace flyrock::plugins {

namespace {

std::vector<Vec3> points_of(Params& params) {
  std::vector<Vec3> points = params.points3("points");
  const std::string file = params.text("file");
  if (params.given("points") == params.given("file"))
    throw PluginError("plugin polyhedron: expected either `points` or a `file`");
  if (params.given("file"))
    for (const auto& point : read_points("polyhedron", file, 3))
      points.emplace_back(point[0], point[1], point[2]);
  return points;
}

class Polyhedron : public ShapeModel {
 public:
  explicit Polyhedron(Params& params) {
    params.require_dimension(3);
    try {
      hull_ = convex_hull(points_of(params));
    } catch (const std::invalid_argument& fault) {
      throw PluginError(std::string("plugin polyhedron: ") + fault.what());
    }
  }
  std::vector<Contactor3> build_3d(Values, RandomStream&) const override { return {hull_}; }

 private:
  Contactor3 hull_;
};

}  // namespace

std::unique_ptr<ShapeModel> make_polyhedron(Params& params) { return std::make_unique<Polyhedron>(params); }

}  // namespace flyrock::plugins
