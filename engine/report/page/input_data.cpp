#include "report/page/input_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "report/page/scenario_text.h"
#include "scenario/schema.h"
#include "units/units.h"

namespace flyrock {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_listed = 6;  ///< elements of a list that is written in full

/// The keys of the document that change no number.
constexpr std::array<std::string_view, 9> left_out = {"flyrock", "title",  "document", "plugins", "expect",
                                                      "answer",  "output", "sweep",    "name"};

/// "[[0, 12 m], [5, 0]]", "{ uniform: [1 m, 2 m] }": a value in one line, long lists by their number.
std::string in_one_line(const Value& value) {
  std::string text;
  if (const List* list = value.list()) {
    if (list->size() > most_listed) return fmt::format("{} entries", list->size());
    for (const Value& item : *list) text += (text.empty() ? "" : ", ") + in_one_line(item);
    return "[" + text + "]";
  }
  if (const Map* map = value.map()) {
    for (const Entry& entry : *map)
      text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", entry.key, in_one_line(entry.value));
    return "{ " + text + " }";
  }
  if (const double* number = value.number()) return shortest(*number);
  if (const bool* flag = value.boolean()) return *flag ? "true" : "false";
  return value.text() ? *value.text() : "-";
}

/// Whether a value has only bare numbers, which are in SI units.
bool is_bare(const Value& value) {
  if (value.number()) return true;
  const List* list = value.list();
  return list && !list->empty() && std::all_of(list->begin(), list->end(), is_bare);
}

/// Whether a map is a value of its own, as a distribution is, and not a section.
bool is_value(const Map& map) {
  constexpr std::array<std::string_view, 18> first_words = {
      "uniform",     "normal",   "lognormal",     "triangular", "weibull", "beta",
      "exponential", "discrete", "rosin_rammler", "power_law",  "sieve",   "integer",
      "sweep",       "per",      "min",           "max",        "by",      "axis"};
  return !map.empty() &&
         std::find(first_words.begin(), first_words.end(), map.front().key) != first_words.end();
}

class InputList {
 public:
  explicit InputList(const LoadedScenario& scenario)
      : registry_(scenario.session->registry()),
        name_(scenario.name),
        dimension_(scenario.plan.points.front().dimension) {
    const Value resolved = in_degrees(scenario.plan.resolved);
    add_map(*resolved.map(), &scenario.root, {}, "", nullptr);
  }
  Json take() { return std::move(list_); }

 private:
  /// Where the walk is: the path as it is shown, and the name of its section in the schema.
  struct Place {
    std::string path, section;
    Place at(const std::string& key) const {
      return {path.empty() ? key : path + "." + key, section.empty() ? key : section + "." + key};
    }
  };

  /// `raw`: the same part of the document; null where it does not give it. `type`: the plugin of the section,
  /// and the group of its parameters that the map is.
  void add_map(const Map& map, const Value* raw, const Place& place, const std::string& group,
               const std::string* type) {
    for (const Entry& entry : map)
      if (entry.key == "type" && entry.value.text()) type = entry.value.text();
    for (const Entry& entry : map) {
      if (std::find(left_out.begin(), left_out.end(), entry.key) != left_out.end()) continue;
      const Value* given = raw ? raw->find(entry.key) : nullptr;
      const Place inner = place.at(entry.key);
      const std::string name = group.empty() ? entry.key : group + "." + entry.key;
      const Map* section = entry.value.map();
      if (section && !is_value(*section))
        add_map(*section, given, inner, has_group(type, name) ? name : "",
                has_group(type, name) ? type : nullptr);
      else if (is_list_of_maps(entry.value))
        add_elements(entry.value, given, inner);
      else
        add(entry.value, given, inner, unit_of(place.section, name, type),
            entry.key == "type" ? type : nullptr);
    }
  }

  void add_elements(const Value& value, const Value* raw, const Place& place) {
    const List& list = *value.list();
    const List* given = raw ? raw->list() : nullptr;
    if (list.size() > 4 * most_listed) return add(value, raw, place, "", nullptr);
    for (std::size_t i = 0; i < list.size(); ++i) {
      const Value* name = list[i].find("name");
      Place inner = place;
      inner.path += "." + (name && name->text() ? *name->text() : std::to_string(i));
      add_map(*list[i].map(), given && i < given->size() ? &(*given)[i] : nullptr, inner, "", nullptr);
    }
  }

