#include "solver/anderson.h"

#include <algorithm>

namespace flyrock {

void Anderson::begin(const std::vector<double>& scale) {
  scale_ = scale;
  size_ = scale.size();
  for (auto* buffer : {&f_, &last_f_, &last_g_}) buffer->resize(size_);
  for (auto* buffer : {&df_, &dg_}) buffer->resize(size_ * depth);
  gram_.resize(depth, depth);
  stored_ = next_ = 0;
  has_last_ = false;
}

void Anderson::mix(const double* x, double* g) {
  constexpr double growth = 3, regularisation = 1e-12;
  const auto n = static_cast<Eigen::Index>(size_);
  const Eigen::Map<const Eigen::VectorXd> from(x, n);
  Eigen::Map<Eigen::VectorXd> to(g, n);
  auto f = column(f_, 0), last_f = column(last_f_, 0), last_g = column(last_g_, 0);
  f = Eigen::Map<const Eigen::ArrayXd>(scale_.data(), n) * (to - from).array();
  const double norm = f.norm();
  if (has_last_ && norm > growth * last_norm_) stored_ = next_ = 0, has_last_ = false;
  last_norm_ = norm;
  if (has_last_) {
    column(df_, next_) = f - last_f;
    column(dg_, next_) = to - last_g;
    stored_ = std::min(stored_ + 1, depth);
    for (int k = 0; k < stored_; ++k)
      gram_(k, next_) = gram_(next_, k) = column(df_, k).dot(column(df_, next_));
    next_ = (next_ + 1) % depth;
  }
  last_f = f;
  last_g = to;
  has_last_ = true;
  if (stored_ == 0) return;
  Few load(stored_);
  for (int k = 0; k < stored_; ++k) load[k] = column(df_, k).dot(f);
  Gram gram = gram_.topLeftCorner(stored_, stored_);
  gram.diagonal() *= 1 + regularisation;
  const Few c = gram.ldlt().solve(load);
  if (!c.allFinite()) return;
  for (int k = 0; k < stored_; ++k) to -= c[k] * column(dg_, k);
}

}  // namespace flyrock
