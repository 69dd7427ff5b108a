#pragma once
// Anderson's acceleration of a fixed-point iteration.

#include <Eigen/Dense>
#include <vector>

namespace flyrock {

/// For x -> g(x): keeps the last differences of f = g(x) - x and of g, and answers with
///   g - dG c,   c = argmin |S (f - dF c)|,
/// S a diagonal that makes the components comparable. Where g is smooth, as NLGS is once no contact changes
/// its state, this is GMRES on the linearised iteration. After a step that makes |S f| grow more than
/// threefold it begins anew. No allocation once its buffers have grown. Source: Walker and Ni 2011, with the
/// normal equations, whose loss of accuracy only slows the iteration down.
class Anderson {
 public:
  static constexpr int depth = 12;

  /// Begins with vectors of the size of `scale`.
  void begin(const std::vector<double>& scale);
  /// From x and g(x), both of this size; g is replaced by the next x.
  void mix(const double* x, double* g);

 private:
  using Gram = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, depth, depth>;
  using Few = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, depth, 1>;
  Eigen::Map<Eigen::VectorXd> column(std::vector<double>& buffer, int k) {
    return {buffer.data() + static_cast<std::size_t>(k) * size_, static_cast<Eigen::Index>(size_)};
  }

  std::size_t size_ = 0;
  int stored_ = 0;  ///< differences kept
  int next_ = 0;    ///< where the next goes
  bool has_last_ = false;
  double last_norm_ = 0;
  std::vector<double> scale_, f_, last_f_, last_g_, df_, dg_;
  Gram gram_;
};

}  // namespace flyrock
