#pragma once
// Whether two contacts are one: the same features of the same bodies.

#include <algorithm>

#include "world/world.h"

namespace flyrock {

template <int D>
bool is_same(const WorldContact<D>& a, const WorldContact<D>& b) {
  return a.candidate == b.candidate && a.antagonist == b.antagonist && a.at.feature == b.at.feature &&
         a.at.against == b.at.against;
}

/// Whether a list has a contact with the same features of the same bodies.
template <class List, int D>
bool has_same(const List& list, const WorldContact<D>& contact) {
  return std::any_of(list.begin(), list.end(),
                     [&](const WorldContact<D>& other) { return is_same(other, contact); });
}

}  // namespace flyrock
