#pragma once
// Anderson acceleration of a fixed-point iteration.

#include <Eigen/Dense>
#include <vector>

namespace flyrock {

/// For x -> g(x): keeps the last differences of f = g(x) - x and of g. The next x is
///   g - dG c,   c = argmin |S (f - dF c)|,
/// with a diagonal matrix S that makes the components comparable. If g is smooth, this equals GMRES on the
/// linearised iteration; NLGS is smooth once no contact changes its state. After a step that makes |S f| grow
/// more than threefold the history is cleared. The class does not allocate once its buffers have grown.
/// Source: Walker and Ni 2011, with normal equations, because their loss of accuracy only slows the iteration
/// down.
class Anderson {
 public:
  static constexpr int depth = 12;

  /// Begins with vectors of the size of `scale`.
  void begin(const std::vector<double>& scale);
  /// Takes x and g(x), both of this size, and replaces g by the next x.
  void mix(const double* x, double* g);

 private:
  using Gram = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, depth, depth>;
  using Few = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, depth, 1>;
  Eigen::Map<Eigen::VectorXd> column(std::vector<double>& buffer, int k) {
    return {buffer.data() + static_cast<std::size_t>(k) * size_, static_cast<Eigen::Index>(size_)};
  }

  std::size_t size_ = 0;
  int stored_ = 0;  ///< number of stored differences
  int next_ = 0;    ///< column for the next difference
  bool has_last_ = false;
  double last_norm_ = 0;
  std::vector<double> scale_, f_, last_f_, last_g_, df_, dg_;
  Gram gram_;
};

}  // namespace flyrock
