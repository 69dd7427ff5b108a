#pragma once
// The surfaces of one world: the laws by which its bodies meet the terrain and each other.

#include <deque>
#include <string>
#include <vector>

#include "trial/instances.h"
#include "world/manifold.h"
#include "world/world.h"

namespace flyrock {

/// What decides how a body of a world meets others.
struct Partner {
  std::string name;   ///< of its group of rocks, or its own in `bodies`
  int material = -1;  ///< that it shows: index into Scenario::materials; -1: none
  DrawKey key;        ///< of its draws
};

/// One Surface for each body and part of the terrain, and one for each pair of bodies, so that each pair has
/// draws and a memory of its own; only the laws are shared. The surface of two bodies is made when they first
/// come near each other: of the pairs of many rocks few ever meet. What is drawn belongs to the body with the
/// lower index. Stays where it is: the world points into it. The scenario and the instances outlive it.
class Surfaces {
 public:
  /// `partners`: of the bodies of the world, in their order.
  Surfaces(const Scenario& scenario, const Instances& instances, std::vector<Partner> partners);
  Surfaces(const Surfaces&) = delete;

  /// Binds the bodies of `world`. Throws StartError where two of them can meet and nothing says how.
  template <int D>
  void connect(World<D>& world);

  /// The index of the material between two bodies of the world; throws PluginError where nothing says which.
  int material_between(int a, int b) const { return material_between(partners_[a], partners_[b]); }
  /// The same between a body and a part of the terrain, by the part's index; -1: none is said.
  template <int D>
  int material_with_terrain(const World<D>& world, int body, int part) const {
    const auto& terrain = world.terrain();
    return material_of_part(partners_[body].name, parts_of(terrain)[part], terrain.names()[part]);
  }
  const DrawKey& key_of(int body) const { return partners_[body].key; }

  /// Adds how often the laws of each material were asked.
  void add_use(std::vector<MaterialUse>& of_material) const;

 private:
  Surface* make(int material, const DrawKey& key);
  int material_of_part(const std::string& name, const std::string& part, const std::string& part_name) const;
  int material_between(const Partner& a, const Partner& b) const;

  const Scenario& scenario_;
  const Instances& instances_;
  std::vector<Partner> partners_;
  std::deque<Surface> surfaces_;
  std::vector<int> material_;  ///< of each surface
};

}  // namespace flyrock
