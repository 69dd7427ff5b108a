#pragma once
// Gates, barriers (world/places.h) and trees (world/tree_law.h) on the paths of a world's bodies. In free
// flight the time of arrival is computed on the parabola. In a contact step the centre of mass moves on a
// straight line.

#include <span>
#include <vector>

#include "flight/tree_watch.h"
#include "world/places.h"
#include "world/world.h"

namespace flyrock {

/// The time [s] at which a path arrives at the position x [m] along an axis, which lies on its side `side`
/// (+1 towards greater x, -1 towards smaller). 0 if the path starts there or beyond, infinity if it never
/// arrives.
template <int D>
double arrival(const Path<D>& path, double x, int side, int axis);

template <int D>
class Crossings {
 public:
  using Motion = typename Geometry<D>::Motion;

  /// Gates, barriers and trees must outlive the object. It appends passages of gates and hits of barriers and
  /// trees to the histories. `keys`: one per body, for its random numbers at trees; may be empty if there are
  /// no trees.
  Crossings(World<D>& world, std::span<const Gate> gates, std::span<const Barrier> barriers,
            const RunForest& trees, std::span<const DrawKey> keys, std::vector<BodyHistory>& histories);

  /// The time until a body on `path` arrives at its next barrier [s]; infinity if it does not.
  double time_to_barrier(int body, const Path<D>& path) const;
  /// The time until a body on `path` hits a tree that changes its motion, within `longest` [s]; infinity if
  /// it does not.
  double time_to_tree(int body, const Path<D>& path, double longest) const;
  /// Applies gates, barriers and trees after the world has moved by dt, and the body along `motion` from the
  /// time `start`. Returns whether a barrier or a tree has caught the body.
  bool moved(int body, const Motion& motion, double start, double dt);

 private:
  bool catches(int barrier, int body, const Approach::Arrival& at);
  bool caught_by_tree(int body, const Motion& motion, double start, double dt);
  /// The kinetic energy along a motion [J].
  double energy_at(int body, const Motion& motion, double t) const;
  /// The height of `position` above the ground after it is moved in plan to `at`, where the body crosses a
  /// gate or barrier [m]; infinity if there is no ground.
  double height(const Vec<D>& position, const Vec2& at) const;

  World<D>& world_;
  std::span<const Gate> gates_;
  std::span<const Barrier> barriers_;
  std::vector<BodyHistory>& histories_;
  std::vector<std::vector<Approach>> to_gates_, to_barriers_;  ///< [body][place]
  std::vector<TreeWatch<D>> trees_;                            ///< of each body; none without a forest
};

}  // namespace flyrock
