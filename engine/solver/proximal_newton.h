#pragma once
// The second solver: a sequence of regular problems, each solved by Newton steps on smoothed laws.

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <vector>

#include "solver/nlgs.h"

namespace flyrock {

/// A contact's law r = p(y), smoothed, and its slope dp/dy.
template <int D>
struct SmoothedLaw {
  typename ContactProblem<D>::Row value;
  typename ContactProblem<D>::Block slope;
};

/// Proximal points: from a centre c, the problem with the velocity u = q + W r + alpha diag(W) (r - c); its
/// solution is the next centre. A fixed point solves the problem itself, the shifted one is regular where W
/// is singular (hyperstatic packings). Contacts that cannot all keep their state (several that slide, and can
/// be closed together only by a change of load) shift their load by about error / alpha in each of them until
/// one opens or sticks: descent on the error alone cannot do that.
///
/// A shifted problem is r = p(y), y = r - u / diag(W) (Alart and Curnier's map), by Newton's method on its
/// smoothing of width e = sqrt(s / diag(W)), s an energy that falls towards what the wanted error needs:
///   p_n = (y_n + sqrt(y_n^2 + 4 e^2)) / 2,   p_g = y_g R / M,   R = mu_g p_n + c_g,
///   M = (R + |y_g| + sqrt((R - |y_g|)^2 + 4 e^2)) / 2   for each group g of rows,
/// with a sparse LU factorisation a step, whose pattern is analysed once, and steps that are halved until the
/// error falls. Where few steps suffice alpha falls, where none leads on it grows. A sweep of NLGS after each
/// step brings every contact into a possible state: it is judged beside the step, and the best is the answer.
/// It allocates. Instantiated for D = 2, 3. Sources: Alart and Curnier 1991; Rockafellar 1976 (proximal
/// points); Chen and Mangasarian 1996 (smoothing).
template <int D>
class ProximalNewton {
 public:
  using Problem = ContactProblem<D>;
  using Row = typename Problem::Row;

  /// With at most `steps` factorisations. r holds impulses to fall back on and the answer, the best that was
  /// judged; `sweeper` has begun this problem.
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
  SolveResult result_;  ///< of best_
  int taken_ = 0;       ///< factorisations
  double alpha_ = 0;
  bool analysed_ = false;  ///< the pattern of the matrix, which is that of the problem
  std::vector<Row> diagonal_, centre_, next_, trial_, direction_, candidate_, best_;
  std::vector<SmoothedLaw<D>> laws_;
  std::vector<double> scale_;  ///< of unknowns and equations: both become roots of energies
  Eigen::VectorXd error_, z_;
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::SparseMatrix<double> matrix_;
  Eigen::SparseLU<Eigen::SparseMatrix<double>, Eigen::COLAMDOrdering<int>> factors_;
};

}  // namespace flyrock
