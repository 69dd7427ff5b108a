#pragma once
// The trees (world/tree_law.h) on the path of one body, in 3D. A tree acts once on each body: where the
// sphere of equal volume first touches it. In 2D there are no trees.

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "flight/arc.h"
#include "flight/ground.h"
#include "math/sphere.h"
#include "world/body.h"
#include "world/tree_law.h"

namespace flyrock {

/// A path as polynomials of its time, and an arc as polynomials of s.
inline SpacePath space_path(const Path<3>& path) {
  return {.plan = in_plan(path), .z = {path.x.z(), path.v.z(), 0.5 * path.a.z()}};
}
inline SpacePath space_path(const Arc<3>& arc) { return {in_plan(arc), arc.along(Vec3::UnitZ())}; }

template <int D>
class TreeWatch {
 public:
  using Terrain = typename Geometry<D>::Terrain;

  /// Forest and terrain outlive the object. `key` is that of the draws of the body.
  TreeWatch(const RunForest& trees, const Terrain& terrain, double volume, const DrawKey& key)
      : trees_(trees), terrain_(terrain), radius_(any() ? sphere_radius(volume) : 0), key_(key) {}

  bool any() const { return trees_.forest != nullptr; }
  /// Whether the trees only count the rocks that touch them, and change nothing.
  bool passive() const { return trees_.law.is_passive(); }

  /// The first tree that the body touches along a path (or arc) within [0, end], of those that it has not
  /// hit.
  template <class Motion>
  std::optional<Forest::Touch> first(const Motion& path, double end) const {
    if constexpr (D == 3) {
      if (!any()) return std::nullopt;
      return trees_.forest->first(
          space_path(path), end, radius_,
          [&](const Vec2& at) { return ground_of(terrain_).height(at.x(), at.y()); },
          [&](int tree) { return std::find(hit_.begin(), hit_.end(), tree) != hit_.end(); });
    }
    return std::nullopt;
  }

  /// The body hits a tree at `position` with the kinetic energy E [J]. Turns and slows its velocity; its spin
  /// is to be scaled by `left`.
  TreeHit hit(int tree, double time, double energy, const Vec<D>& position, Vec<D>& velocity, double& left) {
    hit_.push_back(tree);
    const Stem& stem = trees_.forest->stems()[static_cast<std::size_t>(tree)];
    const TreeEffect effect = effect_of(trees_.law, stem, tree, energy, position.template head<2>(),
                                        velocity.template head<2>(), key_);
    left = effect.left;
    velocity *= left;
    if (effect.turn != 0) turn(velocity, effect.turn);
    double height = 0;
    if constexpr (D == 3)
      height =
          position.z() - ground_of(terrain_).height(stem.place.x(), stem.place.y()).value_or(position.z());
    return {tree, time, energy, left * left * energy, height};
  }

 private:
  static void turn(Vec<D>& velocity, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    const Vec2 before = velocity.template head<2>();
    velocity.template head<2>() = Vec2(c * before.x() - s * before.y(), s * before.x() + c * before.y());
  }

  const RunForest& trees_;
  const Terrain& terrain_;
  double radius_;  ///< m
  DrawKey key_;
  std::vector<int> hit_;
};

}  // namespace flyrock
