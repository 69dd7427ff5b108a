#pragma once
// The second solver: Newton steps with a proximal term, between sweeps.

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <vector>

#include "solver/nlgs.h"

namespace flyrock {

/// Each step reads the state of every contact and group of rows off Alart and Curnier's map at r,
///   y_n = r_n - rho u_n (closed where positive),   y_g = r_g - rho u_g (held where |y_g| <= mu_g y_n + c_g, else slipping),
/// and solves the equations of that state, linearised, with the proximal term alpha diag(W) (r - r_now):
///   closed: u_n = 0;   held: u_g = 0;   slipping along e = y_g / |y_g|: r_g = (mu_g r_n + c_g) e + s e', with
///   e'.u_g + (1 - k) / (k rho) s = 0, k = (mu_g r_n + c_g) / |y_g|   (the turning of the slip direction; e' normal to e).
/// The unknowns are few: none for an open contact, in space two for a slipping and three for a sticking one. They are
/// solved for by a sparse LU factorisation. The proximal term makes singular systems (hyperstatic packings) solvable and
/// vanishes at the solution. Two sweeps of NLGS follow each step, because they put every contact into a possible state;
/// where the residual falls alpha is divided by ten, else multiplied. It allocates. Instantiated for D = 2, 3.
/// Source of the map: Alart and Curnier 1991; of the combination: Acary, Bremond and Huber 2018 (chapter on proximal
/// algorithms).
template <int D>
class ProximalNewton {
 public:
  using Problem = ContactProblem<D>;
  using Row = typename Problem::Row;

  /// From r, which should have been swept a few times, with at most `steps` factorisations. `sweeper` has begun this problem.
  /// The answer is the best that was judged.
  SolveResult solve(const Problem& problem, const SolveSettings& settings, Nlgs<D>& sweeper, int steps, std::vector<Row>& r);

 private:
  using Block = typename Problem::Block;
  /// The state of a contact in a step: r = start + directions z, with the equations
  /// tests^T (u + alpha diag(W) directions z) + spring z + pull = 0, as many as unknowns.
  struct State {
    int unknowns = 0, first = 0;
    Block directions, tests;
    Row start, spring, pull;
  };

  int read_states(const Problem& problem, const std::vector<Row>& r);
  bool step(const Problem& problem, double alpha, std::vector<Row>& r);

  std::vector<State> states_;
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::SparseMatrix<double> matrix_;
  Eigen::SparseLU<Eigen::SparseMatrix<double>, Eigen::COLAMDOrdering<int>> factors_;
  Eigen::VectorXd right_, z_;
  std::vector<Row> trial_, swept_, best_;
};

}  // namespace flyrock
