#include "elastic/elastic_step.h"

#include <stdexcept>

namespace flyrock {

template <int D>
ElasticStep<D>::ElasticStep(const ElasticModel<D>& model, double h, double theta)
    : model_(model),
      h_(h),
      theta_(theta),
      permuted_(model.size()),
      force_(model.size()),
      shifted_(model.size()),
      columns_(model.mesh().nodes.size()) {
  const ElasticMaterial& of = model.material();
  const double th = theta * h;
  Eigen::SparseMatrix<double> implicit = (th * of.beta + th * th) * model.stiffness();
  implicit.diagonal() += (1 + th * of.alpha) * model.masses();
  factor_.compute(implicit);
  if (factor_.info() != Eigen::Success)
    throw std::runtime_error("the stiffness of a deformable block cannot be factorised");
  pivots_ = factor_.vectorD();
}

template <int D>
void ElasticStep<D>::solve(Eigen::VectorXd& force) const {
  model_.drop_rigid_force(force);
  const auto& order = factor_.permutationP().indices();
  for (Eigen::Index i = 0; i < force.size(); ++i) permuted_[order[i]] = force[i];
  factor_.matrixL().solveInPlace(permuted_);
  permuted_.array() /= pivots_.array();
  factor_.matrixU().solveInPlace(permuted_);
  for (Eigen::Index i = 0; i < force.size(); ++i) force[i] = permuted_[order[i]];
  model_.drop_rigid_motion(force);  // what rounding left of it
}

template <int D>
void ElasticStep<D>::free_change(const Eigen::VectorXd& u, const Eigen::VectorXd& rate,
                                 Eigen::VectorXd& change) const {
  const ElasticMaterial& of = model_.material();
  shifted_ = h_ * u + (theta_ * h_ * h_ + h_ * of.beta) * rate;
  change.setZero();
  change.noalias() -= model_.stiffness() * shifted_;
  change -= h_ * of.alpha * model_.masses().cwiseProduct(rate);
  solve(change);
}

template <int D>
const typename ElasticStep<D>::Column& ElasticStep<D>::column(int node) const {
  std::unique_ptr<Column>& known = columns_[static_cast<std::size_t>(node)];
  if (known) return *known;
  known = std::make_unique<Column>(model_.size(), D);
  for (int k = 0; k < D; ++k) {
    force_.setZero();
    force_[D * node + k] = 1;
    solve(force_);
    known->col(k) = force_;
  }
  return *known;
}

template class ElasticStep<2>;
template class ElasticStep<3>;

}  // namespace flyrock
