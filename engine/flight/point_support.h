#pragma once
// What holds a point that is on the ground.

#include "flight/face.h"
#include "flight/point_contact.h"
#include "flight/slide.h"

namespace flyrock {

/// The faces that carry a point: none in flight, one on a face, two on the edge of a valley or, in 2D, at its
/// bottom.
template <int D>
struct Support {
  const Face<D>*face = nullptr, *other = nullptr;  ///< null: none
  Sliding<D> sliding;
  bool rolls = false;    ///< its friction is rolling resistance
  bool constant = true;  ///< its friction stays the same along its way
  bool stays = false;    ///< it does not move
};

/// The support of a point at `at` with the velocity v [m/s] that approaches none of `faces`, on all of which
/// it is. `force` [m/s2]: gravity and the push of the air. A component of the velocity slower than `slow`
/// that leads out of a valley counts as 0, because the point would return at once.
template <int D>
Support<D> support_of(PointContact<D>& contact, const std::vector<Face<D>>& faces, double time,
                      const Vec<D>& at, const Vec<D>& v, const Vec<D>& force, double slow);

/// The speed up to which a motion along a normal is rounding [m/s].
inline double rounding_of_speed(double speed) { return 1e-10 + 1e-9 * speed; }

}  // namespace flyrock
