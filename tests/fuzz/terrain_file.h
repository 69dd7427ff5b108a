#pragma once
// Files of ground as programs write them, with the quirks of these programs, and the ground that they mean.

#include <optional>
#include <string>
#include <vector>

#include "dice.h"
#include "geometry/forest.h"

namespace flyrock::fuzz {

/// A place and the height of the ground there; none: no ground.
struct Probe {
  Vec2 place = Vec2::Zero();  ///< in plan; in 2D (x, 0)
  std::optional<double> height;
};

/// A section `terrain` whose file stands in the current folder, and what must be read.
struct TerrainFile {
  int dimension = 3;
  std::string terrain;        ///< keys and values of the section, "type: mesh, file: g.obj"
  std::string other = {};     ///< further sections
  Vec2 start = Vec2::Zero();  ///< a place with ground, in plan
  std::vector<Probe> probes = {};
  double tolerance = 1e-6;       ///< m, of heights: the digits of the file
  std::vector<Stem> stems = {};  ///< of a list of trees
  /// Words that the refusal of the file has; empty: it must be read.
  std::string fault = {};
  /// How the key that cures it begins, "repair: { weld:"; the refusal names all of it. Empty: no key does.
  std::string cure = {};
};

/// A function of the dice alone. Writes the file into the current folder.
TerrainFile make_terrain_file(Dice& dice);

TerrainFile make_mesh_file(Dice& dice);     ///< OBJ, PLY and STL
TerrainFile make_grid_file(Dice& dice);     ///< ESRI and Surfer text, GeoTIFF
TerrainFile make_profile_file(Dice& dice);  ///< points along a section
TerrainFile make_tree_file(Dice& dice);     ///< trees on a grid

/// A number between two others.
double draw(Dice& dice, double low, double high);
/// The same with so many decimals, which a file can hold.
double rounded_draw(Dice& dice, double low, double high, int decimals);
/// Some programs write no line end after the last line.
std::string with_last_line(Dice& dice, std::string text);
/// One of some texts.
std::string one_of(Dice& dice, std::initializer_list<const char*> texts);

/// A hill whose heights are the sum of one function of x and one of y, so that four corners of a cell lie in
/// a plane.
struct Hill {
  Vec2 corner = Vec2::Zero();
  double slope_x = 0, slope_y = 0, bump = 0, wave = 1, base = 400;

  double height(const Vec2& place) const;
};
/// In coordinates of a country or near 0.
Hill make_hill(Dice& dice, bool is_national);

}  // namespace flyrock::fuzz
