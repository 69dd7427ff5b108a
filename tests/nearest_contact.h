#pragma once
// The contact with the smallest gap.

#include <algorithm>
#include <vector>

#include "collision/contact.h"

namespace flyrock {

/// There must be one.
template <int D>
const ContactPoint<D>& nearest_of(const std::vector<ContactPoint<D>>& contacts) {
  return *std::min_element(contacts.begin(), contacts.end(),
                           [](const auto& a, const auto& b) { return a.gap < b.gap; });
}

}  // namespace flyrock
