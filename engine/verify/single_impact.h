#pragma once
// One impact of one contact in the plane, solved by a form of restitution.

#include <Eigen/Dense>

#include "solver/impact_path.h"
#include "solver/restitution.h"

namespace flyrock {

/// Components (n, t), as in ContactProblem.
struct SingleImpact {
  Eigen::Matrix2d w;
  Eigen::Vector2d v;
  double mu = 0;
  double e = 0;
};

/// What an impact leaves: its impulse, the velocity after it, and the energy dT = p.(v^- + v^+)/2 that it brought.
struct SingleOutcome {
  Eigen::Vector2d impulse, after;
  double energy = 0;
};

/// W of a uniform rod (mass 1, length 1) that touches the ground with its tip to the right and below, `angle` [rad] from it.
Eigen::Matrix2d rod_mobility(double angle);

/// By the solver of impacts. `phases`: as if coupled to another contact, so that poisson and energy take their two phases.
SingleOutcome solve_single(const SingleImpact& impact, RestitutionForm form, bool phases = false);
/// Along the path in impulse space.
SingleOutcome follow_single(const SingleImpact& impact, ImpactEnd end);

}  // namespace flyrock
