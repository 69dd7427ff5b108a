#pragma once
// The second solver: a sequence of regularised problems, each solved by Newton steps on smoothed laws.

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <vector>

#include "solver/nlgs.h"

namespace flyrock {

/// The smoothed law r = p(y) of a contact and its slope dp/dy.
template <int D>
struct SmoothedLaw {
  typename ContactProblem<D>::Row value;
  typename ContactProblem<D>::Block slope;
};

/// Proximal-point method. From a centre c, solve the shifted problem with the velocity u = q + W r + alpha
/// diag(W) (r - c); its solution is the next centre. A fixed point solves the original problem. The shifted
/// problem is regular even if W is singular (hyperstatic packings). If contacts cannot all keep their state
/// (several contacts slide, and only a change of load can close them together), each shifted problem moves
/// their load by about error / alpha, until one contact opens or sticks. Descent on the error alone cannot do
/// that.
///
/// A shifted problem is r = p(y), y = r - u / diag(W) (the map of Alart and Curnier). Newton's method solves
/// it with a smoothing of width e = sqrt(s / diag(W)), whose energy s decreases to what the wanted error
/// requires. The smoothed law is
///   p_n = (y_n + sqrt(y_n^2 + 4 e^2)) / 2,   p_g = y_g R / M,   R = mu_g p_n + c_g,
///   M = (R + |y_g| + sqrt((R - |y_g|)^2 + 4 e^2)) / 2   for each group g of rows.
/// Each step needs one sparse LU factorisation, whose pattern is analysed once. Steps are halved until the
/// error decreases. alpha shrinks after an easy solve and grows after a failed one. An NLGS sweep after each
/// step brings every contact into an admissible state. Both the step and the sweep are checked, and the best
/// r is the answer. The solver allocates. Instantiated for D = 2, 3. Sources: Alart and Curnier 1991;
/// Rockafellar 1976 (proximal points); Chen and Mangasarian 1996 (smoothing).
template <int D>
class ProximalNewton {
 public:
  using Problem = ContactProblem<D>;
  using Row = typename Problem::Row;

  /// Solves with at most `steps` factorisations. On entry r holds the impulses to fall back on; on return it
  /// holds the best checked r. `sweeper` must have begun this problem.
  SolveResult solve(const Problem& problem, const SolveSettings& settings, Nlgs<D>& sweeper, int steps,
                    std::vector<Row>& r);

 private:
  using Block = typename Problem::Block;

  void begin(const Problem& problem);
  bool find_next_centre(Nlgs<D>& sweeper, int steps, std::vector<Row>& r);
  double find_error(const std::vector<Row>& r, double smoothing);
  bool find_direction();
  void judge_step(Nlgs<D>& sweeper, const std::vector<Row>& r);

  const Problem* problem_ = nullptr;
  SolveSettings settings_;
  SolveResult result_;  ///< result of best_
  int taken_ = 0;       ///< factorisations so far
  double alpha_ = 0;
  bool analysed_ = false;  ///< the sparsity pattern of the matrix, which depends only on the problem
  std::vector<Row> diagonal_, centre_, next_, trial_, direction_, candidate_, best_;
  std::vector<SmoothedLaw<D>> laws_;
  std::vector<double> scale_;  ///< scale of unknowns and equations, which makes both square roots of energies
  Eigen::VectorXd error_, z_;
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::SparseMatrix<double> matrix_;
  Eigen::SparseLU<Eigen::SparseMatrix<double>, Eigen::COLAMDOrdering<int>> factors_;
};

}  // namespace flyrock
