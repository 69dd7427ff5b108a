#pragma once
// Random scenes: a few bodies of all shapes on a ground, whose motion a judge can check.

#include <string>
#include <vector>

#include "dice.h"
#include "geometry/form.h"
#include "math/space.h"

namespace flyrock::fuzz {

/// A body that is touched from inside: a circle, or in 3D a tube about its own z axis.
struct HollowBody {
  std::string name;
  double radius = 0, half_length = 0;  ///< m; in 2D the length has no meaning
};

/// A box along the axes of a body, one of those that together are a body which is not convex.
struct BlockOfBody {
  std::string name;
  Vec3 low, high;  ///< m; in 2D without z
};

/// A scene as text, and what its judge knows about it beforehand.
struct Scene {
  std::string text;  ///< YAML
  int dimension = 3;
  bool gives_energy = false;  ///< driven bodies, or springs whose energy is in no table: the sum may grow
  bool law_gains = false;     ///< Newton's form of restitution: an impact may gain the energy that it reports
  bool may_jam = false;       ///< a driven body may press others without a way out: no run can go on then
  bool is_spring = false;     ///< contacts penetrate by design
  Tier tier = Tier::a;        ///< the greatest of its shapes
  int bodies = 0;
  double fall = 1;  ///< m, the greatest height of a body over the lowest ground
  std::vector<HollowBody> hollows;
  std::vector<BlockOfBody> blocks;
  std::vector<std::string> planes;  ///< bodies that are the half space below their own z axis
  std::vector<std::string> clouds;  ///< bodies whose vertices touch the ground, planes and blocks only
  /// The ground: the points of a profile in 2D; in 3D a plane (a place and its normal) or a grid.
  std::vector<Vec2> profile;
  Vec3 place = Vec3::Zero(), normal = Vec3::UnitZ();
  int columns = 0;              ///< of the grid, which is square; 0: a plane
  double cell = 1;              ///< m
  Vec2 corner = Vec2::Zero();   ///< south-western, centre of the first cell
  std::vector<double> heights;  ///< m, row by row from the south
};

/// Whether its shapes are held to all promises (geometry/form.h, Tier).
inline bool is_promised(const Scene& scene) {
  return scene.tier == Tier::a || (scene.tier == Tier::b && scene.bodies == 1);
}

/// A function of the dice alone. Writes the files that the text names into the current folder.
Scene make_scene(Dice& dice);

}  // namespace flyrock::fuzz
