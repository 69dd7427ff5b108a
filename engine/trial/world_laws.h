#pragma once
// The laws of one world: those for contacts of its bodies with the terrain and with each other.

#include <deque>
#include <string>
#include <vector>

#include "trial/instances.h"
#include "world/manifold.h"
#include "world/world.h"

namespace flyrock {

/// The data that decide how a body of a world meets others.
struct Partner {
  std::string name;   ///< of its group of rocks, or its own in `bodies`
  int material = -1;  ///< index into Scenario::materials; -1: none
  DrawKey key;        ///< of its draws
};

/// The index of the material between two partners: that of their entry in `pairs`, or the one that both
/// have. Throws StartError if there is none.
int material_between(const Scenario& scenario, const Partner& a, const Partner& b);

/// One PairLaws for each body and part of the terrain, and one for each pair of bodies. Each has its own
/// draws and its own memory; only the laws themselves are shared. That of a pair of bodies is made when they
/// first come near each other, because few pairs of many rocks ever meet. Draws of a pair belong to its rock
/// (World::rock_of), then or at the impact. A WorldLaws object must not move, because the world points into
/// it. The scenario and the instances must outlive it.
class WorldLaws {
 public:
  /// `partners`: one for each body of the world, in the same order.
  WorldLaws(const Scenario& scenario, const Instances& instances, std::vector<Partner> partners);
  WorldLaws(const WorldLaws&) = delete;

  /// Gives the bodies of `world` their laws. Throws StartError if two of them can meet and no material is
  /// given.
  template <int D>
  void connect(World<D>& world);

  /// The laws between a body, which is a point, and each part of the terrain; null where no material is
  /// given. Made at the first call.
  template <int D>
  const std::vector<PairLaws*>& of_point(const World<D>& world, int body);
  /// The laws of one point may serve the next one on the same terrain, if it meets the same materials; it
  /// returns whether it does. They are then as if they had been made for it.
  bool serve(const Partner& next);
  void begin_rock(const DrawKey& key);  ///< as serve(), of a rock that meets the same materials

  /// The index of the material between two bodies of the world. Throws PluginError if none is given.
  int material_between(int a, int b) const {
    return flyrock::material_between(scenario_, partners_[a], partners_[b]);
  }
  /// The same for a body and a part of the terrain, given by its index; -1 if none is given.
  template <int D>
  int material_with_terrain(const World<D>& world, int body, int part) const {
    const auto& terrain = world.terrain();
    return material_of_part(partners_[body].name, parts_of(terrain)[part], terrain.names()[part]);
  }
  const DrawKey& key_of(int body) const { return partners_[body].key; }

  /// Adds the number of calls of the laws of each material.
  void add_use(std::vector<MaterialUse>& of_material) const;

 private:
  PairLaws* make(int material, const DrawKey& key);
  int material_of_part(const std::string& name, const std::string& part, const std::string& part_name) const;

  const Scenario& scenario_;
  const Instances& instances_;
  std::vector<Partner> partners_;
  std::deque<PairLaws> laws_;
  std::vector<std::vector<PairLaws*>> of_point_;  ///< [body][part]; empty before the first call
  std::vector<int> material_;                     ///< of each of laws_
};

}  // namespace flyrock
