#pragma once
// Volume, centroid and inertia of bodies in 3D.

#include <vector>

#include "geometry/contactor3.h"

namespace flyrock {

/// Properties for a density of 1, in the frame of the contactors.
struct VolumeProperties {
  double volume = 0;  ///< m3
  Vec3 centroid = Vec3::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< integral of (r.r 1 - r r^T) about the centroid [m5]
};

/// The properties of contactors that do not overlap; 0 for a surface, which does not move freely. They are
/// exact: a pill is a cylinder and two half-spheres, and a polyhedron, convex or not, is a sum of tetrahedra
/// over its faces (divergence theorem):
///   integral of r r^T over (0, a, b, c) = det(a, b, c)/120 (a a^T + b b^T + c c^T + (a+b+c)(a+b+c)^T).
VolumeProperties volume_properties(const std::vector<Contactor3>& contactors);

/// The principal moments in ascending order and the right-handed principal frame. If the tensor is diagonal
/// to 1e-12, the frame is the identity and the moments are in the order of the axes.
struct PrincipalFrame {
  Vec3 moments = Vec3::Zero();
  Rotation3 rotation;  ///< from the principal frame to the frame of the tensor
};
PrincipalFrame principal_frame(const Eigen::Matrix3d& inertia);

}  // namespace flyrock
