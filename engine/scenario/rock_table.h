#pragma once
// Rocks from a table (`rocks[].table`): each line is one rock of every trial.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "math/space.h"

namespace flyrock {

/// The form of a rock with three lengths.
enum class RockForm {
  box,
  cut,        ///< a box with its edges and corners cut, as the norm blocks of EOTA
  ellipsoid,  ///< a polyhedron of 20 corners with the volume of the ellipsoid
  sphere      ///< with the volume of the ellipsoid
};

std::string_view name_of(RockForm form);
/// The volume of a form with the lengths of its bounding box [m3].
double volume_of(RockForm form, const Vec3& lengths);

/// A line of the table; what it does not say is left to the group.
struct TableRock {
  std::string name;                ///< empty: none
  std::string group;               ///< a label; empty: none
  std::optional<double> mass;      ///< kg
  std::optional<Vec3> lengths;     ///< m, as measured
  std::optional<double> diameter;  ///< m, of the sphere of equal volume, in place of the lengths
  std::optional<Vec3> place;       ///< m, of the centre of mass; y is 0 in 2D, where z is the height
  bool on_ground = false;          ///< 3D: z is not given; the rock is lowered until it touches the ground
  std::optional<Vec3> velocity;    ///< m/s
};

struct RockTable {
  std::string file;
  std::vector<TableRock> rocks;
  std::optional<RockForm> form;          ///< of `from_lengths`; absent: the shape of the group
  bool own_density = false;              ///< `density: from_table`: that of the masses and lengths
  std::vector<std::string> other_heads;  ///< of the table, which are no columns

  /// The factor on the lengths of a rock, so that its mass and the density [kg/m3] agree; 1 where one of
  /// them follows from the others.
  double scale_of(const TableRock& rock, double density) const;
  /// The lengths of the form after scaling [m]; a rock without lengths is as long as wide and high.
  Vec3 lengths_of(const TableRock& rock, double density) const;
};

}  // namespace flyrock
