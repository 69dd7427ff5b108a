#pragma once
// Registered plugins with constant parameters, for tests.

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "host/session.h"
#include "plugin/registry.h"

namespace flyrock {

/// The value of a parameter in a test: a number, a text, or a list of points.
using Given = std::variant<double, const char*, std::vector<std::vector<double>>, std::vector<double>>;

/// An instance and its numbers.
template <class Interface>
struct Made {
  std::unique_ptr<Interface> model;
  std::vector<double> values;
};

template <class Interface>
Made<Interface> make(const LuaSession& session, PluginKind kind, const std::string& name,
                     const std::map<std::string, Given>& given, int dimension = 2) {
  const Plugin* plugin = session.registry().find(kind, name);
  if (!plugin) throw std::runtime_error("no plugin " + name);
  PluginUse use;
  use.plugin = plugin;
  for (const ParamSpec& spec : plugin->spec.params) {
    ParamValue value;
    const auto found = given.find(spec.name);
    // A parameter of a group has its default where another one of the group is given.
    const std::string group(spec.group());
    const bool has_group = group.empty() || std::any_of(given.begin(), given.end(), [&](const auto& one) {
                             return one.first.starts_with(group + ".");
                           });
    value.given = found != given.end() || (has_group && (spec.default_number || spec.default_text));
    const bool components = spec.type == ParamType::spin && dimension == 3;
    if (has_group && spec.default_number)
      value.numbers.assign(components ? 3 : 1, {*spec.default_number, -1});
    if (has_group && spec.default_text) value.text = *spec.default_text;
    if (found != given.end()) {
      if (auto number = std::get_if<double>(&found->second)) value.numbers = {{*number, -1}};
      if (auto text = std::get_if<const char*>(&found->second)) value.text = *text;
      if (auto points = std::get_if<std::vector<std::vector<double>>>(&found->second)) value.points = *points;
      if (std::get_if<std::vector<double>>(&found->second)) value.numbers.clear();
      if (auto vector = std::get_if<std::vector<double>>(&found->second))
        for (double component : *vector) value.numbers.push_back({component, -1});
    }
    use.values.push_back(value);
  }
  use.slots = dense_slots(use.values);
  Made<Interface> made{make_instance<Interface>(use, dimension), {}};
  for (const Number& slot : use.slots) made.values.push_back(slot.constant);
  return made;
}

}  // namespace flyrock
