#include "cli/plugin_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace flyrock::cli {

namespace fs = std::filesystem;

namespace {

std::vector<const Plugin*> all_plugins(const Registry& registry) {
  std::vector<const Plugin*> plugins;
  for (int kind = 0; kind < plugin_kinds; ++kind)
    for (const Plugin* plugin : registry.of_kind(static_cast<PluginKind>(kind))) plugins.push_back(plugin);
  return plugins;
}

}  // namespace

bool names_plugin_file(const std::string& word) {
  if (fs::path(word).extension() == ".lua") return true;
  std::error_code code;
  return fs::is_directory(word, code) && !plugin_kind(word.substr(0, word.find('/')));
}

std::optional<std::vector<const Plugin*>> load_plugin_file(LuaSession& session, const std::string& path) {
  const std::vector<const Plugin*> before = all_plugins(session.registry());
  Diagnostics diagnostics;
  session.load_plugin(path, path, {}, diagnostics);
  fmt::print(stderr, "{}", diagnostics.to_text());
  if (diagnostics.has_errors()) return std::nullopt;
  std::vector<const Plugin*> own = all_plugins(session.registry());
  std::erase_if(own, [&](const Plugin* plugin) { return std::find(before.begin(), before.end(), plugin) != before.end(); });
  return own;
}

}  // namespace flyrock::cli
