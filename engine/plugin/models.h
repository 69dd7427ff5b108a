#pragma once
// The plugin kinds for rocks, terrains and launches.

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "blast/blast.h"
#include "geometry/contactor.h"
#include "geometry/contactor3.h"
#include "geometry/deformable.h"
#include "geometry/own_mass.h"
#include "geometry/pneumatic.h"
#include "geometry/profile.h"
#include "geometry/terrain_shape.h"
#include "plugin/block_plan.h"
#include "plugin/params.h"
#include "plugin/terrain_view.h"
#include "random/stream.h"

namespace flyrock {

/// The shape of one rock, in any frame. The engine moves it to the centre of mass.
template <int D>
struct ShapeAnswer {
  std::vector<std::conditional_t<D == 2, Contactor2, Contactor3>> contactors;
  OwnMass<D> own = {};                           ///< in place of what follows from the contactors
  std::optional<Pneumatic> pneumatic = {};       ///< in 2D: the only contactor is a ring whose radius moves
  std::optional<Deformable<D>> deformable = {};  ///< the contactors fill its mesh
};

/// `shape`: one rock. A model implements build() or build_3d(), and the engine computes mass, centre and
/// inertia from the contactors. A model that knows these implements shape() or shape_3d(), which the engine
/// calls. A model supports 2D, 3D or both; its factory refuses other dimensions (Params::require_dimension).
/// Throws PluginError.
class ShapeModel {
 public:
  virtual ~ShapeModel() = default;
  virtual std::vector<Contactor2> build(Values values, RandomStream& rng) const;
  virtual std::vector<Contactor3> build_3d(Values values, RandomStream& rng) const;
  virtual ShapeAnswer<2> shape(Values values, RandomStream& rng) const { return {build(values, rng)}; }
  virtual ShapeAnswer<3> shape_3d(Values values, RandomStream& rng) const { return {build_3d(values, rng)}; }
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
  const TerrainView* terrain = nullptr;  ///< the ground of its trial; set in every run
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

/// One rock of a population. Missing fields are taken from its group.
template <int D>
struct RockPlan {
  ShapeAnswer<D> shape;  ///< without contactors: the shape of its group
  /// Diameter of the sphere (2D: circle) of equal volume (area) [m]; the shape is scaled to it.
  std::optional<double> diameter;
  std::optional<Vec<D>> position;  ///< of the centre of mass, in the coordinates of the scenario [m]
  /// Orientation of the contactors as given: an angle [rad] in 2D.
  std::optional<std::conditional_t<D == 2, double, Rotation3>> orientation;
  std::optional<double> density;                ///< kg/m3; at most one of density, mass and shape.own.mass
  std::optional<double> mass;                   ///< kg
  std::optional<std::string> material;          ///< towards other rocks
  std::optional<Vec<D>> velocity;               ///< m/s; takes the place of the group's launch
  std::optional<typename Space<D>::Spin> spin;  ///< rad/s, world frame
  std::optional<double> weight;                 ///< real rocks that it stands for, above 0
  std::shared_ptr<const BlockPlan<D>> block;    ///< of a block that joints have cut; null for others
};

/// `population`: the rocks of a group in one trial, in the dimensions that the model supports. Throws
/// PluginError.
class Population {
 public:
  virtual ~Population() = default;
  virtual std::vector<RockPlan<2>> rocks(Values values, const TerrainView& terrain, const Blast& blast,
                                         RandomStream& rng) const;
  virtual std::vector<RockPlan<3>> rocks_3d(Values values, const TerrainView& terrain, const Blast& blast,
                                            RandomStream& rng) const;
};

}  // namespace flyrock
