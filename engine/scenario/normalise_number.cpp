#include "scenario/normalise_number.h"

#include <fmt/format.h>

#include <cmath>

#include "plugin/gain.h"
#include "scenario/load_table.h"
#include "scenario/sweep.h"
#include "units/units.h"

namespace flyrock {

namespace {

bool is_reciprocal(const Dimension& a, const Dimension& b) {
  return a != dimension::none && a.metre == -b.metre && a.kilogram == -b.kilogram && a.second == -b.second &&
         a.radian == -b.radian;
}

/// How a unit does not fit: "the unit `s/m` is a reciprocal of the expected m/s" and the like.
std::string dimension_fault(const Quantity& quantity, const Dimension& expected) {
  const Dimension& found = quantity.unit.dimension;
  if (found == expected) return {};
  if (expected == dimension::none)
    return fmt::format("the unit `{}` does not belong here, expected a number without a unit",
                       quantity.unit_text);
  if (is_reciprocal(found, expected))
    return fmt::format("the unit `{}` is a reciprocal of the expected {}", quantity.unit_text,
                       si_unit(expected));
  const std::string dimension = si_unit(found);
  return fmt::format("the unit `{}`{} does not fit, expected a unit like {}", quantity.unit_text,
                     dimension == quantity.unit_text ? "" : " (" + dimension + ")", si_unit(expected));
}

std::string leading_zero_fault(std::string_view text) {
  const std::string sign(text.starts_with('-') ? 1 : 0, '-');
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  const std::string shown_text = sign + std::string(text);
  while (text.size() > 1 && text[0] == '0' && text[1] >= '0' && text[1] <= '9') text.remove_prefix(1);
  return fmt::format("`{}` has a leading zero, write {}{}", shown_text, sign, text);
}

bool has_leading_zero(const Value& value) {
  if (value.leading_zero) return true;
  std::string_view text = *value.text();
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  return text.size() > 1 && text[0] == '0' && text[1] >= '0' && text[1] <= '9';
}

std::string quantity_fault(const Value& value, const QuantityError& error, const Dimension& dimension,
                           const std::string& expected) {
  if (has_leading_zero(value)) return leading_zero_fault(*value.text());
  if (error.unit_text.empty()) return fmt::format("expected {}, found {}", expected, shown(value));
  const std::string hint = error.nearest.empty() ? ", expected a unit like " + si_unit(dimension)
                                                 : fmt::format(", did you mean `{}`?", error.nearest);
  return fmt::format("unknown unit `{}` in {}{}", error.unit_text, shown(value), hint);
}

/// The unit that messages about a parameter use: the declared one, or SI if none is declared.
std::string unit_of(const ParamSpec& spec) { return spec.unit.empty() ? si_unit(spec.dimension) : spec.unit; }

/// Why a number is not whole; empty if it is.
std::string whole_fault(const Value& value, double si) {
  if (si != std::floor(si)) return fmt::format("is {}, must be a whole number", shown(value));
  return digits_fault(value, si);
}

/// A number of the document whose last digits are lost (Value::rounded), also in a text.
bool is_rounded(const Value& value) {
  const std::string* text = value.text();
  return text ? parse_quantity(*text).value_or(Quantity{}).rounded : value.rounded;
}

std::string scope_choices(Scope finest) {
  std::vector<std::string> names;
  for (int s = 0; s <= static_cast<int>(finest); ++s) names.emplace_back(name_of(static_cast<Scope>(s)));
  return choice_text(names);
}

std::optional<Scope> scope_of(DecodeContext& context, const Node& node, const NumberRules& rules) {
  const std::optional<Node> per = node.find("per");
  if (!per) return rules.scope;
  const std::string* text = per->value->text();
  for (int s = 0; text && s <= static_cast<int>(rules.finest); ++s)
    if (*text == name_of(static_cast<Scope>(s))) return static_cast<Scope>(s);
  per->error(context.diagnostics,
             per->value->is_null()
                 ? "is empty, expected " + scope_choices(rules.finest)
                 : fmt::format("expected {}, found {}", scope_choices(rules.finest), shown(*per->value)));
  return std::nullopt;
}

/// "; did you mean `2.7 g/cm3`?" for a bare number that would be usual in another unit than SI.
std::string unit_hint(const Value& value, const Dimension& dimension, const UsualRange& usual) {
  static const std::vector<std::string> candidates{"g/cm3", "mm", "cm", "in", "ft", "km/s", "km/h", "kJ"};
  const double* number = value.number();
  if (!number) return {};
  for (const std::string& name : candidates) {
    const Unit unit = parse_unit(name).value();
    if (unit.dimension == dimension && usual.holds(*number * unit.factor))
      return fmt::format("; did you mean `{} {}`?", shortest(*number), name);
  }
  return {};
}

/// Warns if values from `low` to `high` are unusual.
void warn_of_unusual(DecodeContext& context, const Node& node, const ParamSpec& spec, double low,
                     double high) {
  if (!spec.usual || (spec.usual->holds(low) && spec.usual->holds(high))) return;
  const std::string found = low == high ? fmt::format("{} is unusual", with_unit(low, spec))
                                        : fmt::format("draws from {} to {} are unusual", with_unit(low, spec),
                                                      with_unit(high, spec));
  context.diagnostics.unusual(
      node.value->at, node.path,
      fmt::format("{}, expected {} to {}{}", found, with_unit(spec.usual->least, spec),
                  with_unit(spec.usual->greatest, spec),
                  unit_hint(*node.value, spec.dimension, *spec.usual)));
}

/// Replaces an entry of a normalised distribution, or adds it.
void set_entry(Map& map, std::string_view key, Value value) {
  for (Entry& entry : map)
    if (entry.key == key) {
      entry.value = std::move(value);
      return;
    }
  put(map, key, std::move(value));
}

/// Cuts off a tail beyond a limit of `spec`, if it is negligible: a lognormal diameter needs no `max`, only
/// because one tree in 10^30 would be thicker than the limit.
void cut_tails(Map& map, const ParamSpec& spec) {
  const Distribution distribution = read_distribution(map_value(map));
  if (!distribution.is_continuous()) return;
  const std::optional<double> least = spec.min ? spec.min : spec.above;
  const std::optional<double> greatest = spec.max ? spec.max : spec.below;
  if (least && distribution.lowest() < *least && distribution.share_below(*least) < Distribution::negligible)
    set_entry(map, "min", number_value(*least, spec.dimension));
  if (greatest && distribution.highest() > *greatest &&
      1 - distribution.share_below(*greatest) < Distribution::negligible)
    set_entry(map, "max", number_value(*greatest, spec.dimension));
}

/// Which value beside it permits a number beyond its limit; empty if none does.
std::string permit_text(const ParamSpec& spec, const NumberRules& rules, double high) {
  if (!rules.limits_gain || spec.max != 1.0 || spec.dimension != dimension::none || high <= 1) return {};
  return fmt::format("; more gains energy, which `{}: true` beside it permits", allow_gain);
}

Value normalise_draw(DecodeContext& context, const Node& node, const ParamSpec& spec,
                     const NumberRules& rules) {
  if (is_over_time(*node.value)) {
    node.error(context.diagnostics,
               fmt::format("takes no table over time, expected {}", expected_text(spec)));
    return {};
  }
  if (!rules.varies) {
    node.error(context.diagnostics, fmt::format("takes no distribution, expected {}", expected_text(spec)));
    return {};
  }
  std::optional<Map> map = normalise_distribution(context, node, spec, rules);
  const std::optional<Scope> scope = scope_of(context, node, rules);
  if (!map || !scope) return {};
  cut_tails(*map, spec);
  put(*map, "per", text_value(std::string(name_of(*scope))));
  Value normalised = map_value(std::move(*map));
  const Distribution distribution = read_distribution(normalised);
  const bool is_stepped = !distribution.is_continuous();
  if (spec.type == ParamType::integer && !is_stepped) {
    node.error(context.diagnostics, "takes whole numbers, expected `integer` or `discrete`");
    return {};
  }
  const double low = distribution.lowest(), high = distribution.highest();
  if (const std::string fault = limit_fault(spec, low, high, !is_stepped); !fault.empty()) {
    node.error(context.diagnostics,
               fmt::format("draws from {} to {}, {}: give it a `min` or `max`{}", with_unit(low, spec),
                           with_unit(high, spec), fault, permit_text(spec, rules, high)));
    return {};
  }
  constexpr double rare =
      1e-3;  // quantiles that count as the ends: one draw in a thousand may lie beyond each
  warn_of_unusual(context, node, spec, distribution.quantile(rare), distribution.quantile(1 - rare));
  return normalised;
}

}  // namespace

std::optional<double> quantity_of(DecodeContext& context, const Node& node, const Dimension& dimension,
                                  const NumberRules& rules, const std::string& expected) {
  const Value& value = *node.value;
  const bool is_swept = context.swept.contains(node.path);
  if (is_swept && !may_be_swept(node.path)) {
    // Reported at the key, because the value has another place at each sweep point.
    context.diagnostics.error(node.key_at, node.path, "takes no sweep, expected " + expected);
    return std::nullopt;
  }
  std::optional<double> si;
  if (const double* number = value.number()) {
    const bool is_bare_angle = dimension == dimension::angle && *number != 0 && !rules.bare_angles;
    if (!std::isfinite(*number))
      node.error(context.diagnostics, "is not a finite number");
    else if (is_bare_angle)
      node.error(context.diagnostics,
                 fmt::format("the angle {0} needs a unit: `{0} deg` or `{0} rad`?", shortest(*number)));
    else
      si = *number;
  } else if (const std::string* text = value.text()) {
    QuantityError error;
    const std::optional<Quantity> quantity = parse_quantity(*text, &error);
    if (!quantity || !quantity->has_unit)  // a bare number in quotes is text
      node.error(context.diagnostics, quantity_fault(value, error, dimension, expected));
    else if (const std::string fault = dimension_fault(*quantity, dimension); !fault.empty())
      node.error(context.diagnostics, fault);
    else
      si = quantity->si();
  } else {
    node.error(context.diagnostics, value.is_null()
                                        ? "is empty, expected " + expected
                                        : fmt::format("expected {}, found {}", expected, shown(value)));
  }
  if (si && is_swept) context.swept_values[node.path] = {*si, si_unit(dimension)};
  return si;
}

Value normalise_number(DecodeContext& context, const Node& node, const ParamSpec& spec,
                       const NumberRules& rules) {
  if (node.value->map()) return normalise_draw(context, node, spec, rules);
  const std::optional<double> si = quantity_of(context, node, spec.dimension, rules, expected_text(spec));
  if (!si) return {};
  std::string fault = limit_fault(spec, *si, *si);
  if (!fault.empty()) fault = fmt::format("is {}, {}", shown(*node.value), fault);
  if (spec.type == ParamType::integer && fault.empty()) fault = whole_fault(*node.value, *si);
  if (!fault.empty()) {
    node.error(context.diagnostics, fault + permit_text(spec, rules, *si));
    return {};
  }
  warn_of_unusual(context, node, spec, *si, *si);
  return number_value(*si, spec.dimension);
}

std::string digits_fault(const Value& value, double si) {
  if (!is_rounded(value) && std::abs(si) <= greatest_whole) return {};
  return fmt::format(
      "has more digits than flyrock keeps, it would be read as {}: expected a whole number of at most {}",
      shortest(si), shortest(greatest_whole));
}

double si_of(const Value& normalised) {
  if (const double* number = normalised.number()) return *number;
  const std::string* text = normalised.text();  // an angle
  return text ? parse_quantity(*text).value_or(Quantity{}).si() : 0;
}

namespace {

/// "a list of maps { dip, spacing, ... }, or a file"
std::string records_text(const ParamSpec& spec) {
  std::vector<std::string> fields;
  for (const ParamSpec& field : spec.fields)
    if (field.required() || spec.fields.size() <= 3) fields.push_back(field.name);
  if (fields.size() < spec.fields.size()) fields.emplace_back("...");
  std::string text =
      fmt::format("{} {{ {} }}", spec.single ? "a map" : "a list of maps", fmt::join(fields, ", "));
  if (spec.from_file) text += ", or a file";
  return spec.choices.empty() ? text : choice_text(spec.choices) + " or " + text;
}

}  // namespace

std::string expected_text(const ParamSpec& spec) {
  switch (spec.type) {
    case ParamType::number: {
      const std::string number =
          spec.dimension == dimension::none ? "a number" : "a number in " + unit_of(spec);
      return spec.choices.empty() ? number : number + " or " + choice_text(spec.choices);
    }
    case ParamType::integer:
      return "a whole number";
    case ParamType::boolean:
      return "`true` or `false`";
    case ParamType::choice:
      return choice_text(spec.choices);
    case ParamType::text:
      return "text";
    case ParamType::vector:
      return "a list of numbers in " + unit_of(spec);
    case ParamType::points:
      return "a list of points [x, y]";
    case ParamType::plan_points:
      return "a list of points [x, y] in plan";
    case ParamType::file:
      return "the name of a file";
    case ParamType::spin:
      return "a spin in rad/s: a number in 2D, three in 3D";
    case ParamType::shapes:
      return "a list of shapes { type, ..., at, turn }";
    case ParamType::records:
      return records_text(spec);
    case ParamType::law:
      return (spec.dimension == dimension::none ? "a number" : "a number in " + unit_of(spec)) +
             " or a distribution";
  }
  return {};
}

std::string with_unit(double si, const ParamSpec& spec) {
  if (spec.type == ParamType::integer) return shortest(si);
  if (spec.dimension == dimension::none) return fmt::format("{:.6g}", si);
  const std::string unit = unit_of(spec);
  return fmt::format("{:.6g} {}", si / parse_unit(unit).value_or(Unit{}).factor, unit);
}

std::string limit_fault(const ParamSpec& spec, double low, double high, bool is_open) {
  if (spec.min && low < *spec.min) return "must be at least " + with_unit(*spec.min, spec);
  if (spec.max && high > *spec.max) return "must be at most " + with_unit(*spec.max, spec);
  if (spec.above && (low < *spec.above || (low == *spec.above && !is_open)))
    return "must be above " + with_unit(*spec.above, spec);
  if (spec.below && (high > *spec.below || (high == *spec.below && !is_open)))
    return "must be below " + with_unit(*spec.below, spec);
  return {};
}

Value number_value(double si, const Dimension& dimension) {
  Value value;
  if (dimension == dimension::angle)
    value.data = shortest(si) + " rad";
  else
    value.data = si;
  return value;
}

Value text_value(std::string text) {
  Value value;
  value.data = std::move(text);
  return value;
}

Value list_value(List list) {
  Value value;
  value.data = std::move(list);
  return value;
}

Value map_value(Map map) {
  Value value;
  value.data = std::move(map);
  return value;
}

void put(Map& map, std::string_view key, Value value) {
  map.push_back({std::string(key), Location{}, std::move(value)});
}

void put(Map& map, const Node& from, Value value) {
  value.at = from.value->at;
  map.push_back({from.key, from.key_at, std::move(value)});
}

void put_all(Map& map, Map others) {
  for (Entry& entry : others) map.push_back(std::move(entry));
}

}  // namespace flyrock
