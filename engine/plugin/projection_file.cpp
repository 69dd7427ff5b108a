#include "plugin/projection_file.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "plugin/words.h"

namespace flyrock {

namespace {

/// The number in UNIT["name",0.3048...] that stands last: of the projected system, not of its datum.
double last_unit(const std::string& text) {
  const std::size_t unit = text.rfind("UNIT[");
  const std::size_t comma = unit == text.npos ? text.npos : text.find(',', unit);
  if (comma == text.npos) return 0;
  const std::size_t end = text.find_first_of(",]", comma + 1);
  double metres = 0;
  return end != text.npos && to_number(text.substr(comma + 1, end - comma - 1), metres) ? metres : 0;
}

/// "EPSG:2056" of AUTHORITY["EPSG","2056"] or ID["EPSG",2056] at the end of a text: of all of it, not of its
/// datum or its unit.
std::string last_epsg(std::string text) {
  std::erase_if(text, [](char c) { return c == ' ' || c == '"' || c == '\n' || c == '\r' || c == '\t'; });
  for (const std::string_view start : {"AUTHORITY[EPSG,", "ID[EPSG,"}) {
    const std::size_t at = text.rfind(start);
    if (at == text.npos || !text.ends_with("]]")) continue;
    const std::string number = text.substr(at + start.size(), text.size() - 2 - at - start.size());
    const bool is_number = !number.empty() && number.find_first_not_of("0123456789") == number.npos;
    if (is_number) return "EPSG:" + number;
  }
  return {};
}

}  // namespace

Projection projection_beside(const std::string& grid) {
  std::ifstream file(std::filesystem::path(grid).replace_extension(".prj"), std::ios::binary);
  if (!file) return {};
  constexpr std::size_t longest = 100'000;
  std::string text;
  for (std::istreambuf_iterator<char> c(file), end; c != end && text.size() < longest; ++c) text += *c;
  Projection projection;
  projection.crs = last_epsg(text);
  projection.is_geographic = text.find("PROJCS[") == text.npos && text.find("GEOGCS[") != text.npos;
  if (projection.is_geographic) return projection;
  const double metres = last_unit(text);
  const auto is = [&](double unit) { return std::abs(metres - unit) < 1e-9; };
  projection.plan_unit = is(1) ? "m" : is(0.3048) ? "ft" : is(1200.0 / 3937.0) ? "us_ft" : "";
  return projection;
}

}  // namespace flyrock
