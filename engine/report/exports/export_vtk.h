#pragma once
// Exports stored trajectories for ParaView.

#include <filesystem>
#include <vector>

namespace flyrock {

/// Writes into `folder`, for each sweep point with stored trajectories in the database `results`:
///   trajectories-p<point>.vtp   one polyline for each rock. Point data: time_s, speed_m_s, energy_J, mode;
///                               line data: trial, rock, runout_m, diameter_m (of the sphere of the
///                               rock's volume)
///   ground-p<point>.vtp         the ground of trial 0 with its part: in 2D a line for each segment, in 3D
///                               the triangles where rocks were (report/pictures/ground_pictures.h)
///   rocks-p<point>.pvd          the rocks over time with the same data, linear between stored points, in
///                               at most 500 steps of a round number of seconds, one file
///                               rocks-p<point>/<step>.vtp per step; a rock that has ended stays
///   shapes-p<point>.pvd         the surfaces of the rocks in their orientations over time (vtk_shapes.h),
///                               one file shapes-p<point>/<step>.vtp per step
///   blocks-p<point>.vtp         the blocks between joints of trial 0 at the start, if there are any
///                               (stored_blocks)
///   meshes-p<point>.pvd         the meshes of deformable bodies (vtk_meshes.h), if the first trial has a
///                               series
///   contacts-p<point>.pvd       if the first trial has a series: the contacts that carry a force, as
///                               points with the vector force_N on the first body of the pair and the
///                               normal towards it, at the time (StoredContact::at)
///   network-p<point>.pvd        the same contacts as lines from centre to centre with normal_force_N
/// `mode` is the index in travel_mode_names. The field data `crs` of each file is the coordinate system,
/// where it is known. Returns the files except those of the steps; none if no trajectory is stored. Throws
/// FileError.
std::vector<std::filesystem::path> export_vtk(const std::filesystem::path& results,
                                              const std::filesystem::path& folder);

}  // namespace flyrock
