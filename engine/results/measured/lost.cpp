#include "results/measured/lost.h"

#include <fmt/format.h>

namespace flyrock {

bool has_lost(const Scenario& scenario, const GroupSummary& all) {
  return scenario.bodies.empty() &&
         static_cast<double>(all.faults) > most_lost * static_cast<double>(all.count);
}

std::string lost_text(const PointResult& point) {
  const GroupSummary& all = point.groups.front();
  return fmt::format("lost: {} of {} rocks failed, and above {:g} % nothing is said of the others",
                     all.faults, all.count, 100 * most_lost);
}

}  // namespace flyrock
