#include "solver/lemke.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flyrock {

namespace {

/// The equations  w - M z - 1 z_0 = q,  solved for the variables of the basis. Columns: w, z, z_0, right
/// side. The columns of w hold the inverse of the basis.
class Tableau {
 public:
  Tableau(const Eigen::MatrixXd& m, const Eigen::VectorXd& q) : size_(q.size()) {
    rows_.resize(size_, 2 * size_ + 2);
    rows_ << Eigen::MatrixXd::Identity(size_, size_), -m, Eigen::VectorXd::Constant(size_, -1.0), q;
    for (int i = 0; i < size_; ++i) basis_.push_back({LcpVariable::Kind::w, i});
  }

  /// The row in which z_0 takes the lexicographically least right side.
  Eigen::Index first_row() const {
    Eigen::Index best = 0;
    for (Eigen::Index row = 1; row < size_; ++row)
      if (less(row, 1, best, 1)) best = row;
    return best;
  }

  /// The row whose variable is first at 0 while `entering` grows; -1: none.
  Eigen::Index blocking_row(const LcpVariable& entering) const {
    const auto column = rows_.col(column_of(entering));
    const double least = 1e-11 * std::max(1.0, column.cwiseAbs().maxCoeff());
    Eigen::Index best = -1;
    for (Eigen::Index row = 0; row < size_; ++row)
      if (column[row] > least && (best < 0 || less(row, column[row], best, column[best]))) best = row;
    if (best < 0) return best;
    // z_0 leaves if it is among the first: the path ends there.
    for (Eigen::Index row = 0; row < size_; ++row)
      if (basis_[row].kind == LcpVariable::Kind::artificial && column[row] > least &&
          right(row) / column[row] <= right(best) / column[best] + rounding())
        return row;
    return best;
  }

  /// Exchanges `entering` with the variable of a row, which is returned.
  LcpVariable pivot(Eigen::Index row, const LcpVariable& entering) {
    const Eigen::Index column = column_of(entering);
    rows_.row(row) /= rows_(row, column);
    for (Eigen::Index other = 0; other < size_; ++other)
      if (other != row) rows_.row(other) -= rows_(other, column) * rows_.row(row);
    return std::exchange(basis_[row], entering);
  }

  /// The value of a variable: 0 outside of the basis.
  double value(const LcpVariable& variable) const {
    const auto at = std::find(basis_.begin(), basis_.end(), variable);
    return at == basis_.end() ? 0 : std::max(0.0, right(at - basis_.begin()));
  }

 private:
  double right(Eigen::Index row) const { return rows_(row, 2 * size_ + 1); }
  double rounding() const { return 1e-13 * rows_.col(2 * size_ + 1).cwiseAbs().maxCoeff(); }

  Eigen::Index column_of(const LcpVariable& variable) const {
    if (variable.kind == LcpVariable::Kind::artificial) return 2 * size_;
    return variable.index + (variable.kind == LcpVariable::Kind::z ? size_ : 0);
  }

  /// Whether (right side, inverse of the basis) of row a, divided by `by_a`, is lexicographically less than
  /// that of row b divided by `by_b`.
  bool less(Eigen::Index a, double by_a, Eigen::Index b, double by_b) const {
    const double difference = right(a) / by_a - right(b) / by_b;
    if (std::abs(difference) > rounding()) return difference < 0;
    for (Eigen::Index k = 0; k < size_; ++k) {
      const double here = rows_(a, k) / by_a, there = rows_(b, k) / by_b;
      if (std::abs(here - there) > 1e-12 * (std::abs(here) + std::abs(there))) return here < there;
    }
    return false;
  }

  Eigen::Index size_;
  Eigen::MatrixXd rows_;
  std::vector<LcpVariable> basis_;
};

LcpVariable complement(const LcpVariable& variable) {
  const bool is_w = variable.kind == LcpVariable::Kind::w;
  return {is_w ? LcpVariable::Kind::z : LcpVariable::Kind::w, variable.index};
}

}  // namespace

LemkePath lemke(const Eigen::MatrixXd& m, const Eigen::VectorXd& q, int limit) {
  constexpr LcpVariable artificial{LcpVariable::Kind::artificial, 0};
  LemkePath path;
  path.z = Eigen::VectorXd::Zero(q.size());
  if (q.size() == 0 || q.minCoeff() >= 0) return path;
  Tableau tableau(m, q);
  LcpVariable entering = artificial;
  Eigen::Index row = tableau.first_row();
  for (;;) {
    const LcpVariable leaving = tableau.pivot(row, entering);
    path.pivots.push_back({entering, leaving, tableau.value(artificial)});
    if (leaving == artificial) break;
    entering = complement(leaving);
    row = tableau.blocking_row(entering);
    if (row < 0) {
      path.end = LemkeEnd::ray;
      path.on_ray = entering;
      return path;
    }
    if (static_cast<int>(path.pivots.size()) >= limit) {
      path.end = LemkeEnd::too_long;
      return path;
    }
  }
  for (int i = 0; i < q.size(); ++i) path.z[i] = tableau.value({LcpVariable::Kind::z, i});
  return path;
}

}  // namespace flyrock
