#pragma once
// What makes the numbers of a run doubtful, so that the report shows it in red: the least of it that a reader
// must act upon. Rocks that failed are in results/say/fault_line.h. All else that the solver has to tell is
// no alarm.

#include <string>
#include <vector>

#include "results/results.h"

namespace flyrock {

/// A rock may lie this deep in the ground or in another rock, as a share of the size of the smallest rock.
inline constexpr double most_penetration = 1e-3;
/// The greatest residual of a contact problem [m/s].
inline constexpr double most_residual = 1e-3;

/// The diameter of the sphere with the volume of the smallest rock of the first trial [m]; infinite without
/// rocks.
double least_size(const PointResult& point);

/// A sentence for each alarm of each point.
std::vector<std::string> alarms(const std::vector<PointResult>& points);

}  // namespace flyrock
