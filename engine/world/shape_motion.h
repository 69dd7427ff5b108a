#pragma once
// What the world asks of a shape that is not rigid, whatever moves in it: the one interface of such shapes.

#include "world/body.h"

namespace flyrock {

/// Where a contact touches a body, for its shape.
template <int D>
struct ShapeTouch {
  FeatureId feature = 0;                ///< of the body
  Eigen::Matrix<double, D, D> frame{};  ///< of the contact: its normal and tangents, world frame
  double side = 1;                      ///< 1: the body is the candidate, -1: the antagonist
};

/// The shape of a body has a velocity of its own, which its contacts feel and change:
///   velocity of the contact = that of the rigid motions + sum over both bodies of shape_velocity
///   W_ab gains shape_mobility(a, b),  an impulse r of contact a gives push_shape(a, r)
/// The radius of a pneumatic disk (world/breathing.h): along the normal, the same for all contacts. The nodes
/// of a deformable block (world/deformation.h): those of the node that touches; its nodes couple all
/// contacts.
template <int D>
bool changes_shape(const Body<D>& body) {
  return body.breathes() || body.deforms();
}

/// What the motion of the shape adds to the velocity of a contact, in its frame [m/s].
template <int D>
Vec<D> shape_velocity(const Body<D>& body, const ShapeTouch<D>& touch);

/// The change of shape_velocity at touch `a` by an impulse at touch `b`, each in its frame [1/kg]. `theta_h`
/// [s]: theta times the step, over which damping and stiffness resist the impulse too.
template <int D>
Eigen::Matrix<double, D, D> shape_mobility(const Body<D>& body, const ShapeTouch<D>& a,
                                           const ShapeTouch<D>& b, double theta_h);

/// Gives the shape the impulse [N s] of a contact, in its frame.
template <int D>
void push_shape(Body<D>& body, const ShapeTouch<D>& touch, const Vec<D>& impulse, double theta_h);

/// The velocity of the shape after a step without contacts, by the forces in the middle of the step.
template <int D>
void accelerate_shape(Body<D>& body, double h, double theta);

/// Gives the shape the velocity again that accelerate_shape gave it in this step, which began with `start`,
/// without the impulses since.
template <int D>
void take_back_pushes(Body<D>& body, const Breathing::State& start, double h, double theta);

/// Moves the shape with its velocity for dt [s].
template <int D>
void move_shape(Body<D>& body, double dt);

/// The energy that the shape holds at rest [J]: of gas, springs and strain. The kinetic one is in that of the
/// body.
template <int D>
double potential_energy_of_shape(const Body<D>& body);

}  // namespace flyrock
