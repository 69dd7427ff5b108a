#pragma once
// Non-linear Gauss-Seidel.

#include <vector>

#include "solver/anderson.h"
#include "solver/contact_problem.h"
#include "solver/local_3d.h"
#include "solver/solve_settings.h"

namespace flyrock {

/// Sweeps over the contacts in their order, each local problem solved exactly with the others frozen
/// (local_2d.h, local_3d.h). In problems of more than a few contacts the sweeps are accelerated (anderson.h).
/// It keeps its buffers: a solve does not allocate once they have grown. Instantiated for D = 2, 3.
template <int D>
class Nlgs {
 public:
  using Problem = ContactProblem<D>;
  using Row = typename Problem::Row;

  /// Makes room for the accelerated sweeps of a few contacts, so that a step in which they are first needed
  /// allocates nothing.
  Nlgs();

  /// `r` holds the start (zero, or the impulses of the last step) and the answer. The solve ends when judge
  /// (residual.h) says so, or after settings.max_iterations sweeps; then the best that was judged is the
  /// answer. Judging costs as much as a sweep: in problems of more than a few contacts it is done when the
  /// errors met on the way foretell success.
  SolveResult solve(const Problem& problem, const SolveSettings& settings, std::vector<Row>& r);

  /// The same in parts, for who weighs whether to go on: begin, then `sweeps` more of them at a time.
  void begin(const Problem& problem, const SolveSettings& settings, std::vector<Row>& r);
  /// The same with accelerated sweeps, whatever the number of contacts.
  void begin_accelerated(const Problem& problem, const SolveSettings& settings, std::vector<Row>& r);
  const SolveResult& run(int sweeps, std::vector<Row>& r);
  /// One sweep without acceleration, and without judging.
  void sweep_once(std::vector<Row>& r) { sweep(r); }

 private:
  double sweep(std::vector<Row>& r) const;
  template <int N>
  double sweep_rows(std::vector<Row>& r) const;
  void begin_acceleration();
  void accelerate(std::vector<Row>& r);

  const Problem* problem_ = nullptr;
  SolveSettings settings_;
  SolveResult result_;
  double wanted_ = 0;  ///< of the error that a sweep meets
  double foretold_ =
      1;  ///< what is left after a sweep, as a share of the error it met: from the last judgement
  int next_judgement_ = 1;
  bool accelerated_ = false;
  std::vector<FrictionContact3> friction_;  ///< of each contact, in space
  Anderson anderson_;
  std::vector<double> scale_, from_, to_;
  std::vector<Row> best_;
  double best_residual_ = 0;
};

}  // namespace flyrock
