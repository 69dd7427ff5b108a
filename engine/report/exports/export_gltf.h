#pragma once
// Exports moving rocks for viewers of 3D models.

#include <filesystem>
#include <vector>

namespace flyrock {

/// Writes into `folder`, for each sweep point with stored trajectories in the database `results`, the file
/// motion-p<point>.glb: the ground of trial 0 (in 2D as lines), and a node for each stored rock and each
/// fixture, with its surface (rock_shape.h), which moves from stored point to stored point. A rock stays at
/// its first place before its path begins, and at its last one after it. Extras of a rock are trial, rock,
/// group and runout_m. Extras of the file: crs, where it is known, and origin_m, which is added to all places
/// to give those of the results: whole kilometres, because numbers of 32 bits are coarse far from 0. Returns
/// the files; none if no trajectory is stored. Throws FileError.
std::vector<std::filesystem::path> export_gltf(const std::filesystem::path& results,
                                               const std::filesystem::path& folder);

}  // namespace flyrock
