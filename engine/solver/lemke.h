#pragma once
// Lemke's complementary pivoting for small linear complementarity problems, with its path.

#include <Eigen/Dense>
#include <vector>

namespace flyrock {

/// A variable of the problem: component `index` of w or z, or the artificial z_0.
struct LcpVariable {
  enum class Kind { w, z, artificial } kind = Kind::w;
  int index = 0;
  bool operator==(const LcpVariable&) const = default;
};

/// One pivot: `entering` grows from 0 until `leaving` is 0.
struct LemkePivot {
  LcpVariable entering, leaving;
  double artificial = 0;  ///< z_0 after the pivot
};

enum class LemkeEnd {
  solution,
  ray,      ///< the entering variable grows without bound, because no variable decreases
  too_long  ///< more pivots than the limit
};

struct LemkePath {
  std::vector<LemkePivot> pivots;
  LemkeEnd end = LemkeEnd::solution;
  LcpVariable on_ray;  ///< of a ray: the variable that grows without bound
  Eigen::VectorXd z;   ///< of a solution
};

/// Finds z with  0 <= q + M z = w,  z >= 0,  w^T z = 0.  M has any signs and need not be symmetric.
/// Lemke's method follows the solutions of  w = q + 1 z_0 + M z  from large z_0 to z_0 = 0. At each pivot
/// the complement of the variable that left enters. Ties are broken lexicographically, so that it does not
/// cycle. A ray means that this path leads to no solution; there may be one. If M is copositive plus, or
/// copositive with v^T q >= 0 for all v >= 0 with M v >= 0 and v^T M v = 0, a ray proves that there is none.
/// `limit`: the most pivots. Source: R. W. Cottle, J.-S. Pang, R. E. Stone, The Linear Complementarity
/// Problem, 1992, algorithm 4.4.5 and sections 4.4 and 4.9.
LemkePath lemke(const Eigen::MatrixXd& m, const Eigen::VectorXd& q, int limit = 10000);

}  // namespace flyrock
