#pragma once
// The free rotation of a rigid body by power series in time: independent of FreeRotation and its functions.

#include <array>

#include "math/space.h"

namespace flyrock::lab {

/// Euler's equations I w' = I w x w in the body's principal frame, and the unit quaternion q' = q w / 2 of
/// the attitude, which begins as the identity. Both are products of their unknowns, so the coefficients of
/// their Taylor series follow from each other by recursion. In long double, for tests with closed forms.
class TaylorRotation {
 public:
  /// Principal moments [kg m2], and the spin at t = 0 [rad/s].
  TaylorRotation(const Vec3& moments, const Vec3& spin) : moments_(moments) {
    for (int i = 0; i < 3; ++i) w_[i] = spin[i];
  }

  /// Advances by `steps` steps of the length h [s]; h |w| about 0.5 is exact to rounding.
  void advance(double h, int steps) {
    for (int i = 0; i < steps; ++i) step(h);
  }

  Vec3 own_spin() const {  ///< rad/s, in the body's frame
    return {static_cast<double>(w_[0]), static_cast<double>(w_[1]), static_cast<double>(w_[2])};
  }
  Eigen::Matrix3d attitude() const {  ///< from the body's frame to the world
    return Eigen::Quaterniond(static_cast<double>(q_[0]), static_cast<double>(q_[1]),
                              static_cast<double>(q_[2]), static_cast<double>(q_[3]))
        .normalized()
        .toRotationMatrix();
  }
  Vec3 spin() const { return attitude() * own_spin(); }  ///< rad/s, in the world

 private:
  static constexpr int order = 24;
  using Series = std::array<long double, order + 1>;

  /// The coefficient k of a product.
  static long double product(const Series& a, const Series& b, int k) {
    long double sum = 0;
    for (int i = 0; i <= k; ++i) sum += a[i] * b[k - i];
    return sum;
  }
  static long double value(const Series& series, long double h) {
    long double sum = 0;
    for (int k = order; k >= 0; --k) sum = sum * h + series[k];
    return sum;
  }

  void step(long double h) {
    const long double ix = moments_.x(), iy = moments_.y(), iz = moments_.z();
    std::array<Series, 3> w{};
    std::array<Series, 4> q{};
    for (int i = 0; i < 3; ++i) w[i][0] = w_[i];
    for (int i = 0; i < 4; ++i) q[i][0] = q_[i];
    for (int k = 0; k < order; ++k) {
      const int n = k + 1;
      w[0][n] = (iy - iz) / ix * product(w[1], w[2], k) / n;
      w[1][n] = (iz - ix) / iy * product(w[2], w[0], k) / n;
      w[2][n] = (ix - iy) / iz * product(w[0], w[1], k) / n;
      q[0][n] = -(product(q[1], w[0], k) + product(q[2], w[1], k) + product(q[3], w[2], k)) / (2 * n);
      q[1][n] = (product(q[0], w[0], k) + product(q[2], w[2], k) - product(q[3], w[1], k)) / (2 * n);
      q[2][n] = (product(q[0], w[1], k) + product(q[3], w[0], k) - product(q[1], w[2], k)) / (2 * n);
      q[3][n] = (product(q[0], w[2], k) + product(q[1], w[1], k) - product(q[2], w[0], k)) / (2 * n);
    }
    for (int i = 0; i < 3; ++i) w_[i] = value(w[i], h);
    for (int i = 0; i < 4; ++i) q_[i] = value(q[i], h);
  }

  Vec3 moments_;
  std::array<long double, 3> w_{};
  std::array<long double, 4> q_{1, 0, 0, 0};
};

}  // namespace flyrock::lab
