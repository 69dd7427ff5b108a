#pragma once
// A box with sides along the axes.

#include "math/space.h"

namespace flyrock {

template <int D>
struct Box {
  Vec<D> low = Vec<D>::Zero(), high = Vec<D>::Zero();
  bool overlaps(const Box& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
};
using Box2 = Box<2>;
using Box3 = Box<3>;

}  // namespace flyrock
