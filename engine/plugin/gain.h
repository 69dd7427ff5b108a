#pragma once
// Restitution above 1: an impact that gains energy. It is an error unless the law or the scenario permits it.

#include <string_view>

#include "plugin/registry.h"

namespace flyrock {

/// The parameter of a restitution law that permits answers above 1. A law whose manifest says `may_gain` has
/// none, and may answer so always.
inline constexpr std::string_view allow_gain = "allow_gain";

/// Gives a restitution law the parameter allow_gain.
void add_allow_gain(PluginSpec& spec);

/// Whether the limit `max` = 1 of a parameter is that of a restitution: allow_gain lifts it.
bool is_limit_of_gain(const PluginSpec& spec, const ParamSpec& param);

/// Lets the instances of a plugin that has the parameter allow_gain throw PluginError where they answer with
/// e_n or |e_t| above 1 and it is not true: "plugin newton: impact() returned e_n = 1.2, must be at most 1:
/// ...". Other plugins stay as they are.
void limit_gain(Plugin& plugin);

}  // namespace flyrock
