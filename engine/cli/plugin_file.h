#pragma once
// A user's own plugin, named on the command line by its file or folder.

#include <optional>
#include <string>
#include <vector>

#include "host/session.h"

namespace flyrock::cli {

/// Whether the word names a Lua file or a folder; KIND and KIND/NAME name plugins that are there already.
bool names_plugin_file(const std::string& word);

/// Loads it; what it registers, in the order of kinds. Its faults are printed; then there is nothing.
std::optional<std::vector<const Plugin*>> load_plugin_file(LuaSession& session, const std::string& path);

/// Where the function of a plugin stands in its file, or `native`: "law.lua:7:3".
std::string place_of(const PluginSpec& spec);

}  // namespace flyrock::cli
