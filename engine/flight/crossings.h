#pragma once
// Gates, which look at what passes them, and barriers, which hold it.
//
// Both stand at an x of the terrain (in 3D a vertical plane across x) and act once on each body: when its centre of mass first arrives there from the side
// on which it started (a body that starts at x arrives at once). In flight the moment is that of the parabola; within a
// step in contact the centre of mass moves on a straight line.

#include <span>
#include <vector>

#include "world/world.h"

namespace flyrock {

struct Gate {
  double x = 0;  ///< m
};

/// A fence or berm. A body that arrives at `height` above the ground or higher goes on over the top. Lower, it is caught
/// where its kinetic energy E, of translation and rotation, is at most `capacity`; else it goes through, and its
/// velocity and spin are scaled by sqrt(1 - capacity / E), which takes `capacity` from its energy.
struct Barrier {
  double x = 0;         ///< m
  double height = 0;    ///< m above the ground at x
  double capacity = 0;  ///< J
};

/// When a path arrives at the place x [m], which lies on its side `side` (+1 right, -1 left) [s]: 0 where it is there
/// already, infinity where it never does.
template <int D>
double arrival(const Path<D>& path, double x, int side);

template <int D>
class Crossings {
 public:
  using Motion = typename Geometry<D>::Motion;

  /// Gates and barriers outlive the object. Passages and barriers met are appended to the histories.
  Crossings(World<D>& world, std::span<const Gate> gates, std::span<const Barrier> barriers,
            std::vector<BodyHistory>& histories);

  /// Until a body on `path` arrives at its next barrier [s]; infinity where it does not.
  double time_to_barrier(int body, const Path<D>& path) const;
  /// The world has moved by dt, and the body along `motion` from the time `start`: gates and barriers act. Whether a
  /// barrier has caught the body.
  bool moved(int body, const Motion& motion, double start, double dt);

 private:
  /// Places still ahead of a body: the side they lie on, +1 right, -1 left, or 0 once it has arrived.
  using Sides = std::vector<int>;
  bool meet(int body, int barrier);

  World<D>& world_;
  std::span<const Gate> gates_;
  std::span<const Barrier> barriers_;
  std::vector<BodyHistory>& histories_;
  std::vector<Sides> gate_side_, barrier_side_;  ///< [body]
};

}  // namespace flyrock
