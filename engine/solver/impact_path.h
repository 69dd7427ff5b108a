#pragma once
// The impact of one isolated contact, followed in impulse space.

#include <Eigen/Dense>

namespace flyrock {

/// The condition that ends an impact, for a coefficient e >= 0.
enum class ImpactEnd {
  newton,   ///< v_n = -e v_n^- (kinematic; for comparison only, because it can gain energy)
  poisson,  ///< the normal impulse of restitution is e times that of compression
  energy    ///< the normal work of restitution is -e^2 times that of compression (Stronge)
};

/// The impulse of an isolated contact [N s], components (n, t, s). The normal impulse P is the independent
/// variable:
///   dv/dP = W (1, -mu e),  e = v_t / |v_t|,  during slip.
/// When slip ends, the contact sticks if |W_tt^-1 w_tn| <= mu. Otherwise it slips on along the one direction
/// that slip can keep. Compression lasts until v_n = 0, restitution until the condition `end`. If the
/// direction of slip does not turn (always in 2D), the path is straight and every leg has a closed form. If
/// it turns, an ordinary differential equation for the angle of slip is integrated to a relative error of
/// 1e-13 per step. A jam (W_nn - mu e.w_tn <= 0, Painleve) ends when its slip ends, and also gives an
/// impulse. `w`: symmetric positive definite, 1/kg; `v`: m/s. The answer is 0 if v_n >= 0. Source: E. J.
/// Routh 1860; J. B. Keller, Impact with friction, 1986; W. J. Stronge, Rigid body collisions with friction,
/// 1990; V. Bhatt and J. Koechling 1995 for the turning slip.
Eigen::Vector3d impact_path(const Eigen::Matrix3d& w, const Eigen::Vector3d& v, double mu, ImpactEnd end,
                            double e);

/// The same in 2D, components (n, t).
Eigen::Vector2d impact_path(const Eigen::Matrix2d& w, const Eigen::Vector2d& v, double mu, ImpactEnd end,
                            double e);

}  // namespace flyrock
