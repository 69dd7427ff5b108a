#pragma once
// Small systems whose rows may depend on each other.

#include <Eigen/Dense>

namespace flyrock {

inline constexpr int most_dependent_rows = 6;
using SmallMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_dependent_rows, most_dependent_rows>;

/// The shortest x that comes nearest to m x = right, for each column of `right`. With the unit matrix
/// as `right`, it is the pseudo-inverse of m. Sizes are not fixed, because this decomposition takes seconds
/// to compile for each size.
SmallMatrix solve_dependent(const SmallMatrix& m, const SmallMatrix& right);

}  // namespace flyrock
