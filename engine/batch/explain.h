#pragma once
// The contact problem of one impact or step of a trial, so that a person can follow its solution.

#include <optional>
#include <string>
#include <vector>

#include "flight/run.h"
#include "flight/world_names.h"
#include "solver/fclib.h"

namespace flyrock {

/// One problem of a trial: the impacts and the steps of a trial are counted from 1, each for themselves, in
/// the order of the rows of `series_solves`.
struct ExplainRequest {
  bool impact = true;
  std::uint64_t number = 1;
};

/// One sweep of Gauss-Seidel.
struct ExplainedSweep {
  Eigen::VectorXd r;    ///< N s
  double residual = 0;  ///< m/s, see local_error
};

/// One friction problem: u = q + W r.
struct ExplainedPhase {
  std::string name;                    ///< "" or, of two phases, "compression", "restitution"
  Eigen::VectorXd q;                   ///< m/s
  Eigen::VectorXd r;                   ///< N s, as the run found it
  Eigen::VectorXd u;                   ///< m/s
  double residual = 0;                 ///< m/s, of r
  bool warm = false;                   ///< the run began with the impulses of the step before
  std::vector<ExplainedSweep> sweeps;  ///< from r = 0, until the tolerance of the run is met, 1000 at most
};

struct ExplainedContact {
  std::string a, b;  ///< the normal points from b to a
  Vec3 place = Vec3::Zero(), normal = Vec3::Zero(), tangent = Vec3::Zero();  ///< s = n x t
  double gap = 0;                                                            ///< m
  ContactLaw law;
  double mu = 0;                  ///< the coefficient that was used: mu_s or mu_d
  bool impact = false;            ///< it closes faster than rest_speed, so its law of restitution was asked
  bool alone = false;             ///< solved apart, along its path in impulse space
  Eigen::VectorXd before, after;  ///< m/s, rows (n, t, rolling) or (n, t, s, spinning, 2 rolling)
  Eigen::VectorXd impulse;        ///< N s
  double energy = 0;              ///< J, its work on the bodies
};

/// Matrices and vectors hold `rows` rows of each contact, one contact after the other.
struct Explanation {
  int dimension = 2, rows = 2;
  double time = 0;
  double step = 0;  ///< s; 0: an impact
  std::vector<ExplainedContact> contacts;
  std::vector<std::vector<int>> islands;  ///< the contacts that act on each other
  Eigen::MatrixXd w;                      ///< 1/kg
  Eigen::VectorXd free;                   ///< m/s, velocity without the impulses of contacts
  std::vector<ExplainedPhase> phases;
  Eigen::VectorXd singular_values;  ///< of W, falling
  int rank = 0;                     ///< of W: singular values above 1e-10 of the greatest
  double energy = 0;                ///< J, work of all contacts; without them, weight does the rest in a step
  AnyProblem problem;               ///< of the first phase, with the start of the run
};

/// Waits for one problem while the worlds of a trial run.
class Explainer {
 public:
  Explainer(const ExplainRequest& request) : request_(request) {}

  /// Watches a world that is about to run with `settings`, which refer to the explainer from then on.
  /// Instantiated for D = 2, 3.
  template <int D>
  void watch(World<D>& world, WorldNames names, RunSettings& settings);

  const std::optional<Explanation>& found() const { return found_; }
  std::uint64_t seen() const { return seen_; }  ///< impacts or steps

 private:
  ExplainRequest request_;
  std::uint64_t seen_ = 0;
  std::optional<Explanation> found_;
};

}  // namespace flyrock
