#pragma once
// A plugin's manifest as text, Markdown and JSON.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "plugin/registry.h"

namespace flyrock::cli {

/// The plugins selected by "KIND" or "KIND/NAME"; all if the text is empty. Throws UsageError for an unknown
/// one.
std::vector<const PluginSpec*> select_plugins(const Registry& registry, const std::string& wanted);
/// Kind, name and purpose, 80 columns wide.
std::string short_text(const PluginSpec& spec);
/// The whole manifest, for a terminal.
std::string full_text(const PluginSpec& spec);
/// A section with a table of parameters; for a shape of flyrock also its picture, shapes/NAME.svg.
std::string markdown(const PluginSpec& spec);
/// { kind, name, doc, source, file, params: [{ name, type, unit, default, doc, ... }] }
nlohmann::ordered_json json_of(const PluginSpec& spec);

}  // namespace flyrock::cli
