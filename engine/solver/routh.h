#pragma once
// Routh's diagram of the impact of one contact in 2D: its path in the plane of normal and tangential impulse.

#include <Eigen/Dense>
#include <vector>

namespace flyrock {

/// A place on the path: impulses (P_n, P_t) in N s, velocities v = v^- + W P in m/s.
struct RouthPoint {
  Eigen::Vector2d impulse = Eigen::Vector2d::Zero(), velocity = Eigen::Vector2d::Zero();
};

/// The path of an isolated contact from P = 0. While it slips, dP_t = -mu sign(v_t) dP_n; when slip ends, it
/// sticks if mu >= |W_nt| / W_tt, otherwise it slips the other way. All laws follow this path; they differ in
/// where they end it.
struct RouthDiagram {
  std::vector<RouthPoint> path;        ///< its corners and its end, behind the last of the ends below
  RouthPoint slip_end;                 ///< where slip first ends; the end of the path if it does not
  RouthPoint compression_end;          ///< v_n = 0
  RouthPoint newton, poisson, energy;  ///< where these laws end it (impact_path.h)
  /// Two lines of the plane, from end to end within 0 <= P_n <= the end of the path and |P_t| <= mu P_n
  /// there: v_t = 0, where a path that meets it sticks or reverses its slip, and v_n = 0, where compression
  /// ends. Empty where a line passes outside.
  std::vector<RouthPoint> sticking, greatest_compression;
};

/// `w`: symmetric positive definite, 1/kg; `v`: v^-, with v_n < 0; `e`: the coefficient of restitution.
/// Source: E. J. Routh 1860; J. B. Keller 1986.
RouthDiagram routh_diagram(const Eigen::Matrix2d& w, const Eigen::Vector2d& v, double mu, double e);

}  // namespace flyrock
