#include "blast/gurney.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "math/space.h"

namespace flyrock {

double charge_to_mass(const Blast& blast) {
  const double burden = positive(blast, BlastField::burden);
  const double angle = positive(blast, BlastField::breakout_angle);
  if (angle >= pi)
    throw std::invalid_argument(fmt::format("blast.breakout_angle is {:.6g} rad, must be below pi", angle));
  const double rock = positive(blast, BlastField::rock_density) * burden * burden * std::tan(angle / 2);
  return linear_charge(blast) / rock;
}

bool is_usual_breakout(const Blast& blast) {
  constexpr double rounding = 1e-9;
  const double angle = blast[BlastField::breakout_angle];
  return angle >= pi / 2 - rounding && angle <= 2 * pi / 3 + rounding;
}

double gurney_factor(GurneyGeometry geometry, double charge_to_mass) {
  double gas = 0;  // share of the charge's own mass that moves with the rock
  switch (geometry) {
    case GurneyGeometry::roth:
      gas = 0;
      break;
    case GurneyGeometry::cylinder:
      gas = 1.0 / 2;
      break;
    case GurneyGeometry::sphere:
      gas = 3.0 / 5;
      break;
    case GurneyGeometry::sandwich:
      gas = 1.0 / 3;
      break;
  }
  return 1 / std::sqrt(1 / charge_to_mass + gas);
}

}  // namespace flyrock
