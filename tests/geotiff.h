#pragma once
// GeoTIFFs that tests write, byte by byte, so that they need no GDAL.

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "math/space.h"

namespace flyrock {

/// 32-bit heights in one strip. Source: TIFF 6.0 (Adobe); OGC GeoTIFF 1.1; gdal.org, GTiff driver.
struct GeoTiff {
  std::vector<std::vector<float>> rows;  ///< the northern row first
  double cell = 1, cell_y = 0;           ///< cell_y: 0: as `cell`
  Vec2 north_west = Vec2::Zero();        ///< corner of the first cell
  std::string no_data = {};              ///< empty: no tag
  std::string scale = {}, offset = {}, unit = {};
  std::vector<std::vector<int>> mask = {};  ///< 0: no data; empty: no mask
  std::uint16_t epsg = 0;                   ///< of a projected system; 0: not said
  std::uint16_t geographic = 0;             ///< of a system in degrees

  std::string bytes() const {
    std::string file = std::string("II*\0", 4) + number_bytes(std::uint32_t{0});
    std::size_t next = 4;  // where the offset of the next directory stands
    std::string heights;
    for (const auto& row : rows)
      for (const float z : row) heights += number_bytes(z);
    add_directory(file, next, heights, height_tags());
    if (!mask.empty()) {
      std::string valid;
      for (const auto& row : mask)
        for (const int cell_is_valid : row) valid += static_cast<char>(cell_is_valid ? 255 : 0);
      add_directory(file, next, valid, {number(254, 4), number(258, 8), number(262, 4), number(339, 1)});
    }
    return file;
  }

 private:
  struct Tag {
    std::uint16_t tag, type;  ///< type: 2 text, 3 short, 4 long, 12 double
    std::uint32_t count;
    std::string value;
  };

  template <class Number>
  static std::string number_bytes(Number value) {
    return {reinterpret_cast<const char*>(&value), sizeof value};  // little-endian, as this machine
  }
  static Tag number(std::uint16_t tag, std::uint32_t value) { return {tag, 4, 1, number_bytes(value)}; }
  template <class Numbers>
  static Tag list(std::uint16_t tag, std::uint16_t type, const Numbers& all) {
    Tag t{tag, type, static_cast<std::uint32_t>(all.size()), {}};
    for (const auto& value : all) t.value += number_bytes(value);
    return t;
  }
  static Tag text(std::uint16_t tag, const std::string& value) { return list(tag, 2, value + '\0'); }

  std::vector<Tag> height_tags() const {
    std::vector<Tag> tags = {
        number(258, 32), number(262, 1), number(339, 3),
        list(33550, 12, std::vector<double>{cell, cell_y == 0 ? cell : cell_y, 0}),
        list(33922, 12, std::vector<double>{0, 0, 0, north_west.x(), north_west.y(), 0})};
    using Keys = std::vector<std::uint16_t>;
    if (geographic)
      tags.push_back(list(34735, 3, Keys{1, 1, 0, 2, 1024, 0, 1, 2, 2048, 0, 1, geographic}));
    else if (epsg)
      tags.push_back(list(34735, 3, Keys{1, 1, 0, 2, 1024, 0, 1, 1, 3072, 0, 1, epsg}));
    else
      tags.push_back(list(34735, 3, Keys{1, 1, 0, 1, 1024, 0, 1, 1}));
    std::string items;
    const auto item = [&](const char* name, const char* role, const std::string& value) {
      if (!value.empty())
        items += std::string("<Item name=\"") + name + "\" sample=\"0\" role=\"" + role + "\">" + value +
                 "</Item>";
    };
    item("OFFSET", "offset", offset);
    item("SCALE", "scale", scale);
    item("UNITTYPE", "unittype", unit);
    if (!items.empty()) tags.push_back(text(42112, "<GDALMetadata>" + items + "</GDALMetadata>"));
    if (!no_data.empty()) tags.push_back(text(42113, no_data));
    return tags;
  }

  /// Appends data and their directory, and writes the place of the directory at `next`.
  void add_directory(std::string& file, std::size_t& next, const std::string& data,
                     std::vector<Tag> tags) const {
    const auto height = static_cast<std::uint32_t>(rows.size()),
               width = static_cast<std::uint32_t>(rows[0].size());
    const auto data_at = static_cast<std::uint32_t>(file.size());
    file += data + std::string((4 - data.size() % 4) % 4, '\0');
    for (const auto& [tag, value] :
         std::vector<std::pair<std::uint16_t, std::uint32_t>>{{256, width},
                                                              {257, height},
                                                              {259, 1},
                                                              {273, data_at},
                                                              {277, 1},
                                                              {278, height},
                                                              {279, static_cast<std::uint32_t>(data.size())}})
      tags.push_back(number(tag, value));
    std::sort(tags.begin(), tags.end(), [](const Tag& a, const Tag& b) { return a.tag < b.tag; });
    file.replace(next, 4, number_bytes(static_cast<std::uint32_t>(file.size())));
    std::uint32_t values_at = static_cast<std::uint32_t>(file.size() + 2 + 12 * tags.size() + 4);
    std::string values;
    file += number_bytes(static_cast<std::uint16_t>(tags.size()));
    for (const Tag& t : tags) {
      file += number_bytes(t.tag) + number_bytes(t.type) + number_bytes(t.count);
      if (t.value.size() <= 4) {
        file += t.value + std::string(4 - t.value.size(), '\0');
      } else {
        file += number_bytes(static_cast<std::uint32_t>(values_at + values.size()));
        values += t.value + std::string(t.value.size() % 2, '\0');
      }
    }
    next = file.size();
    file += number_bytes(std::uint32_t{0}) + values;
  }
};

}  // namespace flyrock
