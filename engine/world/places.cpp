#include "world/places.h"

#include <cmath>

namespace flyrock {

namespace {
BarrierOutcome outcome_of(const Barrier& barrier, const Arrival& arrival, double volume) {
  const double radius = std::cbrt(0.75 * volume / pi);
  if (barrier.height_factor * arrival.height + radius > barrier.height) return BarrierOutcome::over_top;
  return arrival.kinetic_energy <= barrier.capacity ? BarrierOutcome::caught : BarrierOutcome::over_energy;
}
}  // namespace

BarrierHit meet(const Barrier& barrier, int index, const Arrival& arrival, double volume) {
  return {arrival, index, outcome_of(barrier, arrival, volume)};
}

double velocity_left(const Barrier& barrier, const BarrierHit& hit) {
  return hit.outcome == BarrierOutcome::over_energy ? std::sqrt(1 - barrier.capacity / hit.kinetic_energy)
                                                    : 1;
}

}  // namespace flyrock
