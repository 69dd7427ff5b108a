#pragma once
// The calls of contact laws, counted.

#include <cstdint>

namespace flyrock {

/// How often the laws of a material were called.
struct MaterialUse {
  std::uint64_t contacts = 0;  ///< contacts that used this material
  std::uint64_t restitution = 0, friction = 0, rolling = 0, unilateral = 0;

  void add(const MaterialUse& other) {
    contacts += other.contacts;
    restitution += other.restitution;
    friction += other.friction;
    rolling += other.rolling;
    unilateral += other.unilateral;
  }
};

}  // namespace flyrock
