#include "blast/bench_fit.h"

#include <cmath>

namespace flyrock {

BenchFit bench_fit(BenchRock rock, bool anfo) {
  switch (rock) {
    case BenchRock::limestone:
      return {3e6, 200};
    case BenchRock::granite:
      return anfo ? BenchFit{3.487e6, 584} : BenchFit{3.66e6, 518};
  }
  return {};
}

double squared_speed(const BenchFit& fit, BenchFitForm form, double charge_to_mass) {
  const double f = form == BenchFitForm::linear ? charge_to_mass : std::sqrt(charge_to_mass);
  return fit.slope * f - fit.offset;
}

}  // namespace flyrock
