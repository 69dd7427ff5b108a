#include "world/places.h"

#include <cmath>

namespace flyrock {

BarrierOutcome outcome_of(const Barrier& barrier, const BarrierHit& hit) {
  if (hit.height >= barrier.height) return BarrierOutcome::over_top;
  return hit.kinetic_energy <= barrier.capacity ? BarrierOutcome::caught : BarrierOutcome::over_energy;
}

double velocity_left(const Barrier& barrier, const BarrierHit& hit) {
  return hit.outcome == BarrierOutcome::over_energy ? std::sqrt(1 - barrier.capacity / hit.kinetic_energy) : 1;
}

}  // namespace flyrock
