#include "host/param_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "document/value.h"
#include "host/table_reader.h"
#include "units/units.h"

namespace flyrock {

namespace {

class ParamReader {
 public:
  /// `path` of the table that has the entry: "params.", "params.ditch.params.".
  ParamReader(const Entry& entry, const std::string& path, Diagnostics& diagnostics)
      : name_(entry.key),
        path_(path + entry.key),
        table_(entry.value, path_, diagnostics),
        diagnostics_(diagnostics) {
    spec_.name = name_;
  }

  std::optional<ParamSpec> read() {
    if (!is_identifier(name_))
      table_.error("", "a parameter's name has small letters, digits and _, a letter first");
    else if (name_.size() > most_letters)
      table_.error("", fmt::format("a name of {} letters, expected at most {}", name_.size(), most_letters));
    if (!read_type()) return std::nullopt;
    spec_.doc = table_.text("doc").value_or("");
    spec_.optional = table_.boolean("optional").value_or(false);
    if (const auto needed_in = table_.number("needed_in")) {
      spec_.needed_in = *needed_in == 2 ? 2 : 3;
      if (!spec_.optional || (*needed_in != 2 && *needed_in != 3))
        table_.error("needed_in", "expected 2 or 3, the dimension that needs an `optional` parameter");
    }
    const bool spin = spec_.type == ParamType::spin;
    const bool numeric = spin || spec_.type == ParamType::number || spec_.type == ParamType::integer;
    if (spin || spec_.type == ParamType::number || spec_.type == ParamType::vector ||
        spec_.type == ParamType::law || spec_.type == ParamType::points ||
        spec_.type == ParamType::plan_points)
      read_unit();
    if (numeric || spec_.type == ParamType::vector || spec_.type == ParamType::law) {
      read_limits();
      read_usual();
    }
    if (spec_.type == ParamType::points || spec_.type == ParamType::plan_points) read_component_limits();
    if (spec_.type == ParamType::records) read_records();
    read_default();
    if (spec_.optional && table_.field("default"))
      table_.error("optional", "a parameter with a default is never left out: give one of the two");
    table_.finish();
    if (table_.failed()) return std::nullopt;
    return spec_;
  }

 private:
  bool read_type() {
    if (table_.failed()) return false;
    const auto name = table_.text("type");
    if (const auto type = name ? param_type(*name) : std::nullopt) {
      spec_.type = *type;
      return true;
    }
    table_.error(
        "",
        "expected a parameter: fr.number { ... }, fr.integer, fr.boolean, fr.choice, fr.text, fr.vector, "
        "fr.points, fr.plan_points, fr.file, fr.spin, fr.shapes, fr.records, fr.law or fr.group");
    return false;
  }

  void read_unit() {
    spec_.unit = table_.text("unit").value_or("");
    if (const std::size_t sign = spec_.unit.find('^');
        sign != std::string::npos && is_identifier(spec_.unit.substr(sign + 1))) {  // N/m^exponent
      spec_.unit_exponent = spec_.unit.substr(sign + 1);
      spec_.unit.erase(sign);
    }
    if (spec_.unit.empty()) return;
    std::string unknown;
    if (const auto unit = parse_unit(spec_.unit, &unknown)) {
      unit_ = *unit;
      spec_.dimension = unit->dimension;
    } else {
      table_.error("unit", fmt::format("unknown unit `{}`{}", unknown.empty() ? spec_.unit : unknown,
                                       did_you_mean(unknown, unit_names())));
    }
  }

  /// Converts in the same way as for a scenario, so that a default equals the same number in a scenario.
  double si(double written) const { return Quantity{written, true, unit_, spec_.unit}.si(); }
  std::optional<double> si(const std::optional<double>& written) const {
    if (!written) return std::nullopt;
    return si(*written);
  }

  /// A limit that is a number. A limit that names another parameter becomes a bound.
  std::optional<double> limit(BoundRelation relation) {
    const std::string key(key_of(relation));
    const Value* value = table_.field(key);
    const bool single = spec_.type == ParamType::number || spec_.type == ParamType::integer;
    if (!value || !single || value->number()) return si(table_.number(key));
    if (value->text())
      spec_.bounds.push_back({relation, *value->text()});
    else
      table_.error(key, value->kind() + ", expected a number, or the name of another parameter");
    return std::nullopt;
  }

  void read_limits() {
    spec_.min = limit(BoundRelation::at_least);
    spec_.max = limit(BoundRelation::at_most);
    spec_.above = limit(BoundRelation::above);
    spec_.below = limit(BoundRelation::below);
    if (spec_.min && spec_.above) table_.error("above", "expected one of `min` and `above`, not both");
    if (spec_.max && spec_.below) table_.error("below", "expected one of `max` and `below`, not both");
  }

