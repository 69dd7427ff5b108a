#pragma once
// Contacts that the numerics bear badly or not at all, as they follow from masses, shapes and laws before
// anything moves.

#include <string>
#include <vector>

#include "trial/build_trial.h"

namespace flyrock {

/// A spring (`penalty`) of stiffness k swings by h sqrt(k W_nn) in a step h: bounces are inaccurate above 0.5
/// rad and gain energy above 2.
inline constexpr double inaccurate_spring = 0.5, unstable_spring = 2;

/// A spring and the time step that it has.
struct SpringSwing {
  int material = 0;      ///< index into Scenario::materials
  double angle = 0;      ///< rad in a step, the greatest of the material
  double stiffness = 0;  ///< N/m
  std::string bodies;    ///< "`ball`", "`ball` and `box`"
};

/// For each material whose law is a spring the contact in which it swings farthest, of the body that moves
/// most by it: W_nn is 1/m + (lever x n) I^-1 (lever x n), the lever being that of the outermost vertex with
/// the normal of a face.
template <int D>
std::vector<SpringSwing> spring_swings(const Scenario& scenario, const Instances& instances,
                                       const World<D>& world, const Surfaces& surfaces);

/// The heaviest and the lightest body of a world that move.
struct MassRatio {
  int heavy = -1, light = -1;  ///< bodies of the world; -1: fewer than two move
  double ratio = 1;
};
template <int D>
MassRatio mass_ratio(const World<D>& world);

}  // namespace flyrock
