#pragma once
// A user's own plugin, given on the command line by its file or folder.

#include <optional>
#include <string>
#include <vector>

#include "host/session.h"

namespace flyrock::cli {

/// Whether the word is the path of a Lua file or a folder. KIND and KIND/NAME name registered plugins.
bool names_plugin_file(const std::string& word);

/// Loads it and returns the plugins that it registers, in the order of kinds. If it has faults, prints them
/// and returns nothing.
std::optional<std::vector<const Plugin*>> load_plugin_file(LuaSession& session, const std::string& path);

/// The place of a plugin's function in its file, or `native`: "law.lua:7:3".
std::string place_of(const PluginSpec& spec);

}  // namespace flyrock::cli
