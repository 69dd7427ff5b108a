#pragma once
// A rigid body.

#include <string>
#include <vector>

#include "collision/motion.h"
#include "collision/placed.h"
#include "geometry/contactor.h"

namespace flyrock {

enum class BodyKind {
  dynamic,  ///< moved by forces and contacts
  fixed,    ///< does not move
  driven    ///< moves at a given velocity
};

/// SI units; x is the centre of mass, in the world; contactors are in the frame of the centre of mass.
template <int D>
struct Body {
  using Rows = Eigen::Matrix<double, Space<D>::dof, 1>;

  std::string group;
  BodyKind kind = BodyKind::dynamic;
  bool present = true;  ///< false once it has left the run: it meets nothing
  std::vector<Contactor2> contactors;
  double mass = 0;
  typename Space<D>::Inertia inertia{};
  double volume = 0;
  double size = 0;    ///< radius of the circle about the centre of mass that holds it
  double radius = 0;  ///< of the disk (sphere) of equal area (volume)

  Vec<D> x = Vec<D>::Zero(), v = Vec<D>::Zero();
  double angle = 0;   ///< counted through full turns
  typename Space<D>::Spin w{};
  typename Space<D>::Rotation rotation;

  int impacts = 0;    ///< manifolds that closed faster than rest_speed

  bool moves() const { return kind == BodyKind::dynamic && present; }
  /// M^-1 h, the change of velocity that the row h of H^T brings; 0 for a body that contacts do not move.
  Rows inverse_mass_times(const Rows& h) const;
  /// (v, w) as one column.
  Rows velocity() const;
  void add_velocity(const Rows& dv);
  void move_to(const Vec<D>& position, double new_angle);
  Pose2 pose() const { return {x, rotation}; }
  double kinetic_energy() const;
  Vec<D> velocity_at(const Vec<D>& point) const;
};

template <>
inline Body<2>::Rows Body<2>::inverse_mass_times(const Rows& h) const {
  if (!moves()) return Rows::Zero();
  return {h[0] / mass, h[1] / mass, h[2] / inertia};
}
template <>
inline Body<2>::Rows Body<2>::velocity() const {
  return {v.x(), v.y(), w};
}
template <>
inline void Body<2>::add_velocity(const Rows& dv) {
  v += dv.head<2>();
  w += dv[2];
}
template <>
inline void Body<2>::move_to(const Vec2& position, double new_angle) {
  x = position;
  if (new_angle != angle) rotation = Rotation2::from_angle(new_angle);
  angle = new_angle;
}
template <>
inline double Body<2>::kinetic_energy() const {
  return kind == BodyKind::dynamic ? 0.5 * (mass * v.squaredNorm() + inertia * w * w) : 0.0;
}
template <>
inline Vec2 Body<2>::velocity_at(const Vec2& point) const {
  return v + cross(w, Vec2(point - x));
}

/// A dynamic body of contactors that do not overlap: moves them to the centre of mass and computes area, volume, mass
/// and inertia exactly. `thickness` <= 0 takes default_thickness. Give a density [kg/m3], or a mass [kg] with density 0.
Body<2> make_body(std::vector<Contactor2> contactors, double density, double mass, double thickness);

}  // namespace flyrock
