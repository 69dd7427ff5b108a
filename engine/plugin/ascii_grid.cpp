#include "plugin/ascii_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "plugin/params.h"
#include "plugin/words.h"

namespace flyrock {

namespace {

constexpr double no_data = std::numeric_limits<double>::quiet_NaN();
constexpr double most_cells = 5e8;  // 4 GB of heights

std::string lower(std::string_view word) {
  std::string text(word);
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

struct Header {
  int columns = 0, rows = 0;
  double cell = 0;
  Vec2 corner = Vec2::Zero();  ///< centre of the south-western cell
  double no_data_value = -9999;
};

/// Reads the lines of a keyword and a number, up to the first number that stands alone.
Header read_header(Words& words) {
  static const std::vector<std::string> keys = {"ncols",     "nrows",     "xllcorner", "yllcorner",
                                                "xllcenter", "yllcenter", "cellsize",  "nodata_value"};
  std::map<std::string, double> values;
  for (double ignored = 0; !words.peek().empty() && !to_number(words.peek(), ignored);) {
    const std::string key = lower(words.next());
    if (key == "nan") words.fail("the values begin before the header is complete");
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
      words.fail(fmt::format("unknown keyword `{}`, expected {}", key, fmt::join(keys, ", ")));
    if (values.contains(key)) words.fail(fmt::format("`{}` stands here a second time", key));
    if (key == "nodata_value" && lower(words.peek()) == "nan") {
      words.next();
      values[key] = no_data;
      continue;
    }
    values[key] = words.number(fmt::format("the value of `{}`", key));
    const bool is_count = key == "ncols" || key == "nrows";
    if (is_count && !(values[key] >= 2 && values[key] <= 1e6 && values[key] == std::floor(values[key])))
      words.fail(fmt::format("`{}` is {:.10g}, expected a whole number from 2 to 1000000", key, values[key]));
    if (key == "cellsize" && !(values[key] > 0))
      words.fail(fmt::format("`cellsize` is {:.10g}, expected more than 0 m", values[key]));
  }
  const auto require = [&](const std::string& key, const std::string& other = {}) {
    if (values.contains(key) && values.contains(other))
      words.fail(fmt::format("the header has both `{}` and `{}`, expected one of them", key, other));
    if (values.contains(key) || values.contains(other)) return;
    words.fail(fmt::format("the header ends here without `{}`{}", key,
                           other.empty() ? "" : fmt::format(" or `{}`", other)));
  };
  for (const char* key : {"ncols", "nrows", "cellsize"}) require(key);
  require("xllcorner", "xllcenter");
  require("yllcorner", "yllcenter");
  if (values["ncols"] * values["nrows"] > most_cells)
    words.fail(fmt::format("the grid has {:.3g} cells, expected at most {:.3g}",
                           values["ncols"] * values["nrows"], most_cells));
  Header header{.columns = static_cast<int>(values["ncols"]),
                .rows = static_cast<int>(values["nrows"]),
                .cell = values["cellsize"]};
  const double half = header.cell / 2;
  header.corner.x() = values.contains("xllcenter") ? values["xllcenter"] : values["xllcorner"] + half;
  header.corner.y() = values.contains("yllcenter") ? values["yllcenter"] : values["yllcorner"] + half;
  if (values.contains("nodata_value")) header.no_data_value = values["nodata_value"];
  return header;
}

}  // namespace

HeightGrid read_ascii_grid(const std::string& who, const std::string& path) {
  Words words(who, path);
  const Header header = read_header(words);
  HeightGrid grid;
  grid.columns = header.columns;
  grid.rows = header.rows;
  grid.cell = header.cell;
  grid.corner = header.corner;
  grid.heights.resize(static_cast<std::size_t>(grid.columns) * grid.rows);
  // A row may stand in several lines; where rows and lines differ, an error about their number says so.
  std::int64_t last_line = 0, odd_line = 0;
  const auto hint = [&] {
    return odd_line == 0 ? std::string()
                         : fmt::format("; line {} is the first that does not hold the {} values of a row",
                                       odd_line, grid.columns);
  };
  for (int row = grid.rows - 1; row >= 0; --row) {
    double* heights = grid.heights.data() + static_cast<std::size_t>(row) * grid.columns;
    for (int column = 0; column < grid.columns; ++column) {
      const std::string_view word = words.next();
      double& height = heights[column];
      if (!to_number(word, height)) {
        if (word.empty())
          words.fail(fmt::format("the file ends after {} of {} rows of {} values{}", grid.rows - 1 - row,
                                 grid.rows, grid.columns, hint()));
        if (lower(word) != "nan") words.fail(fmt::format("`{}` is not a number, expected a height", word));
        height = no_data;
      } else if (height == header.no_data_value) {
        height = no_data;
      }
      if (odd_line == 0 && column == 0 && words.line() == last_line) odd_line = words.line();
      if (odd_line == 0 && column > 0 && words.line() != last_line) odd_line = last_line;
      last_line = words.line();
    }
  }
  if (const std::string_view word = words.next(); !word.empty())
    words.fail(fmt::format("`{}` follows the {} rows of {} values that the header announces{}", word,
                           grid.rows, grid.columns, hint()));
  return grid;
}

}  // namespace flyrock
