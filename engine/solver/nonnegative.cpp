#include "solver/nonnegative.h"

#include <algorithm>
#include <vector>

namespace flyrock {

namespace {

/// The least squares over the columns in use, without bounds; 0 for the others.
Eigen::VectorXd solve_free(const Eigen::MatrixXd& a, const Eigen::VectorXd& y, const std::vector<int>& used) {
  const Eigen::MatrixXd columns = a(Eigen::all, used);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(a.cols());
  x(used) = columns.colPivHouseholderQr().solve(y);
  return x;
}

}  // namespace

Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& a, const Eigen::VectorXd& y) {
  constexpr double rounding = 1e-13;
  const int count = static_cast<int>(a.cols());
  const Eigen::VectorXd least = rounding * y.norm() * a.colwise().norm().transpose();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(count);
  std::vector<int> used, barred;  // barred: columns that depend on those in use, until another one enters
  const auto is_in = [](const std::vector<int>& list, int j) {
    return std::find(list.begin(), list.end(), j) != list.end();
  };
  for (int round = 0; round < 3 * count; ++round) {
    const Eigen::VectorXd descent = a.transpose() * (y - a * x);
    int next = -1;
    for (int j = 0; j < count; ++j)
      if (!is_in(used, j) && !is_in(barred, j) && descent[j] > least[j] &&
          (next < 0 || descent[j] > descent[next]))
        next = j;
    if (next < 0) break;
    used.push_back(next);
    bool enters = true;
    while (enters) {
      const Eigen::VectorXd wanted = solve_free(a, y, used);
      double share = 1;  // of the way to `wanted` until the first unknown is 0
      int blocked = -1;
      for (const int j : used)
        if (wanted[j] <= 0 && x[j] / (x[j] - wanted[j]) < share)
          share = x[j] / (x[j] - wanted[j]), blocked = j;
      if (blocked < 0) {
        x = wanted;
        barred.clear();
        break;
      }
      x += share * (wanted - x);
      x[blocked] = 0;
      std::erase(used, blocked);
      enters = blocked != next;
    }
    if (!enters) barred.push_back(next);
  }
  return x;
}

}  // namespace flyrock
