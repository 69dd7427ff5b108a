#include "load/pile_cost.h"

#include <fmt/format.h>

#include <cmath>

namespace flyrock {

std::string pile_cost_note(const Scenario& scenario, std::size_t bodies) {
  constexpr double of_2d = 25e-6, of_3d = 0.13e-3;  // s, of a body and step
  constexpr std::size_t few = 20;                   // bodies, which make no pile
  constexpr double minute = 60;
  if (bodies < few) return {};
  if (scenario.solver.dense.bodies == "exact")
    return fmt::format(
        "{} bodies that may meet: with `solver.bodies: exact` each touch of two cuts the step of all, and a "
        "pile of them may not come to its end; `auto` is for piles",
        bodies);
  const double steps = scenario.stop.time / scenario.solver.dense.time_step;
  const double seconds = static_cast<double>(bodies) * steps * (scenario.dimension == 2 ? of_2d : of_3d);
  if (seconds < minute) return {};
  const double hours = static_cast<double>(scenario.trials) * seconds / (60 * minute);
  const std::string of_all =
      scenario.trials > 1 ? fmt::format(", {:.2g} h for all {}", hours, scenario.trials) : "";
  return fmt::format(
      "{} bodies that may meet: if they pile up and move until stop.time, a trial takes about "
      "{:.0f} min of processor time{}",
      bodies, std::ceil(seconds / minute), of_all);
}

}  // namespace flyrock
