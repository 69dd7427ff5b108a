#pragma once
// Contactors of one body that overlap each other.

#include <optional>

#include "world/body.h"

namespace flyrock {

struct PartOverlap {
  std::size_t a = 0, b = 0;  ///< contactors of the body, a < b
  double depth = 0;          ///< m
};

/// The two contactors of a body that overlap deepest, by more than 1e-6 of the body's size; nothing if none
/// do. Only pairs whose boxes overlap are tried.
template <int D>
std::optional<PartOverlap> deepest_overlap_of_parts(const Body<D>& body);

}  // namespace flyrock
