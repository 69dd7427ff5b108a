#pragma once
// One impact of one contact, solved by a form of restitution.

#include <Eigen/Dense>

#include "solver/impact_path.h"
#include "solver/restitution.h"

namespace flyrock {

/// Components (n, t) or (n, t, s), as in ContactProblem.
template <int D>
struct SingleImpact {
  Eigen::Matrix<double, D, D> w;
  Eigen::Matrix<double, D, 1> v;
  double mu = 0;
  double e = 0;
};

/// The result of an impact: its impulse, the velocity after it, and its energy dT = p.(v^- + v^+)/2.
template <int D>
struct SingleOutcome {
  Eigen::Matrix<double, D, 1> impulse, after;
  double energy = 0;
};

/// W of a uniform rod (mass 1, length 1) that touches the ground with its lower right tip; `angle` [rad] is
/// measured from the ground.
Eigen::Matrix2d rod_mobility(double angle);

/// Solved by the impact solver. `phases`: as if coupled to another contact, so that poisson and energy use
/// their two phases.
template <int D>
SingleOutcome<D> solve_single(const SingleImpact<D>& impact, RestitutionForm form, bool phases = false);
/// Solved along the path in impulse space.
template <int D>
SingleOutcome<D> follow_single(const SingleImpact<D>& impact, ImpactEnd end);

}  // namespace flyrock
