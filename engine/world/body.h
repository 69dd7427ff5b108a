#pragma once
// A rigid body.

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "collision/geometry.h"
#include "collision/part_tree.h"
#include "geometry/own_mass.h"
#include "geometry/pneumatic.h"
#include "world/air.h"
#include "world/breathing.h"
#include "world/deformation.h"

namespace flyrock {

enum class BodyKind {
  dynamic,  ///< moved by forces and contacts
  fixed,    ///< does not move
  driven    ///< moves at a given velocity, which may grow at a given rate
};

/// The rotation of a body from its own frame to the world frame.
template <int D>
struct Attitude;

template <>
struct Attitude<2> {
  double angle = 0;  ///< rad, counted through full turns
  Rotation2 rotation;

  Attitude() = default;
  Attitude(double a) : angle(a), rotation(Rotation2::from_angle(a)) {}
  /// This attitude turned by `turn` [rad] more.
  Attitude turned(double turn) const {
    Attitude next = *this;
    next.angle += turn;
    next.rotation = rotation.turned(turn);
    return next;
  }
  /// Takes away what rounding has added to the rotation.
  void settle() { rotation = Rotation2::from_angle(angle); }
};

template <>
struct Attitude<3> {
  Rotation3 rotation;

  Attitude() = default;
  Attitude(const Rotation3& r) : rotation(r) {}
  /// This attitude turned by |turn| [rad] more about the axis `turn`, world frame.
  Attitude turned(const Vec3& turn) const {
    return turn.isZero(0) ? *this : Attitude(Rotation3::from_vector(turn) * rotation);
  }
  void settle() {}  ///< a product of rotations is normalised
};

/// An attitude as TrajectoryPoint::turn.
inline std::array<double, 4> quaternion_of(const Attitude<2>&) { return {1, 0, 0, 0}; }
inline std::array<double, 4> quaternion_of(const Attitude<3>& attitude) {
  const Eigen::Quaterniond& q = attitude.rotation.quaternion();
  return {q.w(), q.x(), q.y(), q.z()};
}

/// |w| of a spin in 2D or 3D.
inline double spin_speed(double w) { return std::abs(w); }
inline double spin_speed(const Vec3& w) { return w.norm(); }

/// How long, flat and angular a body is (world/proportions.h).
struct Proportions {
  double elongation = 1;
  double flatness = std::numeric_limits<double>::quiet_NaN();  ///< 3D only
  double corners = 0;
};

/// SI units. x is the centre of mass in the world frame. Contactors are given in the body's frame: its origin
/// is the centre of mass, and in 3D its axes are the principal axes.
template <int D>
struct Body {
  using Rows = Eigen::Matrix<double, Space<D>::dof, 1>;
  using Spin = typename Space<D>::Spin;
  using Contactor = typename Geometry<D>::Contactor;

  std::string group;
  /// Name of the plugin that has made its shape; of a shape that a population gives, the population's.
  std::string_view shape_type;
  std::optional<Proportions> proportions;  ///< found when a law first reads them
  BodyKind kind = BodyKind::dynamic;
  bool present = true;  ///< false once it has left the run; it then has no contacts
  std::vector<Contactor> contactors;
  PartTree<D> parts;  ///< of the contactors
  double mass = 0;
  typename Space<D>::Inertia inertia{};
  double volume = 0;
  double size = 0;    ///< radius of the circle (sphere) about the centre of mass that contains the body
  double radius = 0;  ///< of the disk of the body's area, in 3D of the sphere of its volume

  Vec<D> x = Vec<D>::Zero(), v = Vec<D>::Zero();
  Attitude<D> attitude;
  Spin w = Space<D>::no_spin();  ///< rad/s, world frame

  Breathing breathing;         ///< of a pneumatic disk; of a rigid body mass 0
  Deformation<D> deformation;  ///< of a deformable block; of a rigid body empty

