#pragma once
// Lines of a text of points: which numbers of a line are x, y and z.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "math/space.h"
#include "survey/written_digits.h"

namespace flyrock {

/// Reads the lines of a file in their order. Values are apart by blanks, tabs, commas or semicolons; 1,5 is
/// 1.5 except between commas. The columns are those of the heads (x or easting, y or northing, z or
/// elevation) of the first line or of a comment above the points; without heads the first three. A line of
/// one whole number above the points is their count, as CloudCompare and PTS files have it.
class XyzLines {
 public:
  /// A place, in the units of the file; nothing of a line that is no point. Throws std::invalid_argument.
  std::optional<Vec3> read(std::string_view line);

  /// What is wrong with the file as a whole, after its last line; empty: nothing.
  std::string fault() const;
  std::string note() const { return digits_.note(); }
  /// ft or us_ft, as the heads say it; empty: metres, or not known.
  const std::string& unit() const { return unit_; }

 private:
  void cut(std::string_view line);
  bool take_heads(std::string_view line);
  bool begin(std::string_view line);
  double number(std::size_t column);

  std::vector<std::string_view> fields_;
  std::array<std::size_t, 3> columns_ = {0, 1, 2};
  std::size_t heads_ = 0;  ///< 0: none
  bool heads_in_comment_ = false, has_begun_ = false;
  std::optional<std::uint64_t> announced_;
  std::uint64_t points_ = 0;
  bool is_counted_ = true;  ///< the first of more than three columns counts the points
  std::string unit_, word_;
  WrittenDigits digits_;
};

}  // namespace flyrock
