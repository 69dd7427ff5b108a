#pragma once
// The mass, centre and inertia that a shape gives in place of those of its contactors.

#include <optional>
#include <string>
#include <type_traits>

#include "math/space.h"

namespace flyrock {

/// What is left out follows from the contactors, filled evenly. Frame of the contactors.
template <int D>
struct OwnMass {
  /// About the centre of mass [kg m2]: the moment in 2D, the tensor in 3D.
  using Inertia = std::conditional_t<D == 2, double, Eigen::Matrix3d>;

  std::optional<double> mass;      ///< kg
  std::optional<Vec<D>> centre;    ///< of mass [m]
  std::optional<Inertia> inertia;  ///< needs `mass`

  bool given() const { return mass || centre || inertia; }
};

/// Why no body has these; empty if one may: mass and inertia are positive, a tensor is symmetric and none of
/// its principal moments exceeds the sum of the other two, a centre comes with an inertia about it.
std::string fault(const OwnMass<2>& own);
std::string fault(const OwnMass<3>& own);

}  // namespace flyrock
