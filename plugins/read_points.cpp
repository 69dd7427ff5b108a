#include "plugins/read_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "plugin/params.h"
#include "units/units.h"

namespace flyrock::plugins {

namespace {

/// What another separator makes of numbers.
std::string separator_hint(const std::string& word) {
  return word.find(';') == word.npos
             ? ""
             : ": its values are apart by `;`, expected commas or blanks, and a point in decimals";
}

std::vector<double> numbers_of(std::string line, const std::string& where) {
  std::replace(line.begin(), line.end(), ',', ' ');
  std::istringstream words(line);
  std::vector<double> numbers;
  for (std::string word; words >> word;) {
    const auto number = parse_number(word);
    if (!number)
      throw PluginError(fmt::format("{}: `{}` is not a number{}", where, word, separator_hint(word)));
    numbers.push_back(*number);
  }
  return numbers;
}

}  // namespace

std::vector<std::vector<double>> read_points(const std::string& plugin, const std::string& path,
                                             int columns) {
  std::ifstream file(path);
  if (!file) throw PluginError(fmt::format("plugin {}: cannot read the file {}", plugin, path));
  const bool is_obj = path.ends_with(".obj");
  std::vector<std::vector<double>> points;
  int line_number = 0;
  for (std::string line; std::getline(file, line);) {
    const std::string where = fmt::format("plugin {}: {}:{}", plugin, path, ++line_number);
    if (line_number == 1 && line.starts_with("\xEF\xBB\xBF"))
      line.erase(0, 3);  // byte order mark that spreadsheets write before UTF-8 text
    line.erase(std::min(line.find('#'), line.size()));
    if (is_obj) {
      if (!line.starts_with("v ")) continue;
      line.erase(0, 1);
    }
    std::vector<double> numbers = numbers_of(line, where);
    if (numbers.empty() && line.find(',') == line.npos) continue;
    if (static_cast<int>(numbers.size()) != columns)
      throw PluginError(fmt::format("{}: expected {}, found {}", where,
                                    columns == 2 ? "two numbers, x and y" : "three numbers, x, y and z",
                                    numbers.size()));
    points.push_back(std::move(numbers));
  }
  return points;
}

}  // namespace flyrock::plugins
