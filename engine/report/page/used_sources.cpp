#include "report/page/used_sources.h"

#include <set>
#include <string>
#include <string_view>

namespace flyrock {

namespace {

using Names = std::set<std::string, std::less<>>;

/// The texts of a value: of a sweep of types each of them.
void collect_texts(const Value& value, Names& names) {
  if (const std::string* text = value.text()) names.insert(*text);
  if (const List* list = value.list())
    for (const Value& item : *list) collect_texts(item, names);
  if (const Map* map = value.map())
    for (const Entry& entry : *map) collect_texts(entry.value, names);
}

/// What stands as a `type` anywhere in a document.
void collect_types(const Value& value, Names& names) {
  if (const List* list = value.list())
    for (const Value& item : *list) collect_types(item, names);
  if (const Map* map = value.map())
    for (const Entry& entry : *map) {
      if (entry.key == "type") collect_texts(entry.value, names);
      collect_types(entry.value, names);
    }
}

/// The plugin of "plugins/<kind>/<name>/plugin.lua"; empty for another source.
std::string_view own_plugin(std::string_view source) {
  constexpr std::string_view folder = "plugins/", manifest = "/plugin.lua";
  if (!source.starts_with(folder) || !source.ends_with(manifest)) return {};
  source = source.substr(folder.size(), source.size() - folder.size() - manifest.size());
  const std::size_t slash = source.find('/');
  return slash == std::string_view::npos ? std::string_view() : source.substr(slash + 1);
}

}  // namespace

std::vector<SourceHash> used_sources(const LoadedScenario& loaded) {
  Names names;
  collect_types(loaded.plan.resolved, names);
  std::vector<SourceHash> used;
  for (const SourceHash& source : loaded.sources) {
    const std::string_view plugin = own_plugin(source.name);
    if (plugin.empty() || names.contains(plugin)) used.push_back(source);
  }
  return used;
}

}  // namespace flyrock
