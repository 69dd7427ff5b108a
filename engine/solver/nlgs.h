#pragma once
// Non-linear Gauss-Seidel (NLGS).

#include <vector>

#include "solver/anderson.h"
#include "solver/body_motions.h"
#include "solver/contact_problem.h"
#include "solver/local_3d.h"
#include "solver/solve_settings.h"

namespace flyrock {

/// A sweep visits the contacts in their order and solves each local problem exactly, with the impulses of all
/// others fixed (local_2d.h, local_3d.h). In problems of hundreds of contacts that know their bodies, a sweep
/// carries the velocities of these and not the blocks of W, of which there are many more. In problems of more
/// than a few contacts the sweeps are accelerated (anderson.h). The first solve reserves buffers for
/// accelerated sweeps of a few contacts; a later one does not allocate once the buffers have grown.
/// Instantiated for D = 2, 3.
template <int D>
class Nlgs {
 public:
  using Problem = ContactProblem<D>;
  using Row = typename Problem::Row;

  /// `r` holds the start (zero, or the warm start from the last step) and the answer. The solve ends when
  /// judge (residual.h) reports convergence, or after settings.max_iterations sweeps; the answer is then the
  /// best checked r. A check costs as much as a sweep. In problems of more than a few contacts it is
  /// therefore made only when the errors seen during the sweeps predict success.
  SolveResult solve(const Problem& problem, const SolveSettings& settings, std::vector<Row>& r);

  /// The same in parts, for a caller that decides whether to continue: begin, then `sweeps` more sweeps per
  /// call of run.
  void begin(const Problem& problem, const SolveSettings& settings, std::vector<Row>& r);
  /// The same with accelerated sweeps, whatever the number of contacts.
  void begin_accelerated(const Problem& problem, const SolveSettings& settings, std::vector<Row>& r);
  const SolveResult& run(int sweeps, std::vector<Row>& r);
  /// One sweep without acceleration and without a check.
  void sweep_once(std::vector<Row>& r) { sweep(r); }

 private:
  void reserve();
  double sweep(std::vector<Row>& r);
  template <int N>
  double sweep_rows(std::vector<Row>& r);
  template <int N>
  double sweep_bodies(std::vector<Row>& r);
  /// The leading N rows of W_aa.
  template <int N>
  auto own(int a) const {
    return problem_->contacts[a].w.template topLeftCorner<N, N>();
  }
  double solve_contact(int a, const Row& b, const Row& u, Row& r) const;
  void begin_acceleration();
  void accelerate(std::vector<Row>& r);
  void check(const std::vector<Row>& r);

  const Problem* problem_ = nullptr;
  SolveSettings settings_;
  SolveResult result_;
  double wanted_ = 0;          ///< wanted size of the error seen during a sweep
  double expected_ratio_ = 1;  ///< error after a sweep / error during the sweep, from the last check
  int next_judgement_ = 1;
  bool accelerated_ = false;
  std::vector<FrictionContact3> friction_;  ///< of each contact, in 3D
  std::vector<BodyMotion<D>> motions_;      ///< of each body, by r
  Anderson anderson_;
  std::vector<double> scale_, from_, to_;
  std::vector<Row> best_;
  double best_residual_ = 0;
};

}  // namespace flyrock
