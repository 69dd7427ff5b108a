#pragma once
// Stored trajectories for ParaView.

#include <filesystem>
#include <vector>

namespace flyrock {

/// Writes into `folder`, for each sweep point that has stored trajectories in the database `results`,
///   trajectories-p<point>.vtp   a poly-line a rock; of its points: time_s, speed_m_s, energy_J, mode; of the
///   line: trial,
///                               rock, runout_m, diameter_m (of the sphere of the rock's volume)
///   ground-p<point>.vtp         the ground of trial 0 (its section at y = 0 in 3D), a line a segment with
///   its part rocks-p<point>.pvd          the rocks over time, in at most 500 steps of a round number of
///   seconds, from the files rocks-p<point>/<step>.vtp   with the same numbers, linear between stored points;
///   a rock that has ended stays
/// `mode` is the place in travel_mode_names. Returns the files but those of the steps; none where no
/// trajectory is stored. Throws FileError.
std::vector<std::filesystem::path> export_vtk(const std::filesystem::path& results,
                                              const std::filesystem::path& folder);

}  // namespace flyrock
