#pragma once
// Sets of joints in a survey: a mixture of axial Fisher distributions and a uniform rest, fitted by EM.

#include <cstdint>
#include <vector>

#include "math/space.h"

namespace flyrock {

/// The range of the k of a set: one that is wider says nothing else than a uniform rest; the scatter of the
/// closest, 1.3 deg, is below that of a compass.
inline constexpr double least_fisher_k = 3, most_fisher_k = 2000;

/// A set: its share of the poles and the density of an axis x (a unit vector and its opposite are one axis)
///   f(x) = k / (4 pi sinh k) cosh(k mean.x).
struct FisherSet {
  Vec3 mean = Vec3::UnitZ();  ///< unit, upwards
  double k = 0;
  double share = 0;  ///< of the weights of the poles
};

/// A mixture: the sets, in falling order of their shares, and a uniform rest of density 1/(4 pi).
struct SetMixture {
  std::vector<FisherSet> sets;
  double rest = 0;  ///< share of the poles that belong to no set
  double log_likelihood = 0;
  double bic = 0;  ///< 4 sets ln(n) - 2 log_likelihood; the least is the best
};

/// Poles of planes with weights, whose sum is the number of poles.
struct Poles {
  std::vector<Vec3> poles;  ///< unit; the sign does not matter
  std::vector<double> weights;
};

/// The mixture of `sets` sets with the greatest likelihood that several random starts find.
SetMixture fit_sets(const Poles& poles, int sets, std::uint64_t seed);

/// The mixture of 1 to `most` sets with the least BIC.
SetMixture fit_sets_by_bic(const Poles& poles, int most, std::uint64_t seed);

/// The fit that follows from another one, for poles drawn again (bootstrap): its sets stay in their order.
SetMixture fit_sets_from(const Poles& poles, SetMixture start);

/// The set that each pole most likely belongs to; -1: the rest.
std::vector<int> sets_of(const Poles& poles, const SetMixture& mixture);

}  // namespace flyrock
