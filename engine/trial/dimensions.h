#pragma once
// What differs between trials in 2D and in 3D.

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "flight/ground.h"
#include "geometry/terrain_place.h"
#include "plugin/models.h"
#include "plugin/terrain_view.h"
#include "scenario/ground_store.h"
#include "trial/instances.h"
#include "trial/make_ground.h"
#include "trial/place_rock.h"
#include "trial/start_checks.h"

namespace flyrock {

/// The shape of a terrain, built now or left by the reader of the scenario.
inline TerrainShape3 shape_of(const TerrainModel& model, const std::vector<double>& values,
                              const TerrainPlan& plan, RandomStream& rng) {
  if (plan.grounds)
    if (const auto left = std::static_pointer_cast<TerrainShape3>(plan.grounds->take(plan.text)))
      return std::move(*left);
  return model.build_3d(values, rng);
}

inline Terrain2 make_terrain(const TerrainModel& model, const PluginUse& use, const Scenario& scenario,
                             const DrawKey& key, RandomStream& rng, const Terrain2*) {
  const std::vector<double> values = values_of(use, scenario, key);
  const auto& section = scenario.terrain.section;
  if (!section) return profile_ground(model.build(values, rng), scenario.terrain);
  try {
    return profile_ground(
        section_of(shape_of(model, values, scenario.terrain, rng), section->from, section->to),
        scenario.terrain);
  } catch (const SectionError& error) {
    throw PluginError(fmt::format("plugin {}: {}", use.plugin->spec.name, error.what()));
  }
}
inline Terrain3 make_terrain(const TerrainModel& model, const PluginUse& use, const Scenario& scenario,
                             const DrawKey& key, RandomStream& rng, const Terrain3*) {
  return shaped_ground(shape_of(model, values_of(use, scenario, key), scenario.terrain, rng),
                       scenario.terrain);
}

/// About how much memory a terrain takes.
inline std::size_t bytes_of(const Terrain2& terrain) {
  return static_cast<std::size_t>(terrain.segments()) * 200;
}
inline std::size_t bytes_of(const Terrain3& terrain) { return terrain.bytes(); }

/// The ground as plugins see it.
inline TerrainView view_of(const Terrain2& terrain, const TerrainPlan&) {
  return TerrainView(terrain.profile());
}
inline TerrainView view_of(const Terrain3& terrain, const TerrainPlan& plan) {
  return {terrain.ground(), terrain.faces(), plan.origin, plan.north};
}

template <int D>
std::vector<RockPlan<D>> rocks_of(const Population& population, const std::vector<double>& values,
                                  const TerrainView& terrain, const Blast& blast, RandomStream& rng) {
  if constexpr (D == 2)
    return population.rocks(values, terrain, blast, rng);
  else
    return population.rocks_3d(values, terrain, blast, rng);
}

/// The angle of v above the outward horizontal in 2D, where a launch may go back over the crest. In 3D the
/// angle above the horizontal.
inline double elevation_of(const Vec2& v, const Vec3& outward) {
  return std::atan2(v.y(), v.x() * outward.x());
}
inline double elevation_of(const Vec3& v, const Vec3&) { return std::atan2(v.z(), v.head<2>().norm()); }

template <int D>
ShapeAnswer<D> ask_shape(const ShapeModel& model, const std::vector<double>& values, RandomStream& rng) {
  ShapeAnswer<D> shape;
  if constexpr (D == 2)
    shape = model.shape(values, rng);
  else
    shape = model.shape_3d(values, rng);
  if (const std::string wrong = fault(shape.own); !wrong.empty())
    throw PluginError("the shape answered " + wrong);
  return shape;
}

/// A spin from its components: one in 2D, three in 3D.
template <int D, class Component>
typename Space<D>::Spin spin_of(Component component) {
  if constexpr (D == 2)
    return component(0);
  else
    return {component(0), component(1), component(2)};
}

}  // namespace flyrock
