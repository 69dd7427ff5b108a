#pragma once
// Gates and barriers (world/places.h) on the paths of a world's bodies. In free flight the time of arrival is
// computed on the parabola. In a contact step the centre of mass moves on a straight line.

#include <span>
#include <vector>

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

  /// Gates and barriers must outlive the object. Passages and barrier hits are appended to the histories.
  Crossings(World<D>& world, std::span<const Gate> gates, std::span<const Barrier> barriers,
            std::vector<BodyHistory>& histories);

  /// The time until a body on `path` arrives at its next barrier [s]; infinity if it does not.
  double time_to_barrier(int body, const Path<D>& path) const;
  /// Applies gates and barriers after the world has moved by dt, and the body along `motion` from the time
  /// `start`. Returns whether a barrier has caught the body.
  bool moved(int body, const Motion& motion, double start, double dt);

 private:
  bool catches(int barrier, int body, const Approach::Arrival& at);
  /// The height of `position` above the ground after it is moved in plan to `at`, where the body crosses a
  /// gate or barrier [m]; infinity if there is no ground.
  double height(const Vec<D>& position, const Vec2& at) const;

  World<D>& world_;
  std::span<const Gate> gates_;
  std::span<const Barrier> barriers_;
  std::vector<BodyHistory>& histories_;
  std::vector<std::vector<Approach>> to_gates_, to_barriers_;  ///< [body][place]
};

}  // namespace flyrock
