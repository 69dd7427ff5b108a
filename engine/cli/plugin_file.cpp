#include "cli/plugin_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/terminal.h"
#include "document/yaml_text.h"
#include "files/safe_file.h"
#include "host/locate.h"
#include "host/lua_tokens.h"
#include "host/manifest.h"

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
  tell("{}", diagnostics.to_text());
  if (diagnostics.has_errors()) return std::nullopt;
  std::vector<const Plugin*> own = all_plugins(session.registry());
  std::erase_if(own, [&](const Plugin* plugin) {
    return std::find(before.begin(), before.end(), plugin) != before.end();
  });
  return own;
}

std::string place_of(const PluginSpec& spec) {
  const auto source = source_of(read_file(spec.file), spec.file);
  const std::vector<LuaToken> tokens = lua_tokens(source->lines);
  const auto is_name = [&](const LuaToken& token, const Location& at) {
    return token.line == at.line && token.column == at.column && token.text == spec.name;
  };
  Location place{source, 1, 1};
  for (const LuaToken& call : tokens) {  // because a file may register several plugins
    if (!call.is("plugin")) continue;
    const FieldPlaces fields(source, "plugin", call.line);
    const Location name = fields.value("name");
    if (std::any_of(tokens.begin(), tokens.end(),
                    [&](const LuaToken& token) { return is_name(token, name); }))
      place = fields.key(spec.native.empty() ? std::string(entry_point(spec.kind)) : "native");
  }
  return fmt::format("{}:{}:{}", spec.file, place.line, place.column);
}

}  // namespace flyrock::cli
