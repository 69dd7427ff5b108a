#pragma once
// Gates and barriers (world/places.h) on the way of a world's bodies. In flight the moment of arrival is that
// of the parabola; within a step in contact the centre of mass moves on a straight line.

#include <span>
#include <vector>

#include "world/places.h"
#include "world/world.h"

namespace flyrock {

/// When a path arrives at the place x [m], which lies on its side `side` (+1 right, -1 left) [s]: 0 where it
/// is there already, infinity where it never does.
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
  /// The world has moved by dt, and the body along `motion` from the time `start`: gates and barriers act.
  /// Whether a barrier has caught the body.
  bool moved(int body, const Motion& motion, double start, double dt);

 private:
  bool catches(int barrier, int body);
  double height(const Vec<D>& place, double x) const;  ///< above the ground at x

  World<D>& world_;
  std::span<const Gate> gates_;
  std::span<const Barrier> barriers_;
  std::vector<BodyHistory>& histories_;
  std::vector<Sides> gate_side_, barrier_side_;  ///< [body]
};

}  // namespace flyrock
