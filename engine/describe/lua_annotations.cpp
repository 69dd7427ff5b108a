#include "describe/lua_annotations.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "blast/blast.h"
#include "plugin/contact_law.h"
#include "scenario/schema.h"

namespace flyrock::cli {

namespace {

/// What does not follow from tables: the functions of the module, and the methods of what plugins are given.
constexpr const char* fixed_types = R"(---@meta flyrock
-- Types of flyrock for LuaLS, made by `flyrock schema --lua`.

---@alias flyrock.Number number|string|table a number in SI units, a quantity "2.7 g/cm3", a distribution or a sweep
---@alias flyrock.Vector number[]

---@class flyrock.Rng
local rng = {}
---A number from `low` to `high`, from 0 to 1 without them.
---@param low? number
---@param high? number
---@return number
function rng:uniform(low, high) end
---A number of the standard normal distribution.
---@return number
function rng:normal() end
---A whole number from `low` to `high`.
---@param low integer
---@param high integer
---@return integer
function rng:integer(low, high) end

---@class flyrock.Rock
---@field dimension integer
---@field mass number
---@field volume number
---@field density number
---@field diameter number
---@field position flyrock.Vector
---@field outward flyrock.Vector
---@field face_angle number
---@field group string
local rock = {}
---A velocity. Angles in rad: `elevation` above the outward horizontal, `azimuth` from it.
---@param speed number
---@param elevation number
---@param azimuth? number
---@return flyrock.Vector
function rock:direction(speed, elevation, azimuth) end

---@class flyrock.Terrain
---@field dimension integer
---@field x_min number
---@field x_max number
---@field y_min number
---@field y_max number
---@field points flyrock.Vector[]
---@field faces table[]
local terrain = {}
---@param x number
---@param y? number
---@return number
function terrain:height(x, y) end
---@param x number
---@param y? number
---@return flyrock.Vector
function terrain:normal(x, y) end

---@class flyrock.Launch
---@field velocity flyrock.Vector m/s
---@field spin? number|flyrock.Vector rad/s; in 3D a vector
---@field note? string a warning for the run
---@field greatest_throw? number m, of a model that was fitted to distances

---@class flyrock.Manifest
---@field kind flyrock.Kind
---@field name string
---@field doc string
---@field source? string
---@field validity? string
---@field dimension? 2|3
---@field form? "newton"|"newton_mean"|"poisson"|"energy"|"velocity"
---@field history? string[]
---@field history_of? "pair"|"contact"
---@field reads? string[]
---@field may_gain? boolean
---@field params? table<string, flyrock.Parameter>
---@field native? string
---@field impact? fun(p: table, contact: flyrock.Contact): number, number?
---@field friction? fun(p: table, contact: flyrock.Contact): number, number?, number?, number?
---@field rolling? fun(p: table, contact: flyrock.Contact): number, number?
---@field condition? fun(p: table, contact: flyrock.Contact): "signorini"|"quasi_shock"|"cohesive"|"penalty", number?, number?, number?, number?
---@field launch? fun(p: table, rock: flyrock.Rock, blast: flyrock.Blast, rng: flyrock.Rng, terrain: flyrock.Terrain): flyrock.Launch
---@field rocks? fun(p: table, terrain: flyrock.Terrain, blast: flyrock.Blast, rng: flyrock.Rng): table[]
---@field build? fun(p: table, rng: flyrock.Rng, dimension: integer): table

---@class flyrock.Parameter
---@field doc string
---@field default? any
---@field unit? string
---@field optional? boolean
---@field needed_in? integer 2 or 3: the dimension that needs an `optional` one
---@field min? number|string|number[] of `points` a list with a number for each component
---@field max? number|string|number[]
---@field above? number|string|number[]
---@field below? number|string|number[]
---@field usual? number[]
---@field choices? string[]
---@field fields? table<string, flyrock.Parameter> of `records`
---@field words? string[] of `records`: in place of them
---@field single? boolean of `records`: one map
---@field file? boolean of `records`: or the name of a file

---@class flyrock.module
local fr = {}
---@param scenario flyrock.Scenario
---@return table
function fr.scenario(scenario) end
---@param manifest flyrock.Manifest
---@return table
function fr.plugin(manifest) end
---An argument of the command line, `--arg name=value`.
---@generic T: number|string
---@param name string
---@param default T
---@return T
function fr.argument(name, default) end
---A load that changes over time, sampled by 1 ms.
---@param load fun(time: number): number|number[]
---@return table
function fr.over_time(load) end
)";

std::string quoted_names(const std::vector<std::string>& names) {
  std::vector<std::string> quoted;
  for (const std::string& name : names) quoted.push_back("\"" + name + "\"");
  return fmt::format("{}", fmt::join(quoted, "|"));
}

/// `on` and `off` may also be true and false.
bool is_switch(const ParamSpec& spec) {
  return std::find(spec.choices.begin(), spec.choices.end(), "on") != spec.choices.end();
}

std::string type_of(const ParamSpec& spec) {
  switch (spec.type) {
    case ParamType::number:
    case ParamType::integer:
      return "flyrock.Number";
    case ParamType::spin:
      return "flyrock.Number|flyrock.Number[]";
    case ParamType::boolean:
      return "boolean";
    case ParamType::choice:
      return quoted_names(spec.choices) + (is_switch(spec) ? "|boolean" : "") + "|table";
    case ParamType::text:
    case ParamType::file:
      return "string|table";
    case ParamType::vector:
      return "flyrock.Number[]";
    case ParamType::points:
    case ParamType::plan_points:
      return "flyrock.Number[][]";
    case ParamType::shapes:
      return "flyrock.shape[]";
    case ParamType::records:
      return "table|table[]|string";
    case ParamType::law:
      return "number|string|table";
  }
  return "any";
}

/// A field of a class. A name that is no word of Lua stands in brackets.
std::string field(const std::string& name, bool optional, const std::string& type, const std::string& doc) {
  return fmt::format("---@field {}{} {} {}\n", name, optional ? "?" : "", type, doc);
}

std::string field_of(const ParamSpec& spec, bool optional) {
  const std::string unit = spec.unit.empty() ? "" : fmt::format(" [{}]", spec.unit_text());
  return field(spec.name, optional || !spec.required(), type_of(spec), spec.doc + unit);
}

/// "flyrock.rocks.release" of "rocks.release: x 3D": all forms of a section are one class.
std::string class_of(std::string_view section) {
  const std::size_t end = std::min(section.find(':'), section.find(" 3D"));
  const std::string stem(section.substr(0, end));
  return stem.empty() ? "flyrock.Scenario" : "flyrock." + stem;
}

/// The class of a part, where it has one: a plugin, or a section of its own.
std::string type_of_part(const std::string& owner, const std::string& part,
                         const std::set<std::string>& classes) {
  static const std::map<std::string, std::string> plugins = {{"shape", "flyrock.shape"},
                                                             {"launch", "flyrock.velocity"},
                                                             {"restitution", "flyrock.restitution"},
                                                             {"friction", "flyrock.friction"},
                                                             {"rolling", "flyrock.rolling"},
                                                             {"unilateral", "flyrock.unilateral"}};
  static const std::set<std::string> lists = {"pairs", "branches",  "rocks",    "bodies", "barriers",
                                              "gates", "clearance", "exposure", "expect", "zones",
                                              "faces", "species",   "such_that"};
  if (const auto found = plugins.find(part); found != plugins.end()) return found->second;
  if (part == "terrain") return "flyrock.terrain|flyrock.terrain_type";
  if (part == "materials" && owner == "flyrock.Scenario") return "table<string, flyrock.materials>";
  if (part == "type") return "string";
  const std::string own = owner == "flyrock.Scenario" ? "flyrock." + part : owner + "." + part;
  if (!classes.contains(own)) return "any";
  return own + (lists.contains(part) ? "[]"
                : part == "holes"    ? "|table[]"
                : part == "maps"     ? "|boolean"
                                     : "");
}

/// The sections: one class each, whose fields are those of all its forms. A key that not every form needs is
/// optional.
std::string sections_text() {
  std::set<std::string> classes;
  std::vector<std::string> order;
  for (const SectionSpec& section : section_specs())
    if (classes.insert(class_of(section.name)).second) order.push_back(class_of(section.name));
  std::string text;
  for (const std::string& name : order) {
    std::set<std::string> told;
    int forms = 0;
    for (const SectionSpec& section : section_specs()) forms += class_of(section.name) == name;
    // The name of a population or a terrain stands among the keys of its own.
    text += fmt::format("\n---@class {}{}\n", name, name == "flyrock.rocks" ? ": { [string]: any }" : "");
    for (const SectionSpec& section : section_specs()) {
      if (class_of(section.name) != name) continue;
      for (const ParamSpec& spec : section.keys)
        if (told.insert(spec.name).second) text += field_of(spec, forms > 1);
      for (const std::string& part : section.parts)
        if (told.insert(part).second) text += field(part, true, type_of_part(name, part, classes), "");
    }
  }
  return text;
}

/// A class for each plugin, and the alias of a kind.
std::string plugins_text(const Registry& registry) {
  std::string text;
  std::vector<std::string> kinds;
  for (int k = 0; k < plugin_kinds; ++k) {
    const auto kind = static_cast<PluginKind>(k);
    const std::string name(name_of(kind));
    kinds.push_back(name);
    const std::string alias = kind == PluginKind::terrain ? "flyrock.terrain_type" : "flyrock." + name;
    std::vector<std::string> all;
    for (const Plugin* plugin : registry.of_kind(kind)) {
      const std::string own = fmt::format("{}.{}", alias, plugin->spec.name);
      all.push_back(own);
      text += fmt::format("\n---{}\n---@class {}\n---@field type \"{}\"\n", plugin->spec.doc, own,
                          plugin->spec.name);
      std::string_view group;
      for (const ParamSpec& spec : plugin->spec.params) {
        if (spec.group().empty())
          text += field_of(spec, false);
        else if (spec.group() != group)
          text += field(std::string(spec.group()), true, "table", "");
        group = spec.group();
      }
    }
    text += fmt::format("\n---@alias {} {}|table\n", alias, fmt::join(all, "|"));
  }
  return text + fmt::format("\n---@alias flyrock.Kind {}\n", quoted_names(kinds));
}

std::string type_of(const ContactField& one) {
  if (one.text) return "string";
  if (one.vector) return "flyrock.Vector";
  if (one.flag) return "boolean";
  return one.doc.find("nil") == one.doc.npos ? "number" : "number|nil";
}

std::string doc_of(const ContactField& one) {
  return fmt::format(
      "{}{}{}", one.doc, one.unit.empty() ? "" : fmt::format(" [{}]", one.unit),
      one.only_if_read && one.table().empty() ? fmt::format("; if `reads` has \"{}\"", one.read_name()) : "");
}

/// What laws and launch models read.
std::string views_text() {
  std::string text =
      "\n---@class flyrock.Contact\n---@field history table<string, number> what the law remembers\n";
  std::map<std::string_view, std::string> tables;
  for (const ContactField& one : contact_fields()) {
    const std::string_view table = one.table();
    if (!table.empty() && !tables.contains(table))
      text += field(std::string(table), false, fmt::format("flyrock.contact.{}", table),
                    fmt::format("if `reads` has \"{}\"", one.read_name()));
    (table.empty() ? text : tables[table]) +=
        field(std::string(one.own_name()), false, type_of(one), doc_of(one));
  }
  for (const auto& [table, fields] : tables)
    text += fmt::format("\n---@class flyrock.contact.{}\n{}", table, fields);
  text += "\n---@class flyrock.Blast\n";
  for (const BlastFieldInfo& info : blast_fields())
    text += field(std::string(info.name), false, "number", fmt::format("{} [{}]", info.doc, info.unit));
  return text;
}

/// fr.number { ... } and its like, which describe parameters.
std::string makers_text() {
  std::string text;
  for (const char* kind : {"number", "integer", "boolean", "choice", "text", "vector", "points",
                           "plan_points", "file", "spin", "shapes", "group"})
    text += fmt::format(
        "---@param fields? flyrock.Parameter\n---@return flyrock.Parameter\nfunction fr.{}(fields) end\n",
        kind);
  return text;
}

}  // namespace

std::string lua_annotations(const Registry& registry) {
  return fixed_types + makers_text() + sections_text() + plugins_text(registry) + views_text() +
         "\nreturn fr\n";
}

}  // namespace flyrock::cli
