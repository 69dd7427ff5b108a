#pragma once
// A box with sides along the axes.

#include "math/space.h"

namespace flyrock {

template <int D>
struct Box {
  Vec<D> low = Vec<D>::Zero(), high = Vec<D>::Zero();

  /// Without a point; any that is added is its first.
  static Box empty() { return {Vec<D>::Constant(1e300), Vec<D>::Constant(-1e300)}; }
  /// The box of points, at least one.
  template <class Points>
  static Box around(const Points& points) {
    Box box{*points.begin(), *points.begin()};
    for (const Vec<D>& point : points) box.add(point);
    return box;
  }
  void add(const Vec<D>& point) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  void add(const Box& other) {
    low = low.cwiseMin(other.low);
    high = high.cwiseMax(other.high);
  }
  Vec<D> size() const { return high - low; }
  Box grown(double by) const { return {low - Vec<D>::Constant(by), high + Vec<D>::Constant(by)}; }
  bool overlaps(const Box& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
};
using Box2 = Box<2>;
using Box3 = Box<3>;

}  // namespace flyrock
