#pragma once
// The grammar of measures, which `expect` compares with values.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "units/units.h"

namespace flyrock {

/// The names that a measure may use.
struct MeasureNames {
  int dimension = 2;
  std::vector<std::string> bodies;
  std::vector<std::string> links;
  std::vector<std::string> hinges;  ///< those of the links
  std::vector<std::string> groups;
  std::vector<std::string> gates;
  std::vector<std::string> barriers;
  std::vector<std::string> clearances;
  std::vector<std::string> with_factor;  ///< clearances that have a factor
  std::vector<std::string> exposures;
  bool forest = false;                    ///< the scenario has trees
  bool series = false;                    ///< the scenario asks for output.series
  std::vector<std::string> regions = {};  ///< of output.series
};

struct MeasureInfo {
  Dimension dimension;
  std::string fault;  ///< why it is not a measure, with the nearest name; empty if it is one
};

/// Checks a measure. docs/results.md describes what each means. The grammar:
///   body.<name>.final|max|min.<component>, body.<name>.stop_time|contact_time,
///   body.<name>.impact[n].<quantity>, body.<name>.apex[n].time|height,
///   body.<name>.<quantity of a deformable one>.max|min|final,
///   assembly.<component>.mean|min|max, assembly.at_rest,
///   contact.<a>.<b>.gap|un|ut|rn|rt.mean|max|min|final|at[time], a and b bodies, b also `terrain`,
///   link.<name>.force|length|angle.mean|max|min|final|at[time], angle of a hinge only,
///   link.<name>.impulse.mean|max|min|final, of impacts,
///   region.<name>.porosity|stress_xx|stress_yy|...mean|max|min|final|at[time],
///   energy.total.relative_change, solver.<quantity>,
///   rocks[.<group>].<quantity>.<statistic>, rocks[.<group>].count|censored,
///   gate.<name>.passed[.per_trial]|per_trial|mean_energy|p95_energy|p95_height,
///   barrier.<name>.reached|caught|over_top|over_energy|past[.of_arriving|.per_trial],
///   trees.hit|stopped|hits,
///   clearance.<name>.distance|lower|upper|with_factor,
///   exposure.<name>.per_blast|per_year|hits_per_m2
MeasureInfo check_measure(std::string_view measure, const MeasureNames& names);

/// All measures of rocks, gates, barriers, trees, clearances and exposures. Of several groups, those of all
/// rocks come first.
std::vector<std::string> measures_of_rocks(const MeasureNames& names);

/// The steps of a measure: "contact", "ball", "terrain", "rn", "at[0.5 s]".
std::vector<std::string> measure_steps(std::string_view measure);

/// The time [s] of a step "at[0.5 s]"; nothing if it is none. A bare number is in seconds.
std::optional<double> time_of_step(std::string_view step);

/// Quantities of rocks. A group cannot have one of these names.
std::vector<std::string> rock_quantities();

}  // namespace flyrock
