#include "random/sampling.h"

#include <algorithm>
#include <bit>
#include <boost/random/sobol.hpp>

namespace flyrock {

namespace {

constexpr int sobol_width = 32;
using Directions = std::array<std::uint32_t, sobol_width>;

/// The direction numbers of each coordinate. Boost gives points in the order of the Gray code, without the
/// first one, 0: the point that it counts as 2^(j+1) - 2 has the Gray code 2^j, and so is the j-th direction.
std::vector<Directions> make_directions() {
  constexpr std::size_t dimensions = 2 * std::size_t{most_sobol_dimensions};
  boost::random::sobol_engine<std::uint32_t, sobol_width> points(dimensions);
  std::vector<Directions> directions(dimensions);
  for (std::size_t j = 0; j < sobol_width; ++j) {
    points.seed(static_cast<std::uint32_t>((std::uint64_t{1} << (j + 1)) - 2));
    for (Directions& of : directions) of[j] = points();
  }
  return directions;
}

/// 53 random bits.
std::uint64_t random_bits(std::uint64_t seed, std::uint64_t name_hash, const DrawKey& key) {
  return static_cast<std::uint64_t>(uniform_at(seed, name_hash, key) * 0x1p53);
}

}  // namespace

std::string_view name_of(Sampling sampling) {
  constexpr std::array<std::string_view, 3> names{"random", "latin_hypercube", "sobol"};
  return names[static_cast<std::size_t>(sampling)];
}

std::string_view trials_fault(Sampling sampling, std::uint64_t trials) {
  if (sampling == Sampling::random) return {};
  if (trials % replicates != 0) return "expected a multiple of 16, because the run has 16 replicates";
  if (sampling == Sampling::sobol && !std::has_single_bit(trials / replicates))
    return "expected 16 times a power of two, because Sobol's points are even in blocks of these lengths";
  return {};
}

std::uint32_t sobol_bits(std::uint64_t t, int dimension) {
  static const std::vector<Directions> directions = make_directions();
  std::uint32_t bits = 0;
  for (std::size_t j = 0; t >> j != 0; ++j)
    if (t >> j & 1) bits ^= directions[static_cast<std::size_t>(dimension)][j];
  return bits;
}

std::uint64_t permuted(std::uint64_t index, std::uint64_t count, std::uint64_t seed, std::uint64_t name_hash,
                       std::uint64_t round) {
  constexpr std::uint64_t rounds = 6;
  int half = 1;
  while (std::uint64_t{1} << (2 * half) < count) ++half;
  const std::uint64_t mask = (std::uint64_t{1} << half) - 1;
  do {
    std::uint64_t left = index >> half, right = index & mask;
    for (std::uint64_t r = 0; r < rounds; ++r) {
      // No trial has such a number of an impact, so that these numbers are those of no draw.
      const DrawKey key{.trial = round, .hole = 0, .rock = right, .impact = ~std::uint64_t{0} - r};
      const std::uint64_t next = left ^ (random_bits(seed, name_hash, key) & mask);
      left = right;
      right = next;
    }
    index = left << half | right;
  } while (index >= count);
  return index;
}

double sampled_at(const Streams& streams, std::uint64_t name_hash, int dimension, std::uint64_t trial) {
  const std::uint64_t m = streams.trials / replicates, seed = streams.seed_of(name_hash);
  const std::uint64_t replicate = trial / m, t = trial % m;
  if (streams.sampling == Sampling::latin_hypercube) {
    const double v = uniform_at(seed, name_hash, {.trial = trial});
    const auto part = static_cast<double>(permuted(t, m, seed, name_hash, replicate));
    return std::min((part + v) / static_cast<double>(m), 0x1.fffffffffffffp-1);  // never 1, by rounding
  }
  const int coordinate = dimension + (streams.is_exchanged(name_hash) ? streams.dimensions : 0);
  constexpr std::uint64_t no_impact = ~std::uint64_t{0};
  const std::uint64_t shift =
      random_bits(seed, name_hash, {.trial = replicate, .hole = 0, .rock = 0, .impact = no_impact});
  const std::uint64_t bits = (static_cast<std::uint64_t>(sobol_bits(t, coordinate)) << 21) ^ shift;
  return (static_cast<double>(bits) + 0.5) * 0x1p-53;
}

}  // namespace flyrock
