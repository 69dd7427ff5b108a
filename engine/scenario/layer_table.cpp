#include "scenario/layer_table.h"

#include <fmt/format.h>

#include <filesystem>

#include "document/table_lines.h"
#include "document/workbook.h"
#include "plugin/params.h"
#include "survey/vector_file.h"
#include "units/units.h"

namespace flyrock {

namespace {

bool is_of_layers(const std::string& file) {
  const std::string name = lower(file);
  for (const char* ending : {".gpkg", ".shp", ".dbf", ".geojson"})
    if (name.ends_with(ending)) return true;
  return false;
}

/// A line of heads, and a line for each feature.
TableText lines_of(const VectorLayer& layer, const std::string& file) {
  auto source = std::make_shared<Source>();
  source->name = file + "#" + layer.name;
  const auto add_line = [&](const auto& field_of) {
    std::vector<std::string> fields;
    for (const std::string& attribute : layer.attributes)
      fields.push_back(field_between_tabs(field_of(attribute)));
    source->lines.push_back(fmt::format("{}", fmt::join(fields, "\t")));
  };
  add_line([](const std::string& attribute) { return attribute; });
  int feature = 0;
  for (const VectorPart& part : layer.parts) {
    if (part.feature == feature) continue;  // another part of the same
    feature = part.feature;
    add_line([&](const std::string& attribute) {
      const std::string* value = part.value_of(attribute);
      return value ? *value : std::string();
    });
  }
  return {source, true, 0};
}

}  // namespace

std::optional<TextTable> read_any_table(const std::string& path, std::span<const TableColumn> columns,
                                        const std::map<std::string, std::string>& heads, const Node& where,
                                        Diagnostics& diagnostics) {
  const SheetName name = sheet_name(path);
  if (!is_of_layers(name.file)) return read_table(path, columns, heads, where, diagnostics);
  try {
    const VectorLayer layer =
        read_vector_layer(name.file, name.sheet, any_system,
                          fmt::format("convert it with `ogr2ogr table.csv {}`",
                                      std::filesystem::path(name.file).filename().string()));
    return read_table(lines_of(layer, name.file), columns, heads, where, diagnostics);
  } catch (const PluginError& error) {
    where.error(diagnostics, error.what());
    return std::nullopt;
  }
}

}  // namespace flyrock
