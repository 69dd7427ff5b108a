#pragma once
// The plugin kinds that make rocks, terrains and launches.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "blast/blast.h"
#include "geometry/contactor.h"
#include "geometry/contactor3.h"
#include "geometry/plane.h"
#include "geometry/profile.h"
#include "plugin/params.h"
#include "random/stream.h"

namespace flyrock {

/// `shape`: contactors of one rock, in any frame; the engine moves them to the centre of mass and
/// computes mass and inertia. A model answers in the dimensions that it has, and its factory refuses others
/// (Params::require_dimension). Throws PluginError.
class ShapeModel {
 public:
  virtual ~ShapeModel() = default;
  virtual std::vector<Contactor2> build(Values values, RandomStream& rng) const;
  virtual std::vector<Contactor3> build_3d(Values values, RandomStream& rng) const;
};

/// `terrain`: the static contactors, in the dimensions that the model has. Throws PluginError.
class TerrainModel {
 public:
  virtual ~TerrainModel() = default;
  virtual Profile build(Values values, RandomStream& rng) const;
  virtual Plane build_3d(Values values, RandomStream& rng) const;
};

/// A rock as a velocity model sees it. SI units; z components are 0 in 2D.
struct RockView {
  int dimension = 2;
  double mass = 0;
  double volume = 0;
  double density = 0;
  double diameter = 0;  ///< of the circle (sphere) of equal area (volume)
  Vec3 position = Vec3::Zero();
  Vec3 outward = Vec3::UnitX();  ///< horizontal unit vector out of the face it leaves, else +x
  double face_angle = 0;         ///< rad, of that face, 0 where there is none
  std::string_view group;
};

struct Launch {
  Vec3 velocity = Vec3::Zero();  ///< m/s
  Vec3 spin = Vec3::Zero();      ///< rad/s, world frame; (0, 0, w) in 2D
  std::string note;              ///< what the run should warn of ("v0^2 < 0: ..."), or empty
  /// Of a model that was fitted to distances: the greatest throw [m] that its formula gives, in air, at 45
  /// degrees or along the hole, on level ground. Its speed only stands for that distance. 0: the model gives
  /// a speed.
  double greatest_throw = 0;
};

/// The velocity of magnitude `speed` at `elevation` above the outward horizontal of the rock, turned by
/// `azimuth` about the vertical (3D).
Vec3 direction_velocity(const RockView& rock, double speed, double elevation, double azimuth = 0);

/// `velocity`: launch of one rock. Throws PluginError.
class VelocityModel {
 public:
  virtual ~VelocityModel() = default;
  virtual Launch launch(Values values, const RockView& rock, const Blast& blast, RandomStream& rng) const = 0;
};

/// One rock of a population. What it leaves open is taken from the group's `shape` and `release`.
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

/// `population`: the rocks of a group in one trial, in the dimensions that the model has. Throws PluginError.
class Population {
 public:
  virtual ~Population() = default;
  virtual std::vector<RockPlan> rocks(Values values, const Profile& terrain, const Blast& blast,
                                      RandomStream& rng) const;
  virtual std::vector<RockPlan3> rocks_3d(Values values, const Plane& terrain, const Blast& blast,
                                          RandomStream& rng) const;
};

}  // namespace flyrock
