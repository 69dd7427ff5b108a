#include "trial/instances.h"

#include "trial/scenario_error.h"

namespace flyrock {

namespace {

template <class Interface>
std::unique_ptr<Interface> make(const PluginUse& use, int dimension) {
  return at_path(use.path, [&] { return make_instance<Interface>(use, dimension); });
}

template <class Interface>
void make(std::unique_ptr<Interface>& instance, const std::optional<PluginUse>& use, int dimension) {
  if (use) instance = make<Interface>(*use, dimension);
}

}  // namespace

Instances::Instances(const Scenario& scenario) {
  const int dimension = scenario.dimension;
  terrain = make<TerrainModel>(scenario.terrain.model, scenario.terrain.section ? 3 : dimension);
  for (const Material& material : scenario.materials) {
    MaterialLaws& laws = materials.emplace_back();
    make(laws.restitution, material.restitution, dimension);
    make(laws.friction, material.friction, dimension);
    make(laws.rolling, material.rolling, dimension);
    make(laws.unilateral, material.unilateral, dimension);
  }
  for (const RockGroup& group : scenario.rocks) {
    GroupModels& models = groups.emplace_back();
    models.population = make<Population>(group.population, dimension);
    make(models.shape, group.shape, dimension);
    make(models.launch, group.launch, dimension);
  }
  for (const BodyPlan& body : scenario.bodies) bodies.push_back(make<ShapeModel>(body.shape, dimension));
}

std::vector<double> values_of(const PluginUse& use, const Scenario& scenario, const DrawKey& key) {
  std::vector<double> values;
  values.reserve(use.slots.size());
  for (const Number& number : use.slots)
    values.push_back(number.value(scenario.draws, scenario.streams, key));
  return values;
}

}  // namespace flyrock
