#pragma once
// Volume, centroid and inertia of bodies of space.

#include <vector>

#include "geometry/contactor3.h"

namespace flyrock {

/// Of density 1, in the frame of the contactors.
struct VolumeProperties {
  double volume = 0;  ///< m3
  Vec3 centroid = Vec3::Zero();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< integral of (r.r 1 - r r^T) about the centroid [m5]
};

/// Of contactors that do not overlap. Exact: a polyhedron is a sum of tetrahedra over its faces (the
/// divergence theorem), with integral of r r^T over (0, a, b, c) = det(a, b, c)/120 (a a^T + b b^T + c c^T +
/// (a+b+c)(a+b+c)^T).
VolumeProperties volume_properties(const std::vector<Contactor3>& contactors);

/// Principal moments, ascending, and the principal frame, right-handed; the frame is the identity and the
/// moments in the order of the axes where the tensor is diagonal to 1e-12.
struct PrincipalFrame {
  Vec3 moments = Vec3::Zero();
  Rotation3 rotation;  ///< from the principal frame to that of the tensor
};
PrincipalFrame principal_frame(const Eigen::Matrix3d& inertia);

}  // namespace flyrock
