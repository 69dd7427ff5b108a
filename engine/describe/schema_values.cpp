#include "describe/schema_values.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "document/value.h"
#include "random/distribution.h"
#include "scenario/distribution_forms.h"
#include "scenario/schema.h"
#include "units/unit_table.h"

namespace flyrock::cli {

namespace {

using Json = SchemaValues::Json;

constexpr const char* number_pattern = "[+-]?((0|[1-9][0-9]*)(\\.[0-9]*)?|\\.[0-9]+)([eE][+-]?[0-9]+)?";

std::string escaped(std::string_view text) {
  std::string pattern;
  for (const char c : text) {
    if (std::string_view("\\.[]{}()*+?^$|/-").find(c) != std::string_view::npos) pattern += '\\';
    pattern += c;
  }
  return pattern;
}

/// A unit: one of this dimension, or several factors, whose dimension a pattern cannot say.
std::string unit_pattern(const ParamSpec& spec) {
  std::vector<std::string> names;
  for (const NamedUnit& unit : unit_table())
    if (unit.unit.dimension == spec.dimension || !spec.unit_exponent.empty())
      names.push_back(escaped(unit.name));
  names.emplace_back("[^0-9\\s][^\\s]*([0-9.*/^\\s\u00b2\u00b3\u00b7].*)");
  return fmt::format("({})", fmt::join(names, "|"));
}

/// A number with a unit. Readers of YAML 1.1 take a bare 1e-3 for a text too.
Json quantity_text(const ParamSpec& spec) {
  const bool is_angle = spec.dimension == dimension::angle;
  const std::string bare = is_angle ? "" : "|[+-]?[0-9.]+[eE][+-]?[0-9]+";
  return {{"type", "string"},
          {"pattern", fmt::format("^({}\\s*{}{})$", number_pattern, unit_pattern(spec), bare)}};
}

/// The limits of a bare number, which is in SI units.
void put_limits(Json& schema, const ParamSpec& spec) {
  if (spec.min) schema["minimum"] = *spec.min;
  if (spec.above) schema["exclusiveMinimum"] = *spec.above;
  if (spec.max) schema["maximum"] = *spec.max;
  if (spec.below) schema["exclusiveMaximum"] = *spec.below;
}

ParamSpec pure_number(const Dimension& dimension) {
  ParamSpec spec;
  spec.dimension = dimension;
  return spec;
}

/// A list of `count` of these.
Json tuple(Json item, std::size_t count) {
  return {{"type", "array"}, {"items", std::move(item)}, {"minItems", count}, {"maxItems", count}};
}

Json some(Json item) { return {{"type", "array"}, {"items", std::move(item)}, {"minItems", 1}}; }

std::string text_of_default(const ParamSpec& spec, double si) {
  const double factor = spec.unit.empty() ? 1 : parse_unit(spec.unit).value_or(Unit{}).factor;
  return fmt::format("{:.12g} {}", si / factor, spec.unit);
}

/// A default as the scenario would write it.
Json default_of(const ParamSpec& spec, int dimension) {
  const auto of_number = [&](double si) {
    return spec.unit.empty() ? Json(si) : Json(text_of_default(spec, si));
  };
  if (spec.default_text) return *spec.default_text;
  if (spec.default_vector) {
    if (static_cast<int>(spec.default_vector->size()) != dimension) return nullptr;
    Json list = Json::array();
    for (const double component : *spec.default_vector) list.push_back(of_number(component));
    return list;
  }
  if (!spec.default_number) return nullptr;
  if (spec.type == ParamType::boolean) return *spec.default_number != 0;
  if (spec.type == ParamType::integer) return static_cast<std::int64_t>(*spec.default_number);
  if (spec.type == ParamType::spin && dimension == 3)
    return Json(std::vector<Json>(3, of_number(*spec.default_number)));
  return of_number(*spec.default_number);
}

/// A choice of `off` and `on` also takes false and true, as Lua and YAML 1.1 have them.
Json choice(const ParamSpec& spec) {
  Json values = spec.choices;
  const auto has = [&](const char* text) {
    return std::find(spec.choices.begin(), spec.choices.end(), text) != spec.choices.end();
  };
  if (has("on")) values.push_back(true);
  if (has("off")) values.push_back(false);
  return {{"enum", std::move(values)}};
}

}  // namespace

Json SchemaValues::some_text() { return {{"type", "string"}, {"minLength", 1}}; }

Json SchemaValues::object(Json properties, Json required) {
  Json schema = {{"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}};
  if (!required.empty()) schema["required"] = std::move(required);
  return schema;
}

Json SchemaValues::reference(const std::string& name) { return {{"$ref", "#/definitions/" + name}}; }

Json SchemaValues::define(const std::string& name, Json schema) {
  std::string plain;
  for (const unsigned char c : name)
    if (std::isalnum(c))
      plain += static_cast<char>(c);
    else if (!plain.empty() && plain.back() != '_')
      plain += '_';
  std::string key = plain;
  for (int n = 2; definitions_.contains(key) && definitions_[key] != schema; ++n)
    key = fmt::format("{}_{}", plain, n);
  definitions_[key] = std::move(schema);
  return reference(key);
}

Json SchemaValues::constant(const ParamSpec& spec) {
  const bool is_angle = spec.dimension == dimension::angle;
  Json bare = {{"type", spec.type == ParamType::integer ? "integer" : "number"}};
  if (is_angle) bare["const"] = 0;  // other angles have a unit
  put_limits(bare, spec);
  const std::string name =
      fmt::format("{} {}", bare["type"].get<std::string>(),
                  spec.unit_exponent.empty() ? si_unit(spec.dimension) : spec.unit_text());
  return define(name, {{"anyOf", {std::move(bare), quantity_text(spec)}}});
}

Json SchemaValues::distribution(const ParamSpec& spec, const ValuePlace& place) {
  const ValuePlace of_number{.dimension = place.dimension, .varies = false, .may_sweep = place.may_sweep};
  ParamSpec drawn = pure_number(spec.dimension);
  if (!spec.unit_exponent.empty()) {
    drawn.unit = spec.unit;
    drawn.unit_exponent = spec.unit_exponent;
  }
  const Json with_unit = number(drawn, of_number), without = number(pure_number(dimension::none), of_number);
  Json properties = Json::object(), forms = Json::array();
  for (const DistributionForm& form : distribution_forms()) {
    Json& schema = properties[form.name];
    if (form.name == "discrete") {
      schema = {
          {"anyOf",
           {some(with_unit), object({{"values", some(with_unit)}, {"weights", some(without)}}, {"values"})}}};
    } else if (form.name == "sieve") {
      schema = object({{"size", some(with_unit)}, {"passing", some(without)}}, {"size", "passing"});
    } else if (form.is_list) {
      schema = tuple(with_unit, form.numbers.size());
    } else {
      Json numbers = Json::object(), names = Json::array();
      for (const DistributionNumber& one : form.numbers) {
        numbers[one.name] = one.has_dimension ? with_unit : without;
        names.push_back(one.name);
      }
      schema = object(std::move(numbers), std::move(names));
    }
    forms.push_back({{"required", {form.name}}});
  }
  properties["min"] = properties["max"] = with_unit;
  Json scopes = Json::array();
  for (const Scope scope : {Scope::run, Scope::trial, Scope::hole, Scope::rock, Scope::impact})
    scopes.push_back(name_of(scope));
  properties["per"] = {{"enum", std::move(scopes)}, {"description", "how often it is drawn"}};
  properties["by"] = {{"enum", {"count", "mass"}}, {"description", "what a distribution of sizes counts"}};
  Json schema = object(std::move(properties), {});
  schema["oneOf"] = std::move(forms);
  return define("distribution " + si_unit(spec.dimension), std::move(schema));
}

Json SchemaValues::or_sweep(Json value, const ValuePlace& place) {
  if (!place.may_sweep) return value;
  Json sweep = object({{"sweep", some(value)}}, {"sweep"});
  return {{"anyOf", {std::move(value), std::move(sweep)}}};
}

Json SchemaValues::number(const ParamSpec& spec, const ValuePlace& place) {
  Json forms = Json::array({constant(spec)});
  if (!spec.choices.empty()) forms.push_back({{"enum", spec.choices}});
  if (place.varies) forms.push_back(distribution(spec, place));
  if (place.may_sweep) {
    const Json end = constant(pure_number(spec.dimension));
    const Json steps = object(
        {{"from", end}, {"to", end}, {"count", {{"type", "integer"}, {"minimum", 2}, {"maximum", 10000}}}},
        {"from", "to", "count"});
    Json listed = forms[0];
    if (!spec.choices.empty()) listed = {{"anyOf", {forms[0], forms[1]}}};
    forms.push_back(define("sweep " + forms[0]["$ref"].get<std::string>().substr(14),
                           object({{"sweep", {{"anyOf", {some(std::move(listed)), steps}}}}}, {"sweep"})));
  }
  return {{"anyOf", std::move(forms)}};
}

/// A layer in place of points.
Json SchemaValues::layer() {
  Json properties = {{"where", {{"type", "object"}, {"description", "values of attributes"}}}};
  for (const ParamSpec& key : section_spec("layer").keys)
    properties[key.name] = {{"type", "string"}, {"description", key.doc}};
  return {{"type", "object"},
          {"properties", std::move(properties)},
          {"required", {"layer"}},
          {"additionalProperties", false}};
}

Json SchemaValues::points(const ParamSpec& spec, int coordinates, const ValuePlace& place) {
  ParamSpec coordinate = pure_number(spec.dimension);
  const Json number_schema =
      number(coordinate, {.dimension = place.dimension, .varies = false, .may_sweep = place.may_sweep});
  if (!spec.fields.empty()) {
    Json components = Json::array();
    for (std::size_t k = 0; k < static_cast<std::size_t>(coordinates); ++k)
      components.push_back(k < spec.fields.size() ? number(spec.fields[k], {.dimension = place.dimension,
                                                                            .varies = false,
                                                                            .may_sweep = place.may_sweep})
                                                  : number_schema);
    const Json point = {{"type", "array"},
                        {"items", std::move(components)},
                        {"minItems", coordinates},
                        {"maxItems", coordinates}};
    return {{"type", "array"}, {"items", point}};
  }
  return {{"type", "array"}, {"items", tuple(number_schema, static_cast<std::size_t>(coordinates))}};
}

Json SchemaValues::records(const ParamSpec& spec, const ValuePlace& place) {
  Json fields = Json::object(), required = Json::array();
  for (const ParamSpec& field : spec.fields) {
    fields[field.name] = parameter(field, place);
    if (field.required_in(place.dimension)) required.push_back(field.name);
  }
  const Json record = define(fmt::format("{} record {}D", spec.name, place.dimension),
                             object(std::move(fields), std::move(required)));
  Json forms = Json::array({some(record)});
  if (spec.single) forms.push_back(record);
  if (!spec.choices.empty()) forms.push_back({{"enum", spec.choices}});
  if (spec.from_file) forms.push_back(some_text());
  return {{"anyOf", std::move(forms)}};
}

Json SchemaValues::value(const ParamSpec& spec, const ValuePlace& place) {
  ParamSpec component = spec;
  component.type = ParamType::number;
  switch (spec.type) {
    case ParamType::spin:
      if (place.dimension == 2) return number(component, place);
      return tuple(number(component, place), 3);
    case ParamType::number:
    case ParamType::integer:
      return number(spec, place);
    case ParamType::boolean:
      return or_sweep({{"type", "boolean"}}, place);
    case ParamType::choice:
      return or_sweep(choice(spec), place);
    case ParamType::text:
      return or_sweep(spec.required() ? some_text() : Json{{"type", "string"}}, place);
    case ParamType::file:
      return or_sweep(some_text(), place);
    case ParamType::vector:
      return tuple(number(component, place), static_cast<std::size_t>(place.dimension));
    case ParamType::points:
      return points(spec, place.dimension, place);
    case ParamType::plan_points:
      return {{"anyOf", {points(spec, 2, place), layer()}}};
    case ParamType::shapes:
      return reference(fmt::format("parts_{}D", place.dimension));
    case ParamType::records:
      return records(spec, place);
    case ParamType::law:
      return {{"anyOf", {constant(component), distribution(component, place)}}};
  }
  return {};
}

Json SchemaValues::parameter(const ParamSpec& spec, const ValuePlace& place) {
  Json schema = {
      {"description", spec.unit.empty() ? spec.doc : fmt::format("{} [{}]", spec.doc, spec.unit_text())}};
  if (Json by_default = default_of(spec, place.dimension); !by_default.is_null())
    schema["default"] = std::move(by_default);
  schema.update(value(spec, place));
  return schema;
}

}  // namespace flyrock::cli
