#pragma once
// How far a body reaches along a direction.

#include <algorithm>

#include "world/body.h"

namespace flyrock {

/// The extent of a body about its centre of mass along a direction [m].
struct Extent {
  double low = 1e300, high = -1e300;
};

/// `direction` is a unit vector in the world frame.
template <int D>
Extent extent_along(const Body<D>& body, const Vec<D>& direction) {
  Extent extent;
  for (const auto& contactor : body.contactors) {
    if constexpr (D == 3)
      for (const Contactor3::Circle& circle : contactor.circles) {
        const double middle = direction.dot(body.attitude.rotation * circle.centre);
        const double half = circle.radius * circle.across(body.attitude.rotation.inverse(direction)).norm() +
                            contactor.radius;
        extent.low = std::min(extent.low, middle - half);
        extent.high = std::max(extent.high, middle + half);
      }
    for (const Vec<D>& local : contactor.points) {
      const Vec<D> point = body.attitude.rotation * local;
      const double along = direction.dot(point);
      extent.low = std::min(extent.low, along - contactor.radius);
      extent.high = std::max(extent.high, along + contactor.radius);
    }
  }
  return extent;
}

}  // namespace flyrock
