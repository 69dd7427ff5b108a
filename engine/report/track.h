#pragma once
// Trajectories thinned to what a plot can show.

#include <cstddef>
#include <vector>

#include "batch/records.h"

namespace flyrock {

/// The indices of `points` that a poly-line within `tolerance` [m] of all of them keeps, in the plane of x and
/// height (Ramer 1972, Douglas and Peucker 1973). First and last are always kept.
std::vector<std::size_t> simplify(const std::vector<Vec2>& points, double tolerance);

/// The rows of one rock's path within the records of a point.
struct Track {
  std::uint64_t trial = 0;
  int rock = 0;
  std::size_t begin = 0, end = 0;
};

/// Rows that follow each other and belong to the same rock.
std::vector<Track> tracks_of(const std::vector<TrajectoryRecord>& rows);

}  // namespace flyrock
