#pragma once
// Whole numbers as bytes with 7 bits each; the highest bit is 0 in the last byte (LEB128).

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

}  // namespace flyrock
