#pragma once
// Counter-based random numbers: a number depends on where it is used, not on what was drawn before.

#include <cstdint>
#include <string_view>
#include <vector>

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

/// A table of streams that are drawn from another seed. Sobol indices exchange one stream at a time, and all
/// others keep their numbers (docs/numerics.md).
struct Exchange {
  std::uint64_t seed = 0;
  bool all_but = false;                   ///< every stream but those named
  std::vector<std::uint64_t> names = {};  ///< hashes, in rising order

  bool holds(std::uint64_t name_hash) const;
};

/// How the trials of a run cover the numbers of which each trial has one (random/sampling.h).
enum class Sampling { random, latin_hypercube, sobol };

/// From which numbers the streams of a scenario are drawn.
struct Streams {
  Streams(std::uint64_t of_seed = 1) : seed(of_seed) {}  // NOLINT: a seed is all that most streams have

  std::uint64_t seed;
  Sampling sampling = Sampling::random;
  std::uint64_t trials = 0;            ///< of a run, with a sampling that is not random
  int dimensions = 0;                  ///< draws that it covers
  const Exchange* exchange = nullptr;  ///< null: all streams have `seed`

  bool is_exchanged(std::uint64_t name_hash) const { return exchange && exchange->holds(name_hash); }
  /// The seed of a stream: the only place that reads the table.
  std::uint64_t seed_of(std::uint64_t name_hash) const {
    return is_exchanged(name_hash) ? exchange->seed : seed;
  }
};

/// The sequence uniform_at over n. Plugins receive it as `rng`.
class RandomStream {
 public:
  RandomStream(const Streams& streams, std::string_view name, const DrawKey& key)
      : RandomStream(streams, hash_name(name), key) {}
  RandomStream(const Streams& streams, std::uint64_t name_hash, const DrawKey& key)
      : seed_(streams.seed_of(name_hash)), name_(name_hash), key_(key) {}

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
