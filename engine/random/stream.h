#pragma once
// Counter-based random numbers: a number depends on where it is used, not on what was drawn before.

#include <cstdint>
#include <string_view>

namespace flyrock {

/// A 64-bit hash of a stream's name (FNV-1a), the same on every machine.
std::uint64_t hash_name(std::string_view name);

/// Where in a run a number is drawn. A scope sets the parts that it depends on and leaves the others 0. For
/// example, a number that is drawn once per trial sets only `trial`.
struct DrawKey {
  std::uint64_t trial = 0;
  std::uint64_t hole = 0;    ///< 1 + index of the hole; 0: not used
  std::uint64_t rock = 0;    ///< 1 + index of the rock in its trial; 0: not used
  std::uint64_t impact = 0;  ///< impact number, from 1; 0: not used
};

/// The n-th uniform number in the open interval (0, 1) of stream `name_hash` at `key`.
/// Threefry-4x64-20 (Random123): key = (seed, name_hash), counter = (trial, hole and rock, impact, n / 4).
double uniform_at(std::uint64_t seed, std::uint64_t name_hash, const DrawKey& key, std::uint64_t n = 0);

/// The sequence uniform_at over n. Plugins receive it as `rng`.
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::string_view name, const DrawKey& key)
      : RandomStream(seed, hash_name(name), key) {}
  RandomStream(std::uint64_t seed, std::uint64_t name_hash, const DrawKey& key)
      : seed_(seed), name_(name_hash), key_(key) {}

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
