// Grids in text files (raster_file.h).

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "plugin/params.h"
#include "plugin/words.h"
#include "survey/projection_file.h"
#include "survey/raster_file.h"
#include "units/units.h"

namespace flyrock {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double most_cells = 5e8;  // 4 GB of heights

/// Words that programs write where there is no number.
bool is_void_word(std::string_view word) {
  static constexpr std::array<std::string_view, 19> words = {
      "nan",  "-nan", "+nan", "1.#qnan", "-1.#qnan", "1.#ind",   "-1.#ind", "1.#inf", "-1.#inf",  "inf",
      "-inf", "*",    "--",   "na",      "n/a",      "infinity", "null",    "#n/a",   "-infinity"};
  const std::string text = lower(word);
  return text.starts_with("nan(") || text.starts_with("-nan(") ||
         std::find(words.begin(), words.end(), text) != words.end();
}

struct Header {
  int columns = 0, rows = 0;
  double cell = 0;
  Vec2 corner = Vec2::Zero();  ///< centre of the south-western cell
  std::vector<double> no_data = {};
  bool is_north_first = true;
};

/// A number with a comma in place of the point, which no grid has.
std::string comma_hint(std::string_view word) {
  const bool has_comma = word.find(',') != word.npos && word.find_first_not_of("+-0123456789,") == word.npos;
  return has_comma ? ": the file has decimal commas; export it with points" : "";
}

/// Names of the same key.
std::string known_key(std::string key) {
  if (key.ends_with(':')) key.pop_back();
  static const std::map<std::string, std::string> names = {{"xllcentre", "xllcenter"},
                                                           {"yllcentre", "yllcenter"},
                                                           {"nodata", "nodata_value"},
                                                           {"no_data", "nodata_value"},
                                                           {"no_data_value", "nodata_value"},
                                                           {"null", "nodata_value"},
                                                           {"cols", "ncols"},
                                                           {"rows", "nrows"},
                                                           {"cell_size", "cellsize"},
                                                           {"xdim", "dx"},
                                                           {"ydim", "dy"}};
  const auto found = names.find(key);
  return found == names.end() ? key : found->second;
}

/// The lines of a keyword and a number, up to the first value.
class KeywordHeader {
 public:
  explicit KeywordHeader(Words& words) : words_(words) {}

  Header read() {
    for (double ignored = 0;
         !words_.peek().empty() && !to_number(words_.peek(), ignored) && !is_void_word(words_.peek());)
      read_line();
    for (const char* key : {"ncols", "nrows"}) require(key);
    if (!has("dx") && !has("dy") && !has("north")) require("cellsize");
    Header header{.columns = static_cast<int>(values_["ncols"]), .rows = static_cast<int>(values_["nrows"])};
    check_count(values_["ncols"] * values_["nrows"]);
    const Vec2 cell = cell_size();
    header.cell = square(cell);
    header.corner = corner(cell);
    header.no_data = {has("nodata_value") ? values_["nodata_value"] : -9999};
    return header;
  }

  static void check_count(Words& words, double cells) {
    if (cells > most_cells)
      words.fail(fmt::format("the grid has {:.3g} cells, expected at most {:.3g}", cells, most_cells));
  }

 private:
  bool has(const std::string& key) const { return values_.contains(key); }
  void check_count(double cells) { check_count(words_, cells); }

