#pragma once
// The instances of a scenario's plugins.

#include <memory>
#include <vector>

#include "plugin/contact_law.h"
#include "plugin/models.h"
#include "scenario/scenario.h"

namespace flyrock {

struct MaterialLaws {
  std::unique_ptr<RestitutionLaw> restitution;
  std::unique_ptr<FrictionLaw> friction;
  std::unique_ptr<RollingLaw> rolling;
  std::unique_ptr<UnilateralLaw> unilateral;
};

struct GroupModels {
  std::unique_ptr<Population> population;
  std::unique_ptr<ShapeModel> shape;      ///< may be absent
  std::unique_ptr<VelocityModel> launch;  ///< may be absent: at rest
};

/// One instance for each use of a plugin. Lua instances belong to the state that registered them, so each
/// worker has its own Instances.
struct Instances {
  explicit Instances(const Scenario& scenario);  ///< throws ScenarioError

  std::unique_ptr<TerrainModel> terrain;
  std::vector<MaterialLaws> materials;              ///< in the order of Scenario::materials
  std::vector<GroupModels> groups;                  ///< of Scenario::rocks
  std::vector<std::unique_ptr<ShapeModel>> bodies;  ///< of Scenario::bodies
};

/// The values of the parameters of a use at `key`.
std::vector<double> values_of(const PluginUse& use, const Scenario& scenario, const DrawKey& key);

}  // namespace flyrock
