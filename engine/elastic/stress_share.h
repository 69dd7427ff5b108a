#pragma once
// What share of a block bears how much stress.

#include <optional>

#include "elastic/elastic_model.h"

namespace flyrock {

/// The greatest and the least principal stress of a cell [Pa], tension positive; in 2D of those in the plane.
struct PrincipalStress {
  double greatest = 0, least = 0;
};
PrincipalStress principal_stress(const ElasticModel<2>& model, int cell, const Eigen::VectorXd& u);
PrincipalStress principal_stress(const ElasticModel<3>& model, int cell, const Eigen::VectorXd& u);

/// Principal stresses by volume: the greatest stress of a mesh is no result, because it grows
/// with each refinement under a contact. Tension positive, and so is compression [Pa].
struct StressShare {
  double tension = 0;         ///< the greatest principal stress exceeds it in 1 % of the volume
  double compression = 0;     ///< the least one is below its negative in 1 % of the volume
  double above_strength = 0;  ///< share of the volume in which the greatest one exceeds the strength
};

/// `strength` [Pa]: without one the share is NaN.
template <int D>
StressShare stress_share(const ElasticModel<D>& model, const Eigen::VectorXd& u,
                         const std::optional<double>& strength);

}  // namespace flyrock
