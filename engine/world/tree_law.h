#pragma once
// What a tree does to a rock that hits it: it takes energy and turns its direction.
//
// Energy. Of the kinetic energy E (translation and rotation) a stem takes at most
//   E_tree = factor s energy                                    (fixed)
//   E_tree = factor s 38.7 J (d / cm)^2.31 share(x)             (dorren_berger)
//   share(x) = -0.046 + 1.026 / (1 + 10^(-8.007 (0.58 - x))), within [0, 1]
// with the diameter at breast height d, the factor s of the species (1: silver fir) and the eccentricity x in
// [0, 1]: the distance of the place of the hit from the axis of the stem, across the motion in plan, over the
// radius of the stem. Velocity and spin are scaled by sqrt(1 - E_taken / E). The rock stops at the stem if
// E <= E_tree.
//
// Direction. The horizontal velocity turns by the angle `turn`, away from the axis of the stem if it is
// positive; to the right in a hit without eccentricity.
//
// Unverified: dorren_berger is as others cite Dorren & Berger (2006), whose article was not read.

#include <cstdint>

#include "geometry/forest.h"
#include "random/distribution.h"
#include "record/observe.h"

namespace flyrock {

struct TreeLaw {
  bool fixed = false;                ///< the energy is the same for each tree
  double energy = 0;                 ///< J, with `fixed`
  double factor = 1;                 ///< on the energy of all trees
  double turn = 0;                   ///< rad
  const Draw* turn_draw = nullptr;   ///< rad, drawn at each hit; null: the constant
  const Streams* streams = nullptr;  ///< of `turn_draw`

  /// Whether no tree changes the motion of a rock. Paths then go on through the trees.
  bool is_passive() const { return (fixed ? energy : 1.0) * factor == 0 && turn == 0 && !turn_draw; }
  /// The energy that a stem takes at most [J].
  double energy_of(const Stem& stem, double eccentricity) const;
};

/// What a hit does to a rock: velocity and spin are scaled by `left`, the horizontal velocity then turns by
/// `turn` [rad], counter-clockwise.
struct TreeEffect {
  double left = 1, turn = 0;
};

/// The effect on a rock of kinetic energy E [J] whose centre is at `place` and moves with `velocity` in plan.
/// `key` is that of the rock, `tree` the index of the stem.
TreeEffect effect_of(const TreeLaw& law, const Stem& stem, int tree, double energy, const Vec2& place,
                     const Vec2& velocity, DrawKey key);

/// The trees of a run, for all of its rocks. Without a forest there are none.
struct RunForest {
  const Forest* forest = nullptr;
  TreeLaw law;
};

}  // namespace flyrock
