#include "verify/check.h"

#include <cmath>

namespace flyrock {

void add_worst(Checks& checks, const std::string& name, const std::string& kind, double tolerance,
               const std::vector<Compared>& numbers) {
  const Compared* worst = nullptr;
  double error = -1;
  for (const Compared& number : numbers) {
    // Written in this form so that NaN counts as the worst number.
    const double difference = std::abs(number.computed - number.expected);
    if (difference <= error) continue;
    worst = &number;
    if (std::isnan(difference)) break;
    error = difference;
  }
  const bool passed = std::abs(worst->computed - worst->expected) <= tolerance;
  checks.push_back({name + ": " + worst->name, kind, worst->computed, worst->expected, tolerance, passed});
}

Checks all_checks(const std::string& share) {
  Checks checks;
  check_oblique_ball(checks);
  check_worked_impacts(checks);
  check_ball_rows(checks);
  check_painleve_rod(checks);
  check_random_impacts(checks);
  check_lumped_mass(checks);
  check_turning_contacts(checks);
  check_launch_formulas(checks);
  check_scenarios(checks, share);
  return checks;
}

}  // namespace flyrock
