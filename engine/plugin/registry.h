#pragma once
// The plugins that a run can use. The run owns its registry; there are no globals.

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "plugin/params.h"

namespace flyrock {

// The interfaces of the kinds: plugin/contact_law.h has the laws, plugin/models.h the others.
class ShapeModel;
class Population;
class RestitutionLaw;
class FrictionLaw;
class RollingLaw;
class UnilateralLaw;
class VelocityModel;
class TerrainModel;

template <class Interface>
using FactoryOf = std::function<std::unique_ptr<Interface>(Params&)>;

/// Makes an instance from parameters. Throws PluginError.
using Factory = std::variant<FactoryOf<ShapeModel>, FactoryOf<Population>, FactoryOf<RestitutionLaw>,
                             FactoryOf<FrictionLaw>, FactoryOf<RollingLaw>, FactoryOf<UnilateralLaw>,
                             FactoryOf<VelocityModel>, FactoryOf<TerrainModel>>;

/// Factories by kind and name, filled by a module (plugin/module.h).
using FactoryTable = std::map<std::pair<PluginKind, std::string>, Factory>;

struct Plugin {
  PluginSpec spec;
  Factory make;
};

class Registry {
 public:
  /// Adds a plugin. Returns an error text if one of the same kind and name exists, otherwise an empty text.
  std::string add(Plugin plugin);
  std::size_t size() const { return plugins_.size(); }
  const Plugin* find(PluginKind kind, std::string_view name) const;
  /// The plugins of one kind, sorted by name.
  std::vector<const Plugin*> of_kind(PluginKind kind) const;
  std::vector<std::string> names(PluginKind kind) const;

 private:
  std::map<std::pair<PluginKind, std::string>, std::unique_ptr<Plugin>> plugins_;
};

/// A plugin with its decoded parameters, as a scenario uses it.
struct PluginUse {
  const Plugin* plugin = nullptr;
  std::vector<ParamValue> values;
  std::vector<Number> slots;  ///< dense_slots of the values
  std::string path;           ///< in the scenario: "materials.haul_floor.restitution"
};

/// One element of a parameter of type shapes: a shape, and where it is in the frame of the whole,
///   x = at + R(turn) x_of_the_shape.
/// Its slots are: the components of `at` [m]; the turn, in 2D an angle [rad], in 3D a quaternion [w, x, y, z]
/// or, if `about_axis`, an axis and an angle [rad] (plugin/turn.h); then those of the shape's parameters.
struct ShapePart {
  PluginUse shape;
  bool about_axis = false;

  /// The number of slots before those of the shape.
  static constexpr std::size_t place_slots(int dimension) { return dimension == 2 ? 3 : 7; }
};

/// Makes an instance, and checks that it has read all parameters that its plugin declares. The caller
/// includes the header of the interface.
template <class Interface>
std::unique_ptr<Interface> make_instance(const PluginUse& use, int dimension) {
  Params params(use.plugin->spec, use.values, dimension);
  if (use.plugin->spec.dimension) params.require_dimension(use.plugin->spec.dimension);
  auto instance = std::get<FactoryOf<Interface>>(use.plugin->make)(params);
  if (auto unread = params.unread(); !unread.empty())
    throw PluginError("plugin " + use.plugin->spec.name + ": declares the parameter `" + unread.front() +
                      "` and does not read it");
  return instance;
}

}  // namespace flyrock
