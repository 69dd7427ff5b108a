#pragma once
// Contact laws: restitution, friction, rolling resistance and the normal condition.

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "math/space.h"
#include "plugin/params.h"

namespace flyrock {

/// The meaning of e_n and e_t. The equations are in solver/restitution.h.
enum class RestitutionForm {
  newton,       ///< e_n of the normal, e_t of the tangential velocity
  newton_mean,  ///< e_n of the normal velocity, friction on the mean of the tangential velocities before and
                ///< after
  poisson,      ///< e_n of the normal impulse
  energy,       ///< e_n^2 of the normal work
  velocity      ///< v_n^+ = -e_n v_n^-, v_t^+ = e_t v_t^-, whatever the friction
};
std::string_view name_of(RestitutionForm form);
std::optional<RestitutionForm> restitution_form(std::string_view name);

/// The normal condition of a contact, in a step of length h that would end with the gap g without contact
/// forces.
enum class NormalCondition {
  signorini,    ///< for a closed contact, 0 <= U_n _|_ r_n >= 0
  quasi_shock,  ///< 0 <= max(0, g)/h + U_n _|_ r_n >= 0: the remaining gap may close
  cohesive,     ///< signorini on r_n + h c_n: the contact bears a pull up to c_n
  penalty       ///< r_n = h F of a Spring instead of a constraint, as in smooth DEM
};
std::string_view name_of(NormalCondition condition);
std::optional<NormalCondition> normal_condition(std::string_view name);

/// The answers of the laws. They contain forces, not impulses; a step of length h multiplies them by h.
struct Restitution {
  double e_n = 0;  ///< normal restitution of this impact
  double e_t = 0;  ///< tangential restitution, forms `newton` and `velocity` only
  RestitutionForm form = RestitutionForm::newton;
  bool as_lmgc90 = false;  ///< form `newton`: as LMGC90's RST_CLB, see solver/restitution.h
};
struct Friction {
  double mu_s = 0;  ///< Coulomb coefficient while the contact sticks
  double mu_d = 0;  ///< Coulomb coefficient while it slides
  double c_n = 0;   ///< N; the pull that the contact bears: r_n >= -c_n
  double c_t = 0;   ///< N; shear strength in addition to friction: |r_t| <= mu r_n + c_t, at least mu c_n
};
struct Rolling {
  double mu_r = 0;     ///< m; bound of the rolling torque: |m_r| <= mu_r (r_n + c_n)
  double mu_spin = 0;  ///< m; bound of the torque about the normal: |m_n| <= mu_spin (r_n + c_n); 3D only
};
/// The spring and damper of `penalty`. With the overlap d = max(0, -g) [m] and its rate d' [m/s],
///   F = k d^n + c d^(n-1) d',  never below 0 (Kelvin and Voigt: n = 1; Hertz: n = 1.5).
/// With k_t > 0 friction is a spring too (Cundall and Strack): its stretch s grows by the slip, and
/// F_t = -k_t s, cut at mu F; otherwise it is Coulomb's law on the slip.
struct Spring {
  double stiffness = 0;             ///< k, N/m^n
  double damping = 0;               ///< c, N s/m^n
  double exponent = 1;              ///< n, from 1 to 1.5
  double tangential_stiffness = 0;  ///< k_t, N/m
};
struct Unilateral {
  NormalCondition condition = NormalCondition::signorini;
  Spring spring;    ///< of `penalty`
  double pull = 0;  ///< N, of `cohesive`: adds to c_n, and mu_s times as much to c_t
};

/// The complete contact law for the solver: the answers of the laws, with a pull in c_n and c_t.
struct ContactLaw : Restitution, Friction, Rolling {
  NormalCondition condition = NormalCondition::signorini;
  Spring spring;  ///< of the condition `penalty`
};

/// The data of a contact that a law may read. SI units. Velocities are relative velocities at the contact
/// point, `the rock` is that of World::rock_of. The order is that of `contact_fields()`. The fields from
/// `normal_force` to `slip_length` are computed only for laws whose manifest names them in `reads`; otherwise
/// they describe the first contact of a ball with the terrain. NaN: there is no such number.
struct ContactState {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  double approach_speed = 0;  ///< m/s, -v_n if the bodies approach, otherwise 0
  double slip_speed = 0;      ///< m/s, |v_t|
  double impact_angle = 0;    ///< rad from the surface: pi/2 is a normal impact
  double gap = 0;             ///< m
  double effective_mass = 0;  ///< kg, 1/W_nn
  double mass = 0;            ///< kg, of the rock
  double radius = 0;          ///< m, of the disk of its area, in 3D of the sphere of its volume
  double spin = 0;            ///< rad/s, of the rock
  double kinetic_energy = 0;  ///< J, of the rock
  double length = 0;          ///< m, tributary length of this point in 2D; 0 for a single point and in 3D
  double area = 0;            ///< m2, tributary area; in 2D the length times the thickness of the rock
  double age = 0;             ///< s since the contact closed
  double pair_age =
      0;  ///< s since the pair has been in contact without interruption: the greatest age of its contacts
  double was_sticking = 0;     ///< 1 if the contact stuck in the last step, otherwise 0
  double impact_number = 0;    ///< impacts of the rock so far, this one included; from 1
  double time = 0;             ///< s
  double step = 0;             ///< s, length of the current step; 0 for an impact
  double normal_force = none;  ///< N, r_n/h of the last accepted step; none at first touch and at impacts
  double points = 1;           ///< contact points of the same pair with the same normal, this one included
  std::string_view shape_type = "disk";  ///< name of the rock's shape (Body::shape_type)
  double shape_elongation = 1;           ///< of the rock, as Proportions (world/proportions.h)
  double shape_flatness = none;          ///< 3D only
  double shape_corners = 0;
  double partner_mass = none;    ///< kg, of the other body; none of one that contacts do not move
  double partner_radius = none;  ///< m; none of the terrain
  bool partner_moves = false;    ///< whether contacts move the other body
  double slip_length = 0;        ///< m, way that the contact has slipped since it closed
  int dimension = 2;             ///< of the vectors; z is 0 in 2D
  Vec3 normal = Vec3::UnitY();   ///< unit, towards the rock
  Vec3 place = Vec3::Zero();     ///< m, the contact point in the coordinates of the scenario
  Vec3 slip = Vec3::Zero();      ///< m/s, v_t: the tangential velocity of the rock
  std::string_view group_a;      ///< the rock: name of its group or body
  std::string_view group_b;   ///< the other body: name of its group or body, or terrain.<part>; terrain where
                              ///< the part has no name
  std::string_view material;  ///< name of the material of the contact
  /// The law's memory, in the order of its manifest. It is zero when its pair or contact is created, and kept
  /// between calls. A law may write it. If the engine repeats a step, it restores the memory from the start
  /// of the step.
  std::span<double> history;
};

/// Puts a ball on level ground: an upright normal, and the slip of its slip_speed along x.
void set_on_level_ground(ContactState& contact, int dimension);

/// A field of a contact and its name: "gap"; "shape.corners" is a field of the table `shape`. Exactly one of
/// `number`, `text`, `vector` and `flag` is set.
struct ContactField {
  std::string_view name, unit, doc;  ///< SI; no unit: a pure number
  double ContactState::*number = nullptr;
  std::string_view ContactState::*text = nullptr;
  Vec3 ContactState::*vector = nullptr;
  bool ContactState::*flag = nullptr;
  bool only_if_read = false;  ///< there only for laws whose manifest names it, or its table, in `reads`

