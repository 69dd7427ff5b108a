#include "survey/xyz_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "document/printable.h"
#include "document/table_head.h"
#include "document/table_lines.h"
#include "plugin/words.h"

namespace flyrock {

namespace {

constexpr std::string_view blanks = " \t\r";

const std::vector<TableColumn>& place_columns() {
  static const std::vector<TableColumn> columns = {
      {"x", dimension::length},
      {"y", dimension::length},
      {"z", dimension::length, false, false, {"height", "h", "altitude"}}};
  return columns;
}

std::optional<std::uint64_t> whole_number(std::string_view word) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size() ? std::optional(value) : std::nullopt;
}

}  // namespace

/// Semicolons part before blanks, and blanks before commas.
void XyzLines::cut(std::string_view line) {
  fields_.clear();
  const auto cut_at = [&](char separator) {
    for (std::size_t begin = 0; begin <= line.size();) {
      const std::size_t end = std::min(line.find(separator, begin), line.size());
      fields_.push_back(without_blanks(line.substr(begin, end - begin)));
      begin = end + 1;
    }
    while (!fields_.empty() && fields_.back().empty()) fields_.pop_back();
  };
  if (line.find(';') != line.npos) return cut_at(';');
  for (std::size_t begin = line.find_first_not_of(blanks); begin != line.npos;) {
    const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
    std::string_view word = line.substr(begin, end - begin);
    if (word.ends_with(',')) word.remove_suffix(1);  // "1.5, 2.5, 3.5"
    if (!word.empty()) fields_.push_back(word);
    begin = line.find_first_not_of(blanks, end);
  }
  if (fields_.size() >= 3 || line.find(',') == line.npos) return;
  fields_.clear();
  cut_at(',');
}

bool XyzLines::take_heads(std::string_view line) {
  std::vector<TableField> heads = fields_apart_by(separator_of(line), line);
  while (!heads.empty() && heads.back().text.empty()) heads.pop_back();
  std::array<bool, 3> has{};
  std::string unit;
  for (std::size_t i = 0; i < heads.size(); ++i) {
    const HeadMatch match = match_head(heads[i].text, place_columns(), {});
    if (!match.column) continue;
    const auto axis = static_cast<std::size_t>(match.column - place_columns().data());
    if (has[axis]) continue;
    has[axis] = true;
    columns_[axis] = i;
    if (match.unit.unit.factor != 1) unit = match.unit.text;
  }
  if (!has[0] || !has[1] || !has[2]) {
    columns_ = {0, 1, 2};
    return false;
  }
  if (!unit.empty() && unit != "ft" && unit != "us_ft")
    throw std::invalid_argument(fmt::format("the heads are in `{}`, expected m or ft", unit));
  heads_ = heads.size();
  unit_ = unit;
  return true;
}

/// Reads what stands above the points; false: the line is a point.
bool XyzLines::begin(std::string_view line) {
  if (fields_.size() == 1 && !announced_)
    if ((announced_ = whole_number(fields_[0]))) return true;
  double value = 0;
  const bool has_columns = heads_ > 0 && heads_ == fields_.size();
  std::string first(fields_[has_columns ? columns_[0] : 0]);
  std::replace(first.begin(), first.end(), ',', '.');
  const bool is_point = to_number(first, value);
  if (!is_point && (heads_ > 0 && !heads_in_comment_))
    throw std::invalid_argument("expected x, y and z below the heads");
  if (is_point) {
    if (heads_in_comment_ && heads_ != fields_.size()) {  // a comment, and no heads
      heads_ = 0;
      columns_ = {0, 1, 2};
      unit_.clear();
    }
    has_begun_ = true;
    return false;
  }
  heads_in_comment_ = false;
  if (!take_heads(line))
    throw std::invalid_argument(
        fmt::format("`{}` is no point, and no heads with x, y and z: write them, or begin the line with #",
                    printable(std::string(without_blanks(line)), 40)));
  return true;
}

double XyzLines::number(std::size_t column) {
  if (column >= fields_.size())
    throw std::invalid_argument("expected x, y and z, apart by blanks or commas, the line ends before");
  std::string_view field = fields_[column];
  if (const std::size_t comma = field.find(','); comma != field.npos && field.find('.') == field.npos) {
    word_ = field;
    word_[comma] = '.';
    field = word_;
  }
  double value = 0;
  if (!to_number(field, value))
    throw std::invalid_argument(fmt::format("expected x, y and z, apart by blanks or commas, found `{}`",
                                            printable(std::string(field), 40)));
  return value;
}

std::optional<Vec3> XyzLines::read(std::string_view line) {
  line = without_blanks(line);
  const bool is_comment = line.starts_with('#') || line.starts_with("//");
  if (is_comment && !has_begun_ && heads_ == 0)
    heads_in_comment_ = take_heads(line.substr(std::min(line.find_first_not_of("#/ \t"), line.size())));
  if (is_comment || line.empty()) return std::nullopt;
  cut(line);
  if (fields_.empty() || (!has_begun_ && begin(line))) return std::nullopt;
  if (heads_ > 0 && fields_.size() != heads_)
    throw std::invalid_argument(fmt::format("the line has {} value{}, the heads are {}", fields_.size(),
                                            fields_.size() == 1 ? "" : "s", heads_));
  ++points_;
  Vec3 place;
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t column = columns_[static_cast<std::size_t>(axis)];
    place[axis] = number(column);
    digits_.add(axis, fields_[column]);
  }
  is_counted_ = is_counted_ && heads_ == 0 && fields_.size() > 3 && place.x() == static_cast<double>(points_);
  return place;
}

std::string XyzLines::fault() const {
  if (announced_ && *announced_ != points_)
    return fmt::format("announces {} points and has {}: it was cut, copy it again", *announced_, points_);
  if (is_counted_ && points_ > 2)
    return "its first column counts the points: write heads, such as `number x y z`";
  return digits_.fault();
}

}  // namespace flyrock
