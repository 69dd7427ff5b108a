#pragma once
// The gap between the bounding balls of two moving contactors.

#include <array>

#include "collision/advancement3.h"
#include "collision/round_path.h"

namespace flyrock {

/// As a polynomial of t that is not greater than the gap of the contactors near 0 [m]; for a facet, the gap
/// between the ball and its plane.
inline std::array<double, 5> ball_clearance(const MovingContactor& a, const MovingContactor& b,
                                            const TouchSearch& search) {
  if (const Facet* f = b.facet)
    return {f->distance(a.motion.x) - a.shape.bound + search.slack, f->normal.dot(a.motion.v),
            0.5 * f->normal.dot(a.motion.a), 0, 0};
  Path<3> relative = a.motion;
  relative.x -= b.motion.x;
  relative.v -= b.motion.v;
  relative.a -= b.motion.a;
  const double balls = a.shape.bound + b.shape.bound;
  return ball_gap(relative, balls, relative.x.norm() - balls + search.slack);
}

}  // namespace flyrock
