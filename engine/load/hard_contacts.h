#pragma once
// Contacts that are hard or impossible to solve numerically. They are found from masses, shapes and laws
// before anything moves.

#include <string>
#include <vector>

#include "trial/build_trial.h"

namespace flyrock {

/// A spring (`penalty`) of stiffness k oscillates by h sqrt(k W_nn) [rad] in a step h. Bounces are inaccurate
/// above 0.5 rad and gain energy above 2 rad.
inline constexpr double inaccurate_spring = 0.5, unstable_spring = 2;

/// A spring and its angle per time step.
struct SpringSwing {
  int material = 0;      ///< index into Scenario::materials
  double angle = 0;      ///< rad per step, the greatest of the material
  double stiffness = 0;  ///< N/m
  std::string bodies;    ///< "`ball`", "`ball` and `box`"
};

/// For each material whose law is a spring, the contact with the greatest angle per step, over all bodies and
/// pairs of bodies. W_nn is 1/m + (lever x n) I^-1 (lever x n), with the lever of the outermost vertex and
/// the normal of a face.
template <int D>
std::vector<SpringSwing> spring_swings(const Scenario& scenario, const Instances& instances,
                                       const World<D>& world, const WorldLaws& laws);

/// A moving body with corners that can touch something by a restitution law of form `velocity`.
struct CornerUnderLaw {
  int material = 0;  ///< index into Scenario::materials
  int body = 0;      ///< of the world
};
template <int D>
std::vector<CornerUnderLaw> corners_under_laws(const Scenario& scenario, const Instances& instances,
                                               const World<D>& world, const WorldLaws& laws);

/// The heaviest and the lightest moving body of a world.
struct MassRatio {
  int heavy = -1, light = -1;  ///< bodies of the world; -1: fewer than two move
  double ratio = 1;
};
template <int D>
MassRatio mass_ratio(const World<D>& world);

}  // namespace flyrock