  void read_line() {
    static const std::vector<std::string> keys = {"ncols",     "nrows",     "xllcorner", "yllcorner",
                                                  "xllcenter", "yllcenter", "cellsize",  "nodata_value",
                                                  "dx",        "dy"};
    static const std::vector<std::string> edges = {"north", "south", "east", "west"};
    const std::string word = lower(words_.next());
    const std::string key = known_key(word);
    const auto is_in = [&](const std::vector<std::string>& list) {
      return std::find(list.begin(), list.end(), key) != list.end();
    };
    if (word.starts_with("dsbb") || word.starts_with("dsrb"))
      words_.fail("this is a binary grid of Surfer: save it as a Surfer 6 text grid (it begins with DSAA)");
    if (key == "type") {  // GRASS names the type of its numbers
      words_.next();
      return;
    }
    if (!is_in(keys) && !is_in(edges))
      words_.fail(
          fmt::format("unknown keyword `{}`, expected {}{}", word, fmt::join(keys, ", "), comma_hint(word)));
    if (has(key)) words_.fail(fmt::format("`{}` stands here a second time", key));
    if (key == "nodata_value" && is_void_word(words_.peek())) {
      words_.next();
      values_[key] = nothing;
      return;
    }
    const double value = values_[key] = words_.number(fmt::format("the value of `{}`", key));
    const bool is_count = key == "ncols" || key == "nrows";
    if (is_count && !(value >= 2 && value <= 1e6 && value == std::floor(value)))
      words_.fail(fmt::format("`{}` is {:.10g}, expected a whole number from 2 to 1000000", key, value));
    if ((key == "cellsize" || key == "dx" || key == "dy") && !(value > 0))
      words_.fail(fmt::format("`{}` is {:.10g}, expected more than 0 m", key, value));
  }

  void require(const std::string& key, const std::string& other = {}) {
    if (has(key) && has(other))
      words_.fail(fmt::format("the header has both `{}` and `{}`, expected one of them", key, other));
    if (has(key) || has(other)) return;
    words_.fail(fmt::format("the header ends here without `{}`{}", key,
                            other.empty() ? "" : fmt::format(" or `{}`", other)));
  }

  Vec2 cell_size() {
    if (has("north")) {
      for (const char* key : {"south", "east", "west"}) require(key);
      return {(values_["east"] - values_["west"]) / values_["ncols"],
              (values_["north"] - values_["south"]) / values_["nrows"]};
    }
    if (has("cellsize")) return Vec2::Constant(values_["cellsize"]);
    for (const char* key : {"dx", "dy"}) require(key);
    return {values_["dx"], values_["dy"]};
  }

  double square(const Vec2& cell) {
    const auto side = square_cell(cell.x(), cell.y());
    if (!side || !(*side > 0))
      words_.fail(fmt::format(
          "the cells are {:.10g} m by {:.10g} m, expected squares: resample the grid, for example "
          "with `gdalwarp -tr {:.6g} {:.6g}`",
          cell.x(), cell.y(), cell.x(), cell.x()));
    return *side;
  }

  Vec2 corner(const Vec2& cell) {
    if (has("north")) return Vec2(values_["west"], values_["south"]) + 0.5 * cell;
    require("xllcorner", "xllcenter");
    require("yllcorner", "yllcenter");
    return {has("xllcenter") ? values_["xllcenter"] : values_["xllcorner"] + cell.x() / 2,
            has("yllcenter") ? values_["yllcenter"] : values_["yllcorner"] + cell.y() / 2};
  }

  Words& words_;
  std::map<std::string, double> values_;
};

/// `DSAA`, the numbers of columns and rows, and the ranges of x, y and z at the nodes.
Header surfer_header(Words& words) {
  constexpr double blank = 1.70141e38;  // Surfer's value for a node without data
  words.next();
  double n[8];
  for (double& number : n) number = words.number("a number of the header of a Surfer grid");
  for (int k = 0; k < 2; ++k)
    if (!(n[k] >= 2 && n[k] <= 1e6 && n[k] == std::floor(n[k])))
      words.fail(
          fmt::format("the Surfer grid has {:.10g} x {:.10g} nodes, expected whole numbers from 2 to 1000000",
                      n[0], n[1]));
  KeywordHeader::check_count(words, n[0] * n[1]);
  const Vec2 cell((n[3] - n[2]) / (n[0] - 1), (n[5] - n[4]) / (n[1] - 1));
  const auto side = square_cell(cell.x(), cell.y());
  if (!side || !(*side > 0))
    words.fail(fmt::format("the cells are {:.10g} m by {:.10g} m, expected squares: resample the grid",
                           cell.x(), cell.y()));
  return {.columns = static_cast<int>(n[0]),
          .rows = static_cast<int>(n[1]),
          .cell = *side,
          .corner = Vec2(n[2], n[4]),
          .no_data = {blank},
          .is_north_first = false};
}

/// The values, row by row as they stand in the file.
class GridValues {
 public:
  GridValues(Words& words, const Header& header) : words_(words), header_(header) {}

