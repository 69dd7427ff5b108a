#pragma once
// A point that slides on the ground with friction.

#include "flight/arc.h"

namespace flyrock {

/// A point on a face, or in 3D on the edge where two faces meet. Its acceleration along the ground is
///   dv/dt = pull - friction v/|v|.
template <int D>
struct Sliding {
  Vec<D> velocity = Vec<D>::Zero();  ///< m/s, along the ground
  Vec<D> pull = Vec<D>::Zero();      ///< m/s2, the part along the ground of gravity and the push of the air
  double friction = 0;               ///< m/s2, of a point that slides
  double holds = 0;                  ///< m/s2, of a point at rest, at least `friction`

  /// Whether it is at rest and stays so.
  bool at_rest() const { return velocity.isZero(0) && pull.norm() <= holds; }
  /// The present acceleration [m/s2].
  Vec<D> acceleration() const;
};

/// The path from `position` on, for at most `longest` > 0 seconds. It ends earlier where the point stops, and
/// where it falls below the speed `slow` [m/s] (0: never), so that both are at the end of an arc. The path is
/// a parabola in 2D, without friction, and where the velocity is parallel to the pull. Otherwise the velocity
/// turns towards the pull. With the angle a between them, u = tan(a/2), k = friction/|pull| and
/// r = u/u0, the motion has the closed form
///   |v| = A (r^(k-1) + u0^2 r^(k+1)),  A = |v0|/(1 + u0^2),
///   t   = A/|pull| (P(k-1) + u0^2 P(k+1)),  P(q) = (1 - r^q)/q,
///   along the pull   A^2/|pull| (P(2k-2) - u0^4 P(2k+2)),
///   across it      2 A^2/|pull| (u0 P(2k-1) + u0^3 P(2k+1)),
/// and the arc is the polynomial through its two ends, over a turn of at most 0.1 rad. `stops` is set where
/// the end is a stop.
template <int D>
Arc<D> slide(double start, double longest, const Vec<D>& position, const Sliding<D>& sliding, double slow,
             bool& stops);

}  // namespace flyrock
