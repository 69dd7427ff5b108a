#include "plugin/spec.h"

#include <array>

namespace flyrock {

namespace {
constexpr std::array<std::string_view, plugin_kinds> kind_names{
    "shape", "population", "restitution", "friction", "rolling", "unilateral", "velocity", "terrain"};
constexpr std::array<std::string_view, 13> type_names{"number", "integer", "boolean",     "choice", "text",
                                                      "vector", "points",  "plan_points", "file",   "spin",
                                                      "shapes", "records", "law"};
constexpr std::array<std::string_view, 4> relation_names{"at least", "above", "at most", "below"};
constexpr std::array<std::string_view, 4> relation_keys{"min", "above", "max", "below"};
constexpr std::array<BoundRelation, 4> converses{BoundRelation::at_most, BoundRelation::below,
                                                 BoundRelation::at_least, BoundRelation::above};
}  // namespace

std::string_view name_of(PluginKind kind) { return kind_names[static_cast<std::size_t>(kind)]; }

std::optional<PluginKind> plugin_kind(std::string_view name) {
  for (int k = 0; k < plugin_kinds; ++k)
    if (kind_names[k] == name) return static_cast<PluginKind>(k);
  return std::nullopt;
}

bool is_law(PluginKind kind) {
  return kind == PluginKind::restitution || kind == PluginKind::friction || kind == PluginKind::rolling ||
         kind == PluginKind::unilateral;
}

std::string_view name_of(ParamType type) { return type_names[static_cast<std::size_t>(type)]; }

std::optional<ParamType> param_type(std::string_view name) {
  for (std::size_t i = 0; i < type_names.size(); ++i)
    if (type_names[i] == name) return static_cast<ParamType>(i);
  return std::nullopt;
}

std::string_view ParamSpec::group() const {
  const std::string_view whole = name;
  const std::size_t dot = whole.find('.');
  return dot == whole.npos ? std::string_view() : whole.substr(0, dot);
}

std::string_view ParamSpec::own_name() const {
  const std::string_view whole = name;
  return whole.substr(whole.find('.') + 1);  // npos + 1 = 0
}

std::string_view name_of(BoundRelation relation) {
  return relation_names[static_cast<std::size_t>(relation)];
}
std::string_view key_of(BoundRelation relation) { return relation_keys[static_cast<std::size_t>(relation)]; }
BoundRelation converse(BoundRelation relation) { return converses[static_cast<std::size_t>(relation)]; }

bool keeps(double value, BoundRelation relation, double other) {
  switch (relation) {
    case BoundRelation::at_least:
      return value >= other;
    case BoundRelation::above:
      return value > other;
    case BoundRelation::at_most:
      return value <= other;
    case BoundRelation::below:
      return value < other;
  }
  return true;
}

std::string FieldRead::text() const {
  if (always()) return field;
  std::string of;
  for (const std::string& choice : choices) of += (of.empty() ? "" : " or ") + choice;
  return field + " if " + param + " is " + of;
}

int PluginSpec::find(std::string_view param) const {
  for (std::size_t i = 0; i < params.size(); ++i)
    if (params[i].name == param) return static_cast<int>(i);
  return -1;
}

}  // namespace flyrock
