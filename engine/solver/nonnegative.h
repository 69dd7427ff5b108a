#pragma once
// Least squares with unknowns that are not negative.

#include <Eigen/Dense>

namespace flyrock {

/// Minimises |A x - y|^2 over x >= 0. The active set changes by one unknown at a time; the columns in use
/// stay independent, so that A may have more columns than rows. Source: C. L. Lawson and R. J. Hanson,
/// Solving Least Squares Problems, 1974, chapter 23.
Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& y);

}  // namespace flyrock
