#pragma once
// Whole numbers as bytes with 7 bits each; the highest bit is 0 in the last byte (LEB128). Reals as the 8
// bytes of IEEE 754, and sums of weights, which are mostly whole numbers, as one of the two.

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "record/columns.h"

namespace flyrock {

inline void put_whole(std::string& bytes, std::uint64_t number) {
  for (; number >= 128; number >>= 7) bytes.push_back(static_cast<char>(number | 128));
  bytes.push_back(static_cast<char>(number));
}

/// Throws ColumnError.
inline std::uint64_t take_whole(std::string_view& bytes) {
  std::uint64_t number = 0;
  for (int shift = 0; shift < 64; shift += 7) {
    if (bytes.empty()) throw ColumnError("whole numbers end early");
    const auto byte = static_cast<unsigned char>(bytes.front());
    bytes.remove_prefix(1);
    number |= static_cast<std::uint64_t>(byte & 127) << shift;
    if (byte < 128) return number;
  }
  throw ColumnError("a whole number is too long");
}

inline void put_real(std::string& bytes, double value) {
  const auto word = std::bit_cast<std::uint64_t>(value);
  for (int shift = 0; shift < 64; shift += 8) bytes.push_back(static_cast<char>(word >> shift));
}

/// A finite number. Throws ColumnError.
inline double take_real(std::string_view& bytes) {
  if (bytes.size() < 8) throw ColumnError("numbers end early");
  std::uint64_t word = 0;
  for (int i = 0; i < 8; ++i)
    word |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[static_cast<std::size_t>(i)]))
            << 8 * i;
  bytes.remove_prefix(8);
  const double value = std::bit_cast<double>(word);
  if (!std::isfinite(value)) throw ColumnError("a number is not finite");
  return value;
}

/// A sum of weights: 1 + the number if that is whole, else 0 and the real.
inline void put_weight(std::string& bytes, double weight) {
  constexpr double most_whole = 0x1p52;
  if (weight >= 0 && weight < most_whole && weight == std::floor(weight))
    return put_whole(bytes, static_cast<std::uint64_t>(weight) + 1);
  put_whole(bytes, 0);
  put_real(bytes, weight);
}

/// Throws ColumnError.
inline double take_weight(std::string_view& bytes) {
  const std::uint64_t whole = take_whole(bytes);
  if (whole > 0) return static_cast<double>(whole - 1);
  const double weight = take_real(bytes);
  if (!(weight >= 0)) throw ColumnError("a weight is negative");
  return weight;
}

}  // namespace flyrock