  Air<D> air;  ///< the air around the body
  /// m/s2, acceleration by the air in the current flight or step, and by `load`; of a driven body the given
  /// one
  Vec<D> push = Vec<D>::Zero();

  int impacts = 0;  ///< manifolds that closed faster than rest_speed

  Vec<D> load = Vec<D>::Zero();  ///< m/s2, acceleration by the force that the scenario gives; part of `push`

  /// A body that stands until a time, and then has these velocities.
  struct Hold {
    double until = 0;  ///< s
    Vec<D> v = Vec<D>::Zero();
    Spin w = Space<D>::no_spin();
  };
  std::optional<Hold> hold;  ///< empty: it is not held, or not any more

  bool moves() const { return kind == BodyKind::dynamic && present && !hold; }
  /// m/s2, without contacts.
  Vec<D> acceleration(const Vec<D>& gravity) const {
    if (moves()) return gravity + push;
    return kind == BodyKind::driven ? push : Vec<D>::Zero();
  }
  /// M^-1 h, the change of velocity caused by an impulse along h, a column of H^T. 0 for a body that contacts
  /// do not move.
  Rows inverse_mass_times(const Rows& h) const {
    if (!moves()) return Rows::Zero();
    if constexpr (D == 2) {
      return {h[0] / mass, h[1] / mass, h[2] / inertia};
    } else {
      Rows change;
      change << h.template head<3>() / mass,
          attitude.rotation * Vec3(attitude.rotation.inverse(h.template tail<3>()).cwiseQuotient(inertia));
      return change;
    }
  }
  /// (v, w) as one column vector.
  Rows velocity() const {
    if constexpr (D == 2) {
      return {v.x(), v.y(), w};
    } else {
      Rows both;
      both << v, w;
      return both;
    }
  }
  void add_velocity(const Rows& dv) {
    v += dv.template head<D>();
    w += Space<D>::spin_of(dv);
  }
  /// Moves the body by the small displacement (dx, turn).
  void displace(const Rows& by) {
    move_to(x + by.template head<D>(), attitude.turned(Space<D>::spin_of(by)));
  }
  /// Gives the shape this state: its contactor, the moment of inertia, and the bounds. The spin keeps J w.
  void set_shape(const Breathing::State& state);
  /// Lets the radius of a pneumatic disk grow [m].
  void swell(double by) { set_shape({breathing.now.radius + by, breathing.now.rate}); }
  bool breathes() const { return breathing.moves() && moves(); }
  bool deforms() const { return deformation.moves() && moves(); }
  /// Moves the nodes of a deformable block: `place_nodes` puts its contactors where they are.
  void deform(double dt);
  void place_nodes();
  void move_to(const Vec<D>& position, const Attitude<D>& turned) { x = position, attitude = turned; }
  typename Geometry<D>::Pose pose() const { return {x, attitude.rotation}; }
  double spin_speed() const { return flyrock::spin_speed(w); }  ///< |w|, rad/s
  bool is_outline() const { return !contactors.empty() && contactors.front().form == Form::outline; }
  /// The contactor that a feature id names. An outline is the only one of its body.
  const Contactor& contactor_with(FeatureId feature) const {
    return contactors[is_outline() ? 0 : static_cast<std::size_t>(contactor_of(feature))];
  }
  /// 1/2 (m v.v + w.I w + m_R R'^2), of a deformable block with its vibration [J]; 0 for a body that is not
  /// dynamic.
  double kinetic_energy() const;
  Vec<D> velocity_at(const Vec<D>& point) const {
    const Vec<D> lever = point - x;
    if constexpr (D == 2)
      return v + cross(w, lever);
    else
      return v + w.cross(lever);
  }
  bool is_finite() const { return x.allFinite() && v.allFinite() && std::isfinite(spin_speed()); }
};

/// Whether the change of spin that contacts made in the last step goes on in this one, of length h; `push`:
/// the change at that rate in h. An impulse in a much shorter step does not: it would turn the spin round by
/// a notable angle.
template <class Spin>
bool goes_on(const Spin& push, const Spin& w, double h, double last_h) {
  constexpr double much_shorter = 0.1, round = 0.5, notable = 0.01;  // shares; rad
  return last_h >= much_shorter * h || spin_speed(push) <= round * spin_speed(w) ||
         h * spin_speed(push) <= notable;
}

/// The spin after a step h without torque, by the theta scheme with an implicit gyroscopic term:
///   I (w+ - w) + h w_th x I w_th = 0,  w_th = (1 - theta) w + theta w+,  I at the current attitude.
/// theta = 1/2 conserves |I w| and the energy. In 2D there is no gyroscopic term. `by_contacts` [rad/s]: the
/// change of the spin that contacts are expected to make in the step; theta times it is added to w_th.
inline double free_spin(const Body<2>& body, double, double, double) { return body.w; }
Vec3 free_spin(const Body<3>& body, double h, double theta, const Vec3& by_contacts);

/// The gyroscopic moment w x I w [N m] of a spin w, world frame.
Vec3 gyroscopic_moment(const Body<3>& body, const Vec3& w);

/// How fast the spin changes without torque [rad/s2]: |I^-1 (w x I w)|; 0 of a body without inertia.
inline double free_spin_rate(const Body<2>&) { return 0; }
double free_spin_rate(const Body<3>& body);

/// w.I w [J] of a spin w given in the world frame.
inline double twice_spin_energy(const Body<2>& body, const Attitude<2>&, double w) {
  return body.inertia * w * w;
}
inline double twice_spin_energy(const Body<3>& body, const Attitude<3>& attitude, const Vec3& w) {
  return body.inertia.dot(attitude.rotation.inverse(w).cwiseAbs2());
}
template <int D>
double Body<D>::kinetic_energy() const {
  if (kind != BodyKind::dynamic) return 0;
  const double rigid = 0.5 * (mass * v.squaredNorm() + twice_spin_energy(*this, attitude, w));
  if (deformation.moves()) return rigid + deformation.vibration_energy();
  return breathing.moves() ? rigid + breathing.kinetic_energy() : rigid;
}

template <>
void Body<2>::set_shape(const Breathing::State& state);
/// In 3D no radius moves.
template <>
inline void Body<3>::set_shape(const Breathing::State&) {}

/// Makes a dynamic body of contactors. Moves the contactors to the centre of mass and computes area, volume,
/// mass and inertia exactly, as sums over the contactors: where two overlap, the overlap counts twice.
/// `thickness` [m] <= 0 means default_thickness. Give a density [kg/m3], or a mass [kg] with density 0. `own`
/// takes the place of what it gives; its mass that of both.
Body<2> make_body(std::vector<Contactor2> contactors, double density, double mass, double thickness,
                  const OwnMass<2>& own = {});

/// Gives a body of one disk or hollow disk a radius that moves (world/breathing.h). Its mass is in the ring:
/// the moment of inertia is m R^2/2 of a disk and m R^2 of a hollow disk. Its thickness is that of make_body.
void make_pneumatic(Body<2>& body, const Pneumatic& filling);

/// Makes a body of contactors that fill the mesh a deformable block at rest: its contactors become the nodes
/// of the surface of the mesh, points without radius. Mass, centre and inertia stay those of the contactors,
/// which are those of the mesh; in 3D its frame becomes that of the block (ElasticModel::rotation).
template <int D>
void make_deformable(Body<D>& body, std::shared_ptr<const ElasticBlock<D>> block,
                     const std::optional<double>& strength);

/// The same in 3D. The body's frame becomes the principal frame, and the attitude maps it to the frame in
/// which the contactors were given.
Body<3> make_body(std::vector<Contactor3> contactors, double density, double mass,
                  const OwnMass<3>& own = {});

}  // namespace flyrock
