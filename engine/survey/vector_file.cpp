#include "survey/vector_file.h"

#include <fmt/format.h>

#include "plugin/params.h"
#include "survey/gdal_module.h"

namespace flyrock {

const std::string* VectorPart::value_of(const std::string& attribute) const {
  for (const auto& [name, value] : attributes)
    if (name == attribute) return &value;
  return nullptr;
}

VectorLayer read_vector_layer(const std::string& path, const std::string& layer, const std::string& crs,
                              const std::string& conversion) {
  const auto read = reinterpret_cast<VectorReader>(gdal_entry_point(path, vector_entry, conversion));
  VectorLayer found;
  std::vector<std::string> names;
  std::string wrong;
  read(path, layer, crs, found, names, wrong);
  if (!names.empty()) {
    std::string list;
    for (const std::string& name : names) list += fmt::format("{}`{}`", list.empty() ? "" : ", ", name);
    wrong = layer.empty() ? fmt::format("has {} layers, {}: write `name: {}` for the one that is meant",
                                        names.size(), list, names.front())
                          : fmt::format("has no layer `{}`, it has {}", layer, list);
  }
  if (!wrong.empty()) throw PluginError(fmt::format("{}: {}", path, wrong));
  return found;
}

}  // namespace flyrock
