#include "plugin/registry.h"

#include <fmt/format.h>

#include "plugin/gain.h"

namespace flyrock {

std::string Registry::add(Plugin plugin) {
  auto key = std::make_pair(plugin.spec.kind, plugin.spec.name);
  if (auto found = plugins_.find(key); found != plugins_.end())
    return fmt::format("the {} `{}` is already registered by {}", name_of(key.first), key.second,
                       found->second->spec.file);
  limit_gain(plugin);
  plugins_.emplace(std::move(key), std::make_unique<Plugin>(std::move(plugin)));
  return {};
}

const Plugin* Registry::find(PluginKind kind, std::string_view name) const {
  auto found = plugins_.find({kind, std::string(name)});
  return found == plugins_.end() ? nullptr : found->second.get();
}

std::vector<const Plugin*> Registry::of_kind(PluginKind kind) const {
  std::vector<const Plugin*> list;
  for (const auto& [key, plugin] : plugins_)
    if (key.first == kind) list.push_back(plugin.get());
  return list;
}

std::vector<std::string> Registry::names(PluginKind kind) const {
  std::vector<std::string> list;
  for (const Plugin* plugin : of_kind(kind)) list.push_back(plugin->spec.name);
  return list;
}

}  // namespace flyrock
