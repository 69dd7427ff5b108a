#include "results/measured/over_steps.h"

#include <fmt/format.h>

#include <algorithm>

namespace flyrock {

OverSteps::Answer OverSteps::of(const std::vector<Instant>& instants, const std::string& whose) const {
  if (instants.empty()) return {0, whose + (is_of_impacts ? " at an impact" : " in a step")};
  const auto less = [](const Instant& l, const Instant& r) { return l.value < r.value; };
  if (of_time == "final") return {instants.back().value, {}};
  if (of_time == "max") return {std::max_element(instants.begin(), instants.end(), less)->value, {}};
  if (of_time == "min") return {std::min_element(instants.begin(), instants.end(), less)->value, {}};
  if (of_time == "at") {
    for (const Instant& instant : instants)
      if (time <= instant.time && time > instant.time - instant.step) return {instant.value, {}};
    return {0, fmt::format("{} at {} s", whose, time)};
  }
  double sum = 0, weights = 0;
  for (const Instant& instant : instants) {
    const double weight = instant.step > 0 ? instant.step : 1;
    sum += weight * instant.value;
    weights += weight;
  }
  return {sum / weights, {}};
}

}  // namespace flyrock