  void add(const Value& value, const Value* given, const Place& place, const std::string& unit,
           const std::string* type) {
    const Value& shown = given ? *given : value;
    std::string text = in_one_line(shown);
    if (!unit.empty() && is_bare(shown)) text += " " + unit;
    Json from = given ? Json(where(given->at)) : Json(nullptr);
    list_.push_back({{"path", place.path}, {"value", std::move(text)}, {"from", std::move(from)}});
    if (const std::string source = type ? source_of(*type) : ""; !source.empty())
      list_.back()["source"] = source;
  }

  /// "line 12" of the scenario, whose file may be renamed without another result; else the name of the
  /// source.
  std::string where(const Location& at) const {
    if (!at.source || at.line == 0) return "given";
    const std::filesystem::path file(at.source->name);
    const std::string line = fmt::format("line {}", at.line);
    return file.stem().string() == name_ ? line : fmt::format("{}, {}", file.filename().string(), line);
  }

  static bool is_list_of_maps(const Value& value) {
    const List* list = value.list();
    return list && !list->empty() &&
           std::all_of(list->begin(), list->end(), [](const Value& item) { return item.map() != nullptr; });
  }

  template <class See>
  void each_plugin(const std::string& type, See see) const {
    for (const PluginKind kind :
         {PluginKind::shape, PluginKind::population, PluginKind::restitution, PluginKind::friction,
          PluginKind::rolling, PluginKind::unilateral, PluginKind::velocity, PluginKind::terrain})
      if (const Plugin* plugin = registry_.find(kind, type)) see(plugin->spec);
  }

  /// Whether a plugin has parameters `name`.x.
  bool has_group(const std::string* type, const std::string& name) const {
    bool has = false;
    if (type)
      each_plugin(*type, [&](const PluginSpec& spec) {
        for (const ParamSpec& param : spec.params) has |= param.group() == name;
      });
    return has;
  }

  /// The SI unit of a key: of the schema, or of the parameters of a plugin.
  std::string unit_of(const std::string& section, const std::string& name, const std::string* type) const {
    for (const SectionSpec& spec : section_specs()) {
      const std::string_view base = spec.name.substr(0, std::min(spec.name.find(" 3D"), spec.name.find(':')));
      const bool other_dimension = dimension_ == 2 && spec.name.ends_with(" 3D");
      if (base != section || other_dimension) continue;
      for (const ParamSpec& key : spec.keys)
        if (key.name == name && !key.unit.empty()) return unit_text(key);
    }
    std::string unit;
    if (type)
      each_plugin(*type, [&](const PluginSpec& spec) {
        if (const int at = spec.find(name); at >= 0 && unit.empty())
          unit = unit_text(spec.params[static_cast<std::size_t>(at)]);
      });
    return unit;
  }

  /// The unit of a bare number: the only bare angle is 0.
  static std::string unit_text(const ParamSpec& param) {
    if (param.unit.empty()) return "";
    if (!param.unit_exponent.empty()) return param.unit_text();
    if (const auto unit = parse_unit(param.unit); unit && unit->factor == 1 && param.unit != "rad")
      return param.unit;
    const std::string si = si_unit(param.dimension);
    return si == "rad" ? "deg" : si == "1" ? "" : si;
  }

  std::string source_of(const std::string& type) const {
    std::string source;
    each_plugin(type, [&](const PluginSpec& spec) { source = spec.source; });
    return source;
  }

  const Registry& registry_;
  std::string name_;
  int dimension_;
  Json list_ = Json::array();
};

}  // namespace

nlohmann::ordered_json input_data(const LoadedScenario& scenario) {
  const bool is_read =
      scenario.session && scenario.plan.resolved.map();  // a plan may be made without a document
  return is_read ? InputList(scenario).take() : Json::array();
}

}  // namespace flyrock
