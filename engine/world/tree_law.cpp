#include "world/tree_law.h"

#include <algorithm>
#include <cmath>

namespace flyrock {

namespace {
double share_of(double eccentricity) {
  return std::clamp(-0.046 + 1.026 / (1 + std::pow(10.0, -8.007 * (0.58 - eccentricity))), 0.0, 1.0);
}
}  // namespace

double TreeLaw::energy_of(const Stem& stem, double eccentricity) const {
  const double strength = factor * stem.strength;
  if (fixed) return strength * energy;
  const double diameter = 200 * stem.radius;  // cm
  return strength * 38.7 * std::pow(diameter, 2.31) * share_of(eccentricity);
}

TreeEffect effect_of(const TreeLaw& law, const Stem& stem, int tree, double energy, const Vec2& place,
                     const Vec2& velocity, DrawKey key) {
  const Vec2 to_axis = stem.place - place;
  const double speed = velocity.norm(), distance = to_axis.norm();
  const double side = speed > 0 && distance > 0 ? cross(velocity, to_axis) / (speed * distance) : 0;
  TreeEffect effect;
  const double taken = std::min(law.energy_of(stem, std::min(std::abs(side), 1.0)), energy);
  effect.left = energy > 0 ? std::sqrt(1 - taken / energy) : 0;
  key.impact = static_cast<std::uint64_t>(tree) + 1;
  const double turn = law.turn_draw ? law.turn_draw->value(*law.streams, key) : law.turn;
  effect.turn = side < 0 ? turn : -turn;
  return effect;
}

}  // namespace flyrock