  /// Limits of the components of points: lists with a number for each, `min = { 0, 0 }`.
  void read_component_limits() {
    const std::size_t most = spec_.type == ParamType::points ? 3 : 2;
    const auto read = [&](BoundRelation relation, std::optional<double> ParamSpec::*limit) {
      const std::string key(key_of(relation));
      const std::optional<std::vector<double>> limits = table_.numbers(key);
      if (!limits) return;
      if (limits->size() < 2 || limits->size() > most)
        return table_.error(key, fmt::format("has {} numbers, expected one for each component: {}",
                                             limits->size(), most == 2 ? "2" : "2 or 3"));
      spec_.fields.resize(std::max(spec_.fields.size(), limits->size()));
      for (std::size_t k = 0; k < limits->size(); ++k) spec_.fields[k].*limit = si((*limits)[k]);
    };
    read(BoundRelation::at_least, &ParamSpec::min);
    read(BoundRelation::at_most, &ParamSpec::max);
    read(BoundRelation::above, &ParamSpec::above);
    read(BoundRelation::below, &ParamSpec::below);
    for (std::size_t k = 0; k < spec_.fields.size(); ++k) {
      ParamSpec& component = spec_.fields[k];
      component.name = "xyz"[k];
      component.unit = spec_.unit;
      component.dimension = spec_.dimension;
    }
  }

  void read_usual() {
    const std::optional<std::vector<double>> ends = table_.numbers("usual");
    if (!ends) return;
    if (ends->size() == 2 && (*ends)[0] < (*ends)[1])
      spec_.usual = UsualRange{si((*ends)[0]), si((*ends)[1])};
    else
      table_.error("usual", "expected two numbers, the least and the greatest usual value");
  }

  void check_default(double value) {
    const double written = value / unit_.factor;
    const auto refuse = [&](const char* relation, double limit) {
      table_.error("default", fmt::format("{:.6g}, expected a number {} {:.6g}", written, relation,
                                          limit / unit_.factor));
    };
    if (spec_.type == ParamType::integer && value != std::floor(value))
      table_.error("default", fmt::format("{:.6g}, expected a whole number", written));
    if (spec_.min && value < *spec_.min) refuse("of at least", *spec_.min);
    if (spec_.max && value > *spec_.max) refuse("of at most", *spec_.max);
    if (spec_.above && value <= *spec_.above) refuse("above", *spec_.above);
    if (spec_.below && value >= *spec_.below) refuse("below", *spec_.below);
  }

  void read_default() {
    switch (spec_.type) {
      case ParamType::number:
      case ParamType::integer:
      case ParamType::spin:
        spec_.default_number = si(table_.number("default"));
        if (spec_.default_number) check_default(*spec_.default_number);
        break;
      case ParamType::boolean:
        if (const auto value = table_.boolean("default")) spec_.default_number = *value ? 1 : 0;
        break;
      case ParamType::choice:
        read_choices();
        break;
      case ParamType::text:
        spec_.default_text = table_.text("default");
        break;
      case ParamType::vector:
        spec_.default_vector = table_.numbers("default");
        if (spec_.default_vector) read_default_vector(*spec_.default_vector);
        break;
      case ParamType::points:
      case ParamType::plan_points:
      case ParamType::file:
      case ParamType::shapes:
      case ParamType::records:
      case ParamType::law:
        break;  // the scenario gives it or leaves it out
    }
  }

  void read_records() {
    spec_.choices = table_.texts("words").value_or(std::vector<std::string>{});
    spec_.single = table_.boolean("single").value_or(false);
    spec_.from_file = table_.boolean("file").value_or(false);
    const Value* fields = table_.field("fields");
    if (!fields || !fields->map() || fields->map()->empty())
      return table_.error("fields", "missing, expected a table of named parameters");
    for (const Entry& entry : *fields->map()) {
      const auto field = ParamReader(entry, path_ + ".fields.", diagnostics_).read();
      if (!field)
        table_.error("fields", fmt::format("`{}` is no parameter of a record", entry.key));
      else if (field->type == ParamType::records || field->type == ParamType::shapes)
        table_.error("fields", fmt::format("`{}` is a list of its own, expected a number, text, law, vector "
                                           "or points",
                                           entry.key));
      else
        spec_.fields.push_back(*field);
    }
  }

  void read_default_vector(std::vector<double>& components) {
    if (components.size() != 2 && components.size() != 3)
      return table_.error(
          "default",
          fmt::format("has {} components, expected 2 (a default in 2D) or 3 (in 3D)", components.size()));
    for (double& component : components) check_default(component = si(component));
  }

  void read_choices() {
    spec_.choices = table_.texts("choices").value_or(std::vector<std::string>{});
    spec_.default_text = table_.text("default");
    if (spec_.choices.empty())
      return table_.error("choices", "missing, expected a list of texts: choices = { \"a\", \"b\" }");
    if (spec_.default_text &&
        std::find(spec_.choices.begin(), spec_.choices.end(), *spec_.default_text) == spec_.choices.end())
      table_.error("default",
                   fmt::format("`{}`, expected {}", *spec_.default_text, choice_text(spec_.choices)));
  }

