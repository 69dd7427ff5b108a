#pragma once
// The places of an ellipse that are farthest from the origin.

#include <boost/container/static_vector.hpp>

#include "math/space.h"

namespace flyrock {

/// The angles phi [rad] at which |c + a cos phi + b sin phi| is greatest locally: one or two, the greatest
/// one first. With the angle delta that makes a and b the axes of the ellipse, psi = phi - delta,
///   |...|^2 = const + P cos psi + Q sin psi + R cos 2 psi,   R >= 0,
/// whose greatest value lies in the quadrant of the signs of P and Q. Its slope has one zero there. The other
/// greatest value, if there is one, lies on the other side of the axis of P. A circle about the origin is
/// equally far everywhere: the answer is 0.
boost::container::static_vector<double, 2> farthest_on_ellipse(const Vec2& c, const Vec2& a, const Vec2& b);

}  // namespace flyrock
