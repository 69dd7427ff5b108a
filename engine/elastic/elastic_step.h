#pragma once
// One implicit step of the deformation of a block, and how contacts at its nodes move it.

#include <Eigen/SparseCholesky>
#include <memory>
#include <vector>

#include "elastic/elastic_model.h"

namespace flyrock {

/// The theta scheme of the deformation for one length h of the step:
///   M~ (u'+ - u') = -h C u' - h K (u + theta h u') + S' r,   M~ = M + h theta C + h^2 theta^2 K
///   u+ = u + h ((1 - theta) u' + theta u'+)
/// on the complement of the rigid modes, with the impulses r at nodes. M~ is factorised once (sparse LDL').
/// theta = 1/2 keeps u'.M u' + u.K u without damping and contacts. Shared by all blocks of a scenario with
/// the same mesh, material and step.
template <int D>
class ElasticStep {
 public:
  using Column = Eigen::Matrix<double, Eigen::Dynamic, D>;
  using Block = Eigen::Matrix<double, D, D>;

  /// The model must outlive it. Throws std::runtime_error if M~ cannot be factorised.
  ElasticStep(const ElasticModel<D>& model, double h, double theta);

  /// u'+ - u' without contacts, into `change`; both have the size of the model. Allocates nothing.
  void free_change(const Eigen::VectorXd& u, const Eigen::VectorXd& rate, Eigen::VectorXd& change) const;

  /// M~^-1 on the complement of the rigid modes, in place. Allocates nothing.
  void solve(Eigen::VectorXd& force) const;

  /// The change of u' of all nodes by a unit impulse along each axis at a node [1/kg], rigid motion left out.
  /// Solved for at the first call; then nothing is allocated.
  const Column& column(int node) const;
  /// The change of u' at node a by unit impulses at node b [1/kg].
  Block mobility(int a, int b) const { return column(b).template middleRows<D>(D * a); }

 private:
  const ElasticModel<D>& model_;
  double h_, theta_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
  Eigen::VectorXd pivots_;  ///< D of LDL'
  mutable Eigen::VectorXd permuted_, force_, shifted_;
  mutable std::vector<std::unique_ptr<Column>> columns_;  ///< of the nodes that have touched
};

extern template class ElasticStep<2>;
extern template class ElasticStep<3>;

}  // namespace flyrock
