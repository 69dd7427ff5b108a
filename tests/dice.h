#pragma once
// Random places, directions and attitudes for tests.

#include <cmath>
#include <random>

#include "math/space.h"

namespace flyrock {

/// Random numbers for placements. They are the same in each run.
struct Dice {
  std::mt19937 rng;
  explicit Dice(unsigned seed = 5) : rng(seed) {}
  double operator()(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(rng);
  }
  template <int D>
  Vec<D> direction() {
    std::normal_distribution<double> normal;
    Vec<D> v;
    for (int k = 0; k < D; ++k) v[k] = normal(rng);
    return v.normalized();
  }
  template <int D>
  typename Space<D>::Rotation rotation() {
    if constexpr (D == 2)
      return Rotation2::from_angle((*this)(0, 2 * pi));
    else
      return Rotation3::from_vector((*this)(0, pi) * direction<3>());
  }
  /// A third of the attitudes is along the axes, so that faces, sides and edges lie flush.
  template <int D>
  typename Space<D>::Rotation flush_rotation() {
    const double kind = (*this)(0, 3);
    if (kind >= 1) return rotation<D>();
    if constexpr (D == 2)
      return Rotation2::from_angle(0.5 * pi * std::floor(4 * kind));
    else if (kind < 0.5)
      return {};
    else
      return Rotation3::from_vector(0.5 * pi * Vec3::Unit(static_cast<int>((*this)(0, 2.999))));
  }
};

}  // namespace flyrock
