#pragma once
// The impact of one isolated contact, followed in impulse space.

#include <Eigen/Dense>

namespace flyrock {

/// When an impact ends, for a coefficient e >= 0.
enum class ImpactEnd {
  newton,   ///< where v_n = -e v_n^- (kinematic; for comparison: it can gain energy)
  poisson,  ///< where the normal impulse of restitution is e times that of compression
  energy    ///< where the normal work of restitution is -e^2 times that of compression (Stronge)
};

/// The impulse of a contact that meets nothing else, N s, components (n, t, s). Its normal impulse P is the
/// clock:
///   dv/dP = W (1, -mu e),  e = v_t / |v_t|,  while it slips;
/// where slip ends it sticks, if |W_tt^-1 w_tn| <= mu, or else slips on along the one direction that slip
/// keeps. Compression lasts until v_n = 0, restitution as `end` says. Where the direction of slip does not
/// turn (always in the plane) the path is straight and every leg a closed form; where it turns, an ordinary
/// differential equation of the angle of slip is integrated to a relative 1e-12. A jam (W_nn - mu e.w_tn <=
/// 0, Painleve) ends with its slip and gives an impulse too. `w`: symmetric positive definite, 1/kg; `v`:
/// m/s. The answer is 0 where v_n >= 0. Source: E. J. Routh 1860; J. B. Keller, Impact with friction, 1986;
/// W. J. Stronge, Rigid body collisions with friction, 1990; V. Bhatt and J. Koechling 1995 for the turning
/// slip.
Eigen::Vector3d impact_path(const Eigen::Matrix3d& w, const Eigen::Vector3d& v, double mu, ImpactEnd end,
                            double e);

/// In the plane, components (n, t).
Eigen::Vector2d impact_path(const Eigen::Matrix2d& w, const Eigen::Vector2d& v, double mu, ImpactEnd end,
                            double e);

}  // namespace flyrock
