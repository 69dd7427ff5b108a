#pragma once
// The radius of a pneumatic disk: a ring around gas, with one degree of freedom of its shape.

namespace flyrock {

/// The ring stays a circle; its radius R moves by
///   m_R R'' = 2 pi R T (p - p_o) - k (R - R_0) - c R' + J'(R) w^2 / 2 + side sum r_n
///   p = p_0 (R_0 / R)^(2 gamma),   J(R) = J_0 (R / R_0)^2,   J w changes by contacts only
/// with the thickness T of the 2D world and the normal forces r_n of its contacts. The velocity of a contact
/// along its normal contains side R', and the contact's row of H has the entry `side` for the radius.
///
/// A body whose shape is rigid has mass 0. SI units.
struct Breathing {
  /// The position and velocity of this degree of freedom.
  struct State {
    double radius = 0;  ///< m
    double rate = 0;    ///< m/s
  };

  State now;
  double mass = 0;         ///< kg, m_R
  double rest_radius = 0;  ///< m, R_0
  double moment = 0;       ///< kg m2, J_0
  double thickness = 0;    ///< m, T
  double pressure = 0;     ///< Pa, p_0, absolute
  double outside = 0;      ///< Pa, p_o
  double gamma = 0;        ///< of the gas; 0: its pressure is constant
  double stiffness = 0;    ///< N/m, k
  double damping = 0;      ///< N s/m, c
  double side = -1;        ///< -1: touched from outside, a contact pushes R in; 1: from inside

  bool moves() const { return mass > 0; }
  double moment_at(double radius) const;  ///< kg m2
  double gas_pressure() const;            ///< Pa
  /// What acts on the radius besides damping and contacts, for the spin w [rad/s] of the body [N].
  double force(double w) const;
  /// The angular frequency of small changes of the radius about the present one, J w kept [rad/s].
  double frequency(double w) const;
  /// The energy of the gas, of the air outside and of the spring [J]; 0 at R_0.
  double potential_energy() const;
  double kinetic_energy() const { return 0.5 * mass * now.rate * now.rate; }
  /// The energy that the radius holds, and what it has taken from the spin w [rad/s] or given to it [J].
  double exchanged_energy(double w) const;
  /// dR' for an impulse [N s] along the radius. In a step of length h the damping acts on the rate
  /// (1 - theta) R' + theta R'+, so it resists the impulse too.
  double inverse_mass(double theta_h) const { return 1 / (mass + theta_h * damping); }
  /// R' after a step without contacts, by the forces of the present radius, in the middle of the step.
  double free_rate(double w, double h, double theta) const;

  /// The radius at which a ring counts as collapsed: 5 % of R_0. It becomes no smaller [m].
  double least_radius() const { return 0.05 * rest_radius; }
  bool collapsed() const { return moves() && !(now.radius > least_radius()); }
};

}  // namespace flyrock
