#include "plugins/read_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "survey/surveyed_terrain.h"

namespace flyrock::plugins {

PointFile read_points(const std::string& plugin, const std::string& path,
                      std::span<const TableColumn> columns) {
  const Value nowhere;
  Diagnostics diagnostics;
  const auto table = read_table(path, columns, {}, Node::root(nowhere), diagnostics, TableForm::points);
  if (!table) {
    std::vector<std::string> faults;
    for (const Diagnostic& fault : diagnostics.all())
      faults.push_back(fault.at.source ? fmt::format("plugin {}: {}:{}:{}: {}", plugin, fault.at.source->name,
                                                     fault.at.line, fault.at.column, fault.text)
                                       : fmt::format("plugin {}: {}", plugin, fault.text));
    throw FileFaults(std::move(faults));
  }
  PointFile file;
  file.other_heads = table->ignored();
  for (std::size_t row = 0; row < table->rows(); ++row) {
    std::vector<double>& point = file.points.emplace_back();
    for (const TableColumn& column : columns) point.push_back(table->number(row, column.name).value_or(0));
  }
  return file;
}

std::vector<Vec3> read_obj_points(const std::string& plugin, const std::string& path) {
  std::ifstream file(path);
  if (!file) throw PluginError(fmt::format("plugin {}: cannot read the file {}", plugin, path));
  std::vector<Vec3> points;
  int line_number = 0;
  for (std::string line; std::getline(file, line);) {
    ++line_number;
    line.erase(std::min(line.find('#'), line.size()));
    if (!line.starts_with("v ")) continue;
    std::istringstream words(line.substr(1));
    std::vector<double> numbers;
    for (std::string word; words >> word;) {
      const auto number = parse_number(word);
      if (!number)
        throw PluginError(
            fmt::format("plugin {}: {}:{}: `{}` is not a number", plugin, path, line_number, word));
      numbers.push_back(*number);
    }
    if (numbers.size() != 3)
      throw PluginError(fmt::format("plugin {}: {}:{}: expected three numbers, x, y and z, found {}", plugin,
                                    path, line_number, numbers.size()));
    points.emplace_back(numbers[0], numbers[1], numbers[2]);
  }
  return points;
}

}  // namespace flyrock::plugins