  std::string_view table() const;     ///< "shape" of "shape.corners"; otherwise empty
  std::string_view own_name() const;  ///< "corners"
  /// What `reads` calls it: "contact.shape" of "shape.corners".
  std::string read_name() const;
};
const std::vector<ContactField>& contact_fields();
/// Whether a plugin may read a field.
bool may_read(const PluginSpec& spec, const ContactField& field);

/// Which of the fields that are there only if they are read, laws read.
struct ContactReads {
  bool normal_force = false, points = false, shape = false, partner = false, slip_length = false;

  void add(const ContactReads& other);
};
ContactReads contact_reads(const PluginSpec& spec);

/// The kinds of laws. Laws are immutable and shared by threads (a Lua law belongs to one worker). `values`
/// are the parameters in the slots that the factory recorded. Laws throw PluginError. The caller checks the
/// results with the functions below.
class Law {
 public:
  virtual ~Law() = default;
  /// Whether the answer depends on `values` only. The law is then called once.
  virtual bool constant() const = 0;
  /// The name of the law in messages: "coulomb" or "my_law, my_law.lua:14".
  virtual std::string origin() const = 0;
};
class RestitutionLaw : public Law {
 public:
  virtual Restitution impact(Values values, const ContactState& contact) const = 0;
};
class FrictionLaw : public Law {
 public:
  virtual Friction friction(Values values, const ContactState& contact) const = 0;
};
class RollingLaw : public Law {
 public:
  virtual Rolling rolling(Values values, const ContactState& contact) const = 0;
};
class UnilateralLaw : public Law {
 public:
  virtual Unilateral condition(Values values, const ContactState& contact) const = 0;
};

/// Throw PluginError "plugin NAME, FILE:LINE: impact() returned e_n = -0.2, must be at least 0" if an answer
/// is not finite or out of range. Required: e_n >= 0; e_t = 0 for a form without it (gain.h: <= 1); mu >= 0;
/// mu_d <= mu_s; c_n >= 0; c_t >= mu_s c_n; mu_r and mu_spin >= 0; pull >= 0; of a spring stiffness > 0,
/// damping >= 0, exponent from 1 to 1.5, tangential stiffness >= 0.
void check_answer(const Law& law, const Restitution& answer);
void check_answer(const Law& law, const Friction& answer);
void check_answer(const Law& law, const Rolling& answer);
void check_answer(const Law& law, const Unilateral& answer);

}  // namespace flyrock