  void read(HeightGrid& grid) {
    for (int i = 0; i < grid.rows; ++i) {
      const int row = header_.is_north_first ? grid.rows - 1 - i : i;
      double* heights = grid.heights.data() + static_cast<std::size_t>(row) * grid.columns;
      for (int column = 0; column < grid.columns; ++column) heights[column] = value(i, column);
    }
    if (const std::string_view word = words_.next(); !word.empty())
      words_.fail(fmt::format("`{}` follows the {} rows of {} values that the header announces{}{}", word,
                              header_.rows, header_.columns, hint(), comma_hint(word)));
  }

 private:
  double value(int rows_read, int column) {
    const std::string_view word = words_.next();
    double height = 0;
    if (!to_number(word, height)) {
      if (word.empty())
        words_.fail(fmt::format("the file ends after {} of {} rows of {} values{}", rows_read, header_.rows,
                                header_.columns, hint()));
      if (!is_void_word(word))
        words_.fail(fmt::format("`{}` is not a number, expected a height{}", word, comma_hint(word)));
      height = nothing;
    }
    for (const double no_data : header_.no_data)
      if (is_no_data(height, no_data)) height = nothing;
    see_line(column);
    return height;
  }

  /// A row may stand in several lines; where rows and lines differ, an error about their number says so.
  void see_line(int column) {
    if (odd_line_ == 0 && column == 0 && words_.line() == last_line_) odd_line_ = words_.line();
    if (odd_line_ == 0 && column > 0 && words_.line() != last_line_) odd_line_ = last_line_;
    last_line_ = words_.line();
  }

  std::string hint() const {
    return odd_line_ == 0 ? std::string()
                          : fmt::format("; line {} is the first that does not hold the {} values of a row",
                                        odd_line_, header_.columns);
  }

  Words& words_;
  const Header& header_;
  std::int64_t last_line_ = 0, odd_line_ = 0;
};

}  // namespace

RasterFile read_ascii_grid(const std::string& who, const std::string& path, std::optional<double> no_data) {
  Words words(who, path);
  const bool is_surfer = lower(words.peek()) == "dsaa";
  Header header = is_surfer ? surfer_header(words) : KeywordHeader(words).read();
  if (no_data) header.no_data.push_back(*no_data);
  RasterFile file;
  file.grid.columns = header.columns;
  file.grid.rows = header.rows;
  file.grid.cell = header.cell;
  file.grid.corner = header.corner;
  file.grid.heights.resize(static_cast<std::size_t>(header.columns) * header.rows);
  GridValues(words, header).read(file.grid);
  const Projection projection = projection_beside(path);
  if (projection.is_geographic && header.corner.cwiseAbs().maxCoeff() <= 360)
    throw PluginError(
        fmt::format("{}: {}: is in degrees, as the file .prj beside it says, expected metres: project it "
                    "first, for example with gdalwarp",
                    who, path));
  if (!projection.fault.empty())
    throw PluginError(
        fmt::format("{}: {}: the file .prj beside it is not understood: {}; or, where its numbers "
                    "are metres, remove that file",
                    who, path, projection.fault));
  file.plan_unit = projection.plan_unit;
  file.height_unit = projection.height_unit;
  if (!projection.is_geographic) file.crs = projection.crs;
  return file;
}

}  // namespace flyrock
