#pragma once
// Points of a sweep that lost too many rocks: what is left of them says nothing about the others.

#include <string>

#include "results/measured/measures.h"

namespace flyrock {

/// Share of the rocks of a point that may fail (diverged, plugin_error, not_started). Above it the point has
/// no percentiles, shares and clearances, because rocks do not fail at random.
inline constexpr double most_lost = 0.05;

/// Whether a point lost more rocks than that. Scenarios of `bodies` have no percentiles to lose.
bool has_lost(const Scenario& scenario, const GroupSummary& all);
inline bool has_lost(const Scenario& scenario, const PointResult& point) {
  return has_lost(scenario, point.groups.front());
}

/// "lost: 6 of 100 rocks failed, and above 5 % nothing is said of the others"
std::string lost_text(const PointResult& point);

}  // namespace flyrock
