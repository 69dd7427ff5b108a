#pragma once
// The deformation of a block of finite elements, as a body has it.

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "math/space.h"

namespace flyrock {

template <int D>
struct ElasticBlock;

/// The displacements u of the nodes from their places in the rigid body and their rates, both in the frame of
/// the body, M-orthogonal to its rigid motion (elastic/elastic_model.h). The frame turns with the body; what
/// its turning does to the nodes (the centrifugal force and that of Coriolis) is left out. Of a rigid body
/// `block` is null. SI units.
///
/// Energy of a block with its contacts, of which `touch` is the loss:
///   m v.v/2 + w.J w/2 - m g.x + strain + vibration + damped + touch + settled = constant
template <int D>
struct Deformation {
  std::shared_ptr<const ElasticBlock<D>> block;
  Eigen::VectorXd u, rate;         ///< m, m/s: the components of node 0, of node 1, ...
  Eigen::VectorXd start, change;   ///< the rate at the start of the step; room for a change of it
  double greatest = 0;             ///< m, no node is displaced further
  std::optional<double> strength;  ///< Pa, in tension
  double damped = 0;               ///< J, by C, and by a theta above 1/2 of all motion of the block
  double touch = 0;                ///< J, what its contacts took from it and from what it touched
  double settled = 0;              ///< J, of small vibrations that were dropped in the air
  double at_release = 0;           ///< J, kinetic energy as a rigid body when a contact last pushed it

  bool moves() const { return block != nullptr; }
  double strain_energy() const;     ///< J
  double vibration_energy() const;  ///< J, kinetic, of the rates
  /// The node of the contactor with this index.
  int node_of(int contactor) const;
  Vec<D> place(int node) const;  ///< m, displaced, in the frame of the body
  Vec<D> displacement(int node) const { return u.template segment<D>(D * node); }
};

}  // namespace flyrock
