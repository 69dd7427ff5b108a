#pragma once
// LAS files for tests (ASPRS LAS 1.4 R15).

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "math/space.h"

namespace las_files {

struct LasPoint {
  flyrock::Vec3 place;
  int group = 2;  ///< its class
  bool is_withheld = false;
};

struct LasKind {
  int minor = 2, format = 0;
  std::size_t length = 20;  ///< of a record
  int epsg = 0;             ///< 0: no record says the system
  int linear_unit = 0;      ///< of GeoTIFF: 9001 m, 9002 ft
};

template <class Number>
void put(std::string& bytes, std::size_t at, Number number) {
  std::memcpy(bytes.data() + at, &number, sizeof number);
}

/// Places to 1 mm about an offset.
inline std::string las_of(const std::vector<LasPoint>& points, const LasKind& kind = {}) {
  const flyrock::Vec3 offset(2600000, 1200000, 0);
  const std::size_t head_size = kind.minor == 4 ? 375 : 227;
  std::string keys;
  if (kind.epsg > 0) {
    const std::vector<std::uint16_t> numbers = {1,    1, 0, 2,
                                                3072, 0, 1, static_cast<std::uint16_t>(kind.epsg),
                                                3076, 0, 1, static_cast<std::uint16_t>(kind.linear_unit)};
    keys.assign(54 + 2 * numbers.size(), '\0');
    std::memcpy(keys.data() + 2, "LASF_Projection", 15);
    put(keys, 18, std::uint16_t{34735});
    put(keys, 20, static_cast<std::uint16_t>(2 * numbers.size()));
    std::memcpy(keys.data() + 54, numbers.data(), 2 * numbers.size());
  }
  std::string head(head_size, '\0');
  std::memcpy(head.data(), "LASF", 4);
  head[24] = 1;
  head[25] = static_cast<char>(kind.minor);
  put(head, 94, static_cast<std::uint16_t>(head_size));
  put(head, 96, static_cast<std::uint32_t>(head_size + keys.size()));
  put(head, 100, static_cast<std::uint32_t>(kind.epsg > 0 ? 1 : 0));
  head[104] = static_cast<char>(kind.format);
  put(head, 105, static_cast<std::uint16_t>(kind.length));
  put(head, 107, static_cast<std::uint32_t>(kind.minor == 4 ? 0 : points.size()));
  if (kind.minor == 4) put(head, 247, static_cast<std::uint64_t>(points.size()));
  for (int k = 0; k < 3; ++k) {
    put(head, 131 + 8 * static_cast<std::size_t>(k), 0.001);
    put(head, 155 + 8 * static_cast<std::size_t>(k), offset[k]);
  }
  std::string bytes = head + keys;
  for (const LasPoint& point : points) {
    std::string record(kind.length, '\0');
    for (int k = 0; k < 3; ++k)
      put(record, 4 * static_cast<std::size_t>(k),
          static_cast<std::int32_t>(std::lround((point.place[k] - offset[k]) / 0.001)));
    if (kind.format >= 6) {
      record[15] = point.is_withheld ? 4 : 0;
      record[16] = static_cast<char>(point.group);
    } else {
      record[15] = static_cast<char>(point.group | (point.is_withheld ? 0x80 : 0));
    }
    bytes += record;
  }
  return bytes;
}

}  // namespace las_files
