#pragma once
// The plugin kinds for rocks, terrains and launches.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "blast/blast.h"
#include "geometry/contactor.h"
#include "geometry/contactor3.h"
#include "geometry/ground.h"
#include "geometry/profile.h"
#include "plugin/params.h"
#include "random/stream.h"

namespace flyrock {

/// `shape`: the contactors of one rock, in any frame. The engine moves them to the centre of mass and
/// computes mass and inertia. A model supports 2D, 3D or both; its factory refuses other dimensions
/// (Params::require_dimension). Throws PluginError.
class ShapeModel {
 public:
  virtual ~ShapeModel() = default;
  virtual std::vector<Contactor2> build(Values values, RandomStream& rng) const;
  virtual std::vector<Contactor3> build_3d(Values values, RandomStream& rng) const;
};

/// `terrain`: the static contactors, in the dimensions that the model supports. Throws PluginError.
class TerrainModel {
 public:
  virtual ~TerrainModel() = default;
  virtual Profile build(Values values, RandomStream& rng) const;
  virtual TerrainShape3 build_3d(Values values, RandomStream& rng) const;
};

/// The data of a rock that a velocity model reads. SI units; z components are 0 in 2D.
struct RockView {
  int dimension = 2;
  double mass = 0;
  double volume = 0;
  double density = 0;
  double diameter = 0;  ///< of the circle (sphere) of equal area (volume)
  Vec3 position = Vec3::Zero();
  /// Horizontal unit vector out of the face that the rock leaves; +x if there is no face
  Vec3 outward = Vec3::UnitX();
  double face_angle = 0;  ///< rad, angle of that face; 0 if there is none
  std::string_view group;
};

struct Launch {
  Vec3 velocity = Vec3::Zero();  ///< m/s
  Vec3 spin = Vec3::Zero();      ///< rad/s, world frame; (0, 0, w) in 2D
  std::string note;              ///< a warning for the run ("v0^2 < 0: ..."), or empty
  /// For a model that was fitted to distances: the greatest throw [m] that its formula gives, in air, at 45
  /// degrees or along the hole, on level ground. The speed of such a model only represents that distance. 0:
  /// the model gives a speed.
  double greatest_throw = 0;
};

/// The velocity [m/s] of magnitude `speed`, at `elevation` [rad] above the outward horizontal direction of
/// the rock, turned by `azimuth` [rad] about the vertical (3D).
Vec3 direction_velocity(const RockView& rock, double speed, double elevation, double azimuth = 0);

/// `velocity`: the launch of one rock. Throws PluginError.
class VelocityModel {
 public:
  virtual ~VelocityModel() = default;
  virtual Launch launch(Values values, const RockView& rock, const Blast& blast, RandomStream& rng) const = 0;
};

/// One rock of a population. Missing fields are taken from the group's `shape` and `release`.
struct RockPlan {
  std::vector<Contactor2> contactors;
  std::optional<Vec2> position;  ///< of the centre of mass
  std::optional<double> angle;   ///< rad
};

struct RockPlan3 {
  std::vector<Contactor3> contactors;
  std::optional<Vec3> position;          ///< of the centre of mass
  std::optional<Rotation3> orientation;  ///< of the contactors as given
};

/// `population`: the rocks of a group in one trial, in the dimensions that the model supports. Throws
/// PluginError.
class Population {
 public:
  virtual ~Population() = default;
  virtual std::vector<RockPlan> rocks(Values values, const Profile& terrain, const Blast& blast,
                                      RandomStream& rng) const;
  virtual std::vector<RockPlan3> rocks_3d(Values values, const Ground3& terrain, const Blast& blast,
                                          RandomStream& rng) const;
};

}  // namespace flyrock
