// The round shapes: disk and wall in 2D, sphere, pill, cylinder and cone in 3D.

#include <fmt/format.h>

#include <utility>
#include <variant>

#include "geometry/cone.h"
#include "geometry/contactor.h"
#include "plugin/models.h"
#include "plugins/factories.h"
#include "random/stream.h"

namespace flyrock::plugins {

namespace {

/// A shape given by one or two lengths above 0, the parameters `first` and `second` (null: none).
class RoundShape : public ShapeModel {
 public:
  using Make2 = Contactor2(double first, double second);
  using Make3 = Contactor3(double first, double second);

  RoundShape(Params& params, const char* name, const char* first, const char* second,
             std::variant<Make2*, Make3*> make)
      : name_(name),
        first_(first),
        second_(second),
        first_slot_(params.slot(first)),
        second_slot_(second ? params.slot(second) : first_slot_),
        make_(make) {
    params.require_dimension(std::holds_alternative<Make2*>(make) ? 2 : 3);
  }

  std::vector<Contactor2> build(Values values, RandomStream&) const override {
    const auto [first, second] = lengths(values);
    return {std::get<Make2*>(make_)(first, second)};
  }
  std::vector<Contactor3> build_3d(Values values, RandomStream&) const override {
    const auto [first, second] = lengths(values);
    return {std::get<Make3*>(make_)(first, second)};
  }

 private:
  /// Their values; of one length, twice the same.
  std::pair<double, double> lengths(Values values) const {
    const double first = values[first_slot_], second = values[second_slot_];
    if (first > 0 && second > 0) return {first, second};
    throw PluginError(second_
                          ? fmt::format("plugin {}: {} is {:.6g} m and {} {:.6g} m, both must be above 0",
                                        name_, first_, first, second_, second)
                          : fmt::format("plugin {}: {} is {:.6g} m, must be above 0", name_, first_, first));
  }

  const char *name_, *first_, *second_;
  int first_slot_, second_slot_;
  std::variant<Make2*, Make3*> make_;
};

}  // namespace

std::unique_ptr<ShapeModel> make_disk(Params& params) {
  return std::make_unique<RoundShape>(params, "disk", "radius", nullptr,
                                      [](double radius, double) { return Contactor2::disk(radius); });
}
std::unique_ptr<ShapeModel> make_wall(Params& params) {
  return std::make_unique<RoundShape>(params, "wall", "length", "radius", [](double length, double radius) {
    const Vec2 end(length / 2, 0);
    return Contactor2::wall(-end, end, radius);
  });
}
std::unique_ptr<ShapeModel> make_sphere(Params& params) {
  return std::make_unique<RoundShape>(params, "sphere", "radius", nullptr,
                                      [](double radius, double) { return Contactor3::sphere(radius); });
}
std::unique_ptr<ShapeModel> make_pill(Params& params) {
  return std::make_unique<RoundShape>(params, "pill", "length", "radius", [](double length, double radius) {
    const Vec3 end(0, 0, length / 2);
    return Contactor3::pill(-end, end, radius);
  });
}
std::unique_ptr<ShapeModel> make_cylinder(Params& params) {
  return std::make_unique<RoundShape>(params, "cylinder", "radius", "height", &Contactor3::cylinder);
}
std::unique_ptr<ShapeModel> make_cone(Params& params) {
  return std::make_unique<RoundShape>(params, "cone", "radius", "height", &cone);
}

}  // namespace flyrock::plugins
