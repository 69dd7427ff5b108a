#pragma once
// How the pieces of a core, its points and circles, move along a direction.

#include <cmath>
#include <limits>
#include <vector>

#include "collision/advance_3d.h"

namespace flyrock {

/// The least height of a piece along a direction while bodies move, to first order:
///   h(t) = height + rate t - radius |across + t change|.
/// For a point the radius is 0. For a circle, every place p of it has a height and a rate that are linear in
/// p, so that the least of height + rate t over the circle is this. It is concave in t. `across` and `change`
/// are the direction and its rate, seen from the body, across the axis.
struct PieceHeight {
  double height = 0, rate = 0;                        ///< m, m/s: of the point or the centre
  double radius = 0, square = 0, half = 0, bend = 0;  ///< |across|^2, across . change, |change|^2

  double at(double t) const {
    if (radius == 0) return height + rate * t;
    return height + rate * t - radius * std::sqrt(std::max(0.0, square + t * (2 * half + t * bend)));
  }
  double slope() const {
    if (radius == 0) return rate;
    return rate - radius * (square > 0 ? half / std::sqrt(square) : std::sqrt(bend));
  }
};

/// The pieces of a core, along a direction that has these heights.
inline void piece_heights(const Contactor3& shape, const Heights& heights, std::vector<PieceHeight>& out) {
  out.clear();
  for (const Vec3& p : shape.points) out.push_back({heights.of(p), heights.rate(p)});
  for (const Contactor3::Circle& c : shape.circles) {
    const Vec3 across = c.across(heights.rise()), change = c.across(heights.change());
    out.push_back({heights.of(c.centre), heights.rate(c.centre), c.radius, across.squaredNorm(),
                   across.dot(change), change.squaredNorm()});
  }
}

}  // namespace flyrock
