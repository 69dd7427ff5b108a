#pragma once
// Loads that change over time: gravity, forces, the velocities of driven bodies.
//
// A run goes on piece by piece (OverTime::end_of_piece). In a piece, gravity and forces act with their mean,
// and a driven body has the constant acceleration by which its velocity follows the table.

#include <vector>

#include "math/over_time.h"
#include "world/world.h"

namespace flyrock {

/// The tables outlive the run.
struct LoadTables {
  const OverTime* gravity = nullptr;  ///< m/s2; null: that of the world
  /// Of each body, or empty: the force on one that moves [N], the velocity of a driven one [m/s]; null: none.
  std::vector<const OverTime*> of_body = {};
  double last_change = 0;  ///< s, of all tables, also of those that laws read: nothing is at rest before

  /// Gives the world the loads of the piece of time that begins at `now` [s], and returns the end of the
  /// piece. While it settles, it has those of time 0, and driven bodies stand.
  template <int D>
  double apply(World<D>& world, double now) const;

 private:
  double end_of_piece(double now) const;
};

}  // namespace flyrock
