#include "plugin/params.h"

#include <fmt/format.h>

#include <algorithm>

#include "plugin/dimension_error.h"
#include "plugin/registry.h"

namespace flyrock {

Params::Params(const PluginSpec& spec, const std::vector<ParamValue>& values, int dimension)
    : spec_(spec), values_(values), dimension_(dimension), read_(spec.params.size(), false) {
  int next = 0;
  for (const ParamValue& value : values_) {
    slots_.push_back(value.numbers.empty() ? -1 : next);
    next += static_cast<int>(value.numbers.size());
  }
  slots_.resize(spec.params.size(), -1);  // those after the last value were left out
}

int Params::at(std::string_view name, std::initializer_list<ParamType> types) {
  const int i = spec_.find(name);
  if (i < 0)
    throw PluginError(fmt::format("plugin {}: reads the parameter `{}`, which its manifest does not declare",
                                  spec_.name, name));
  if (std::find(types.begin(), types.end(), spec_.params[i].type) == types.end())
    throw PluginError(fmt::format("plugin {}: reads `{}` as a {}, its manifest declares a {}", spec_.name,
                                  name, name_of(*types.begin()), name_of(spec_.params[i].type)));
  read_[i] = true;
  return i;
}

void Params::require_dimension(int dimension) const {
  if (dimension_ != dimension)
    throw DimensionError(
        fmt::format("plugin {}: the {} `{}` is of dimension {}, the scenario has dimension {}", spec_.name,
                    name_of(spec_.kind), spec_.name, dimension, dimension_));
}

bool Params::given(std::string_view name) const {
  const int i = spec_.find(name);
  return i >= 0 && values_[i].given;
}

int Params::slot(std::string_view name) {
  return slots_[at(name, {ParamType::number, ParamType::integer, ParamType::boolean, ParamType::spin})];
}

int Params::vector_slot(std::string_view name) { return slots_[at(name, {ParamType::vector})]; }

double Params::constant(std::string_view name) {
  const int i = at(name, {ParamType::number, ParamType::integer, ParamType::boolean});
  const auto& numbers = values_[i].numbers;
  if (numbers.empty()) throw PluginError(fmt::format("plugin {}: `{}` was not given", spec_.name, name));
  if (!numbers[0].is_constant())
    throw PluginError(
        fmt::format("plugin {}: `{}` must be a constant, not a distribution", spec_.name, name));
  return numbers[0].constant;
}

std::string Params::text(std::string_view name) {
  return values_[at(name, {ParamType::choice, ParamType::text, ParamType::file, ParamType::records})].text;
}

const std::vector<std::vector<double>>& Params::points(std::string_view name) {
  return values_[at(name, {ParamType::points, ParamType::plan_points})].points;
}

const std::vector<ShapePart>& Params::shapes(std::string_view name, int& first_slot) {
  static const std::vector<ShapePart> none;
  const int i = at(name, {ParamType::shapes});
  first_slot = slots_[i];
  return values_[i].parts ? *values_[i].parts : none;
}

std::vector<ParamRecord> Params::records(std::string_view name) {
  const int i = at(name, {ParamType::records});
  std::vector<ParamRecord> list;
  int slot = slots_[i];
  for (const std::vector<ParamValue>& record : values_[i].records) {
    list.emplace_back(spec_.params[i].fields, record, slot);
    for (const ParamValue& value : record) slot += static_cast<int>(value.numbers.size());
  }
  return list;
}

std::shared_ptr<const Distribution> Params::law(std::string_view name) {
  return values_[at(name, {ParamType::law})].law;
}

std::vector<Vec2> Params::points2(std::string_view name) {
  std::vector<Vec2> list;
  for (const auto& point : points(name)) list.emplace_back(point[0], point[1]);
  return list;
}

std::vector<Vec3> Params::points3(std::string_view name) {
  std::vector<Vec3> list;
  for (const auto& point : points(name)) list.emplace_back(point[0], point[1], point[2]);
  return list;
}

std::vector<std::string> Params::unread() const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < read_.size(); ++i)
    if (!read_[i]) names.push_back(spec_.params[i].name);
  return names;
}

ParamRecord::ParamRecord(const std::vector<ParamSpec>& fields, const std::vector<ParamValue>& values,
                         int first_slot)
    : fields_(fields), values_(values), first_slot_(first_slot) {}

std::size_t ParamRecord::at(std::string_view field, std::initializer_list<ParamType> types) const {
  const auto found =
      std::find_if(fields_.begin(), fields_.end(), [&](const ParamSpec& spec) { return spec.name == field; });
  if (found == fields_.end() || std::find(types.begin(), types.end(), found->type) == types.end())
    throw PluginError(
        fmt::format("reads the field `{}` of a record as a {}, which its manifest does not "
                    "declare",
                    field, name_of(*types.begin())));
  return static_cast<std::size_t>(found - fields_.begin());
}

bool ParamRecord::given(std::string_view field) const {
  for (std::size_t i = 0; i < fields_.size(); ++i)
    if (fields_[i].name == field) return values_[i].given;
  return false;
}

int ParamRecord::slot(std::string_view field) const {
  const std::size_t i =
      at(field, {ParamType::number, ParamType::integer, ParamType::boolean, ParamType::vector});
  if (values_[i].numbers.empty()) return -1;
  int slot = first_slot_;
  for (std::size_t before = 0; before < i; ++before) slot += static_cast<int>(values_[before].numbers.size());
  return slot;
}

const std::string& ParamRecord::text(std::string_view field) const {
  return values_[at(field, {ParamType::choice, ParamType::text, ParamType::file})].text;
}

const std::vector<std::vector<double>>& ParamRecord::points(std::string_view field) const {
  return values_[at(field, {ParamType::points, ParamType::plan_points})].points;
}

std::shared_ptr<const Distribution> ParamRecord::law(std::string_view field) const {
  return values_[at(field, {ParamType::law})].law;
}

bool holds(const FieldRead& read, const PluginSpec& spec, const std::vector<ParamValue>& values) {
  if (read.always()) return true;
  const std::string& chosen = values.at(static_cast<std::size_t>(spec.find(read.param))).text;
  return std::find(read.choices.begin(), read.choices.end(), chosen) != read.choices.end();
}

std::vector<Number> dense_slots(const std::vector<ParamValue>& values) {
  std::vector<Number> slots;
  for (const ParamValue& value : values)
    slots.insert(slots.end(), value.numbers.begin(), value.numbers.end());
  return slots;
}

}  // namespace flyrock
