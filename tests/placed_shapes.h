#pragma once
// Shapes of about 1 m, for the tests and the benchmark of pairs.

#include <string>
#include <vector>

#include "collision/geometry.h"
#include "conformance/plugin_use.h"
#include "dice.h"
#include "plugin/models.h"

namespace flyrock {

/// How far a contactor reaches along a direction, in its frame [m].
inline double reach(const Contactor2& shape, const Vec2& direction) {
  double most = -1e300;
  for (const Vec2& point : shape.points) most = std::max(most, direction.dot(point));
  return most + shape.radius;
}
inline double reach(const Contactor3& shape, const Vec3& direction) {
  double most = -1e300;
  for (const Vec3& point : shape.points) most = std::max(most, direction.dot(point));
  for (const Contactor3::Circle& circle : shape.circles)
    most = std::max(most, direction.dot(circle.centre) + circle.radius * circle.across(direction).norm());
  return most + shape.radius;
}

template <int D>
struct Named {
  std::string name;
  typename Geometry<D>::Contactor contactor;
};

/// The first contactor of a registered shape with these parameters.
template <int D>
Named<D> named_shape(const LuaSession& session, const std::string& name,
                     const std::map<std::string, Given>& given) {
  const auto made = make<ShapeModel>(session, PluginKind::shape, name, given, D);
  RandomStream rng(3, "shape", {});
  if constexpr (D == 2)
    return {name, made.model->shape(made.values, rng).contactors.front()};
  else
    return {name, made.model->shape_3d(made.values, rng).contactors.front()};
}

/// Every solid shape that has a size, about 1 m large.
template <int D>
std::vector<Named<D>> solid_shapes(const LuaSession& session) {
  if constexpr (D == 2)
    return {named_shape<2>(session, "disk", {{"radius", 0.4}}),
            named_shape<2>(session, "wall", {{"length", 0.8}, {"radius", 0.1}}),
            named_shape<2>(session, "polygon", {{"sides", 6.0}, {"diameter", 0.9}}),
            {"rounded polygon",
             named_shape<2>(session, "polygon", {{"sides", 5.0}, {"diameter", 0.9}, {"rounding", 0.1}})
                 .contactor}};
  else
    return {named_shape<3>(session, "sphere", {{"radius", 0.4}}),
            named_shape<3>(session, "pill", {{"length", 0.6}, {"radius", 0.2}}),
            named_shape<3>(session, "box", {{"size", std::vector<double>{0.8, 0.5, 0.6}}}),
            named_shape<3>(session, "random_polyhedron", {{"diameter", 0.9}}),
            named_shape<3>(session, "eota111", {{"length", 0.8}}),
            named_shape<3>(session, "eota221", {{"length", 0.8}}),
            named_shape<3>(session, "cylinder", {{"radius", 0.4}, {"height", 0.5}}),
            named_shape<3>(session, "cone", {{"radius", 0.4}, {"height", 0.7}})};
}

}  // namespace flyrock
