#pragma once
// How far a body reaches along a direction.

#include <algorithm>

#include "world/body.h"

namespace flyrock {

/// The extent of a body about its centre of mass along a direction [m].
struct Reach {
  double low = 1e300, high = -1e300;
};

/// `direction` is a unit vector in the world frame.
template <int D>
Reach reach_of(const Body<D>& body, const Vec<D>& direction) {
  Reach reach;
  for (const auto& contactor : body.contactors) {
    if constexpr (D == 3)
      for (const Contactor3::Circle& circle : contactor.circles) {
        const double middle = direction.dot(body.attitude.rotation * circle.centre);
        const double extent =
            circle.radius * circle.across(body.attitude.rotation.inverse(direction)).norm() +
            contactor.radius;
        reach.low = std::min(reach.low, middle - extent);
        reach.high = std::max(reach.high, middle + extent);
      }
    for (const Vec<D>& local : contactor.points) {
      const Vec<D> point = body.attitude.rotation * local;
      const double along = direction.dot(point);
      reach.low = std::min(reach.low, along - contactor.radius);
      reach.high = std::max(reach.high, along + contactor.radius);
    }
  }
  return reach;
}

}  // namespace flyrock
