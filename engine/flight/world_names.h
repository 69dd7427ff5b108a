#pragma once
// What the bodies of a world and the parts of its terrain are called in results.

#include <string>
#include <vector>

#include "world/manifold.h"
#include "world/world.h"

namespace flyrock {

struct WorldNames {
  std::vector<std::string> bodies;  ///< of all bodies of the world
  std::vector<std::string> parts;   ///< of the terrain
};

/// The antagonist of a contact: a body, `terrain`, or `terrain.<part>`.
template <int D>
std::string antagonist_of(const WorldNames& names, const World<D>& world, const WorldContact<D>& contact) {
  if (contact.antagonist >= 0) return names.bodies[contact.antagonist];
  const std::string& part = names.parts[part_of(world.terrain(), contact.at.against)];
  return part.empty() ? "terrain" : "terrain." + part;
}

}  // namespace flyrock