  std::string name_, path_;
  TableReader table_;
  Diagnostics& diagnostics_;
  ParamSpec spec_;
  Unit unit_;  // as declared
};

const Value& map_at(const Map& map, const std::string& key) {
  return std::find_if(map.begin(), map.end(), [&](const Entry& entry) { return entry.key == key; })->value;
}

/// Why a bound of `param` is wrong; empty if it is fine.
std::string bound_fault(const ParamSpec& param, const ParamBound& bound,
                        const std::vector<ParamSpec>& params) {
  std::vector<std::string> others;  // names that it may use
  for (const ParamSpec& one : params)
    if ((one.type == ParamType::number || one.type == ParamType::integer) && one.name != param.name)
      others.push_back(one.name);
  const auto other = std::find_if(params.begin(), params.end(),
                                  [&](const ParamSpec& one) { return one.name == bound.other; });
  if (std::find(others.begin(), others.end(), bound.other) == others.end())
    return fmt::format("`{}`, expected a number, or the name of another parameter that is a number{}",
                       bound.other, did_you_mean(bound.other, others));
  if (other->dimension != param.dimension)
    return fmt::format("`{}` has other units than `{}`", bound.other, param.name);
  if (param.default_number && other->default_number &&
      !keeps(*param.default_number, bound.relation, *other->default_number))
    return fmt::format("the default must be {} that of `{}`", name_of(bound.relation), bound.other);
  return {};
}

/// Why the exponent of a unit is none; empty if it is fine.
std::string exponent_fault(const ParamSpec& param, const std::vector<ParamSpec>& params) {
  if (param.unit_exponent.empty()) return {};
  const auto other = std::find_if(params.begin(), params.end(),
                                  [&](const ParamSpec& one) { return one.name == param.unit_exponent; });
  if (other != params.end() && other->type == ParamType::number && other->unit.empty() &&
      parse_unit(param.unit).value_or(Unit{}).factor == 1)
    return {};
  return fmt::format("`{}`, expected an SI unit, and as its exponent the name of a parameter without a unit",
                     param.unit_text());
}

}  // namespace

bool is_identifier(std::string_view name) {
  constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz", others = "0123456789_";
  return !name.empty() && letters.find(name[0]) != letters.npos &&
         std::all_of(name.begin(), name.end(), [&](char c) {
           return letters.find(c) != letters.npos || others.find(c) != others.npos;
         });
}

bool check_bounds(const Map& written, const std::vector<ParamSpec>& params, Diagnostics& diagnostics) {
  bool sound = true;
  const auto refuse = [&](const ParamSpec& param, const std::string& key, const std::string& fault) {
    const std::string own(param.own_name()), group(param.group());
    const Value* table = &map_at(written, group.empty() ? own : group);
    if (!group.empty()) table = table->find("params")->find(own);
    diagnostics.error(table->find(key)->at, fmt::format("params.{}.{}", param.name, key), fault);
    sound = false;
  };
  for (const ParamSpec& param : params) {
    if (const std::string fault = exponent_fault(param, params); !fault.empty()) refuse(param, "unit", fault);
    for (const ParamBound& bound : param.bounds)
      if (const std::string fault = bound_fault(param, bound, params); !fault.empty())
        refuse(param, std::string(key_of(bound.relation)), fault);
  }
  return sound;
}

namespace {

bool is_group(const Entry& entry) {
  const Value* type = entry.value.find("type");
  return type && type->text() && *type->text() == "group";
}

std::optional<std::vector<ParamSpec>> read_group(const Entry& entry, Diagnostics& diagnostics) {
  TableReader table(entry.value, "params." + entry.key, diagnostics);
  table.text("type");
  table.text("doc");
  const Value* params = table.field("params");
  if (!is_identifier(entry.key))
    table.error("", "a parameter's name has small letters, digits and _, a letter first");
  if (!params || !params->map()) table.error("params", "missing, expected a table of named parameters");
  table.finish();
  if (table.failed()) return std::nullopt;
  std::vector<ParamSpec> specs;
  bool sound = true;
  for (const Entry& inner : *params->map()) {
    auto spec = ParamReader(inner, "params." + entry.key + ".params.", diagnostics).read();
    sound = sound && spec;
    if (spec) spec->name = entry.key + "." + spec->name;
    if (spec) specs.push_back(std::move(*spec));
  }
  return sound ? std::optional(std::move(specs)) : std::nullopt;
}

}  // namespace

std::optional<std::vector<ParamSpec>> read_param(const Entry& entry, Diagnostics& diagnostics) {
  if (is_group(entry)) return read_group(entry, diagnostics);
  auto spec = ParamReader(entry, "params.", diagnostics).read();
  if (!spec) return std::nullopt;
  return std::vector<ParamSpec>{std::move(*spec)};
}

}  // namespace flyrock
