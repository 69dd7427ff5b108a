#pragma once
// Counter-based random numbers: a number is a function of where it is used, not of what was drawn before.

#include <array>
#include <cstdint>
#include <string_view>

namespace flyrock {

/// A 64-bit hash of a stream's name (FNV-1a): the same on every machine.
std::uint64_t hash_name(std::string_view name);

/// Where in a run a number is drawn. A scope uses the parts that it depends on and leaves the rest 0:
/// a number drawn once a trial has only `trial`.
struct DrawKey {
  std::uint64_t trial = 0;
  std::uint64_t hole = 0;    ///< 1 + index of the hole, 0 where it does not matter
  std::uint64_t rock = 0;    ///< 1 + index of the rock in its trial, 0 where it does not matter
  std::uint64_t impact = 0;  ///< impact number, from 1; 0 where it does not matter
};

/// The n-th uniform number in the open interval (0, 1) of stream `name_hash` at `key`.
/// Threefry-4x64-20 (Random123): key = (seed, name_hash), counter = (trial, hole and rock, impact, n / 4).
double uniform_at(std::uint64_t seed, std::uint64_t name_hash, const DrawKey& key, std::uint64_t n = 0);

/// A sequence over n of uniform_at: what plugins receive as `rng`.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::string_view name, const DrawKey& key)
      : seed_(seed), name_(hash_name(name)), key_(key) {}

  double uniform() { return uniform_at(seed_, name_, key_, next_++); }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  double normal();
  /// An integer from low to high, both included.
  std::int64_t integer(std::int64_t low, std::int64_t high);
  /// Whether a number has been drawn.
  bool drawn() const { return next_ > 0; }

 private:
  std::uint64_t seed_;
  std::uint64_t name_;
  DrawKey key_;
  std::uint64_t next_ = 0;
};

}  // namespace flyrock
