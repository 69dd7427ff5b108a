#include "random/stream.h"

#include <Random123/threefry.h>

#include <algorithm>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>

namespace flyrock {

std::uint64_t hash_name(std::string_view name) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (unsigned char c : name) hash = (hash ^ c) * 0x100000001b3ULL;
  return hash;
}

double uniform_at(std::uint64_t seed, std::uint64_t name_hash, const DrawKey& key, std::uint64_t n) {
  const r123::Threefry4x64::key_type k{{seed, name_hash, 0, 0}};
  const r123::Threefry4x64::ctr_type counter{{key.trial, key.hole << 32 | key.rock, key.impact, n / 4}};
  const std::uint64_t bits = r123::Threefry4x64()(counter, k)[n % 4];
  return (static_cast<double>(bits >> 11) + 0.5) * 0x1p-53;  // open interval, never 0 or 1
}

bool Exchange::holds(std::uint64_t name_hash) const {
  return std::binary_search(names.begin(), names.end(), name_hash) != all_but;
}

double RandomStream::normal() { return std::sqrt(2.0) * boost::math::erf_inv(2 * uniform() - 1); }

std::int64_t RandomStream::integer(std::int64_t low, std::int64_t high) {
  const auto count = static_cast<double>(high - low + 1);
  return low + static_cast<std::int64_t>(uniform() * count);
}

}  // namespace flyrock
