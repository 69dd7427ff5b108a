#include "host/manifest.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "blast/blast.h"
#include "host/locate.h"
#include "host/table_reader.h"
#include "plugin/contact_law.h"

namespace flyrock {

namespace {

constexpr std::array<std::string_view, plugin_kinds> entry_points{
    "build", "rocks", "impact", "friction", "rolling", "condition", "launch", "build"};

std::vector<std::string> kind_names() {
  std::vector<std::string> names;
  for (int k = 0; k < plugin_kinds; ++k) names.emplace_back(name_of(static_cast<PluginKind>(k)));
  return names;
}

bool is_identifier(std::string_view name) {
  constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz", others = "0123456789_";
  return !name.empty() && letters.find(name[0]) != letters.npos &&
         std::all_of(name.begin(), name.end(), [&](char c) {
           return letters.find(c) != letters.npos || others.find(c) != others.npos;
         });
}

/// One fr.number { ... } or the like, under `params.NAME`.
class ParamReader {
 public:
  ParamReader(const Entry& entry, Diagnostics& diagnostics)
      : name_(entry.key), table_(entry.value, "params." + entry.key, diagnostics) {}

  std::optional<ParamSpec> read() {
    spec_.name = name_;
    if (!is_identifier(name_))
      table_.error("", "a parameter's name has small letters, digits and _, a letter first");
    if (!read_type()) return std::nullopt;
    spec_.doc = table_.text("doc").value_or("");
    spec_.optional = table_.boolean("optional").value_or(false);
    const bool spin = spec_.type == ParamType::spin;
    const bool numeric = spin || spec_.type == ParamType::number || spec_.type == ParamType::integer;
    if (spin || spec_.type == ParamType::number || spec_.type == ParamType::vector || spec_.type == ParamType::points)
      read_unit();
    if (numeric || spec_.type == ParamType::vector) read_limits();
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
    constexpr int types = 9;
    const auto type = table_.text("type");
    for (int i = 0; type && i < types; ++i)
      if (name_of(static_cast<ParamType>(i)) == *type) {
        spec_.type = static_cast<ParamType>(i);
        return true;
      }
    table_.error(
        "",
        "expected a parameter: fr.number { ... }, fr.integer, fr.boolean, fr.choice, fr.text, fr.vector, "
        "fr.points, fr.file or fr.spin");
    return false;
  }

  void read_unit() {
    spec_.unit = table_.text("unit").value_or("");
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

  /// As a scenario's numbers are converted, so that a default and the same number written there are equal.
  double si(double written) const { return Quantity{written, true, unit_, spec_.unit}.si(); }
  std::optional<double> si(const std::optional<double>& written) const {
    if (!written) return std::nullopt;
    return si(*written);
  }

  void read_limits() {
    spec_.min = si(table_.number("min"));
    spec_.max = si(table_.number("max"));
    spec_.above = si(table_.number("above"));
    spec_.below = si(table_.number("below"));
    if (spec_.min && spec_.above) table_.error("above", "expected one of `min` and `above`, not both");
    if (spec_.max && spec_.below) table_.error("below", "expected one of `max` and `below`, not both");
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
        if (spec_.default_vector)
          for (double& component : *spec_.default_vector) check_default(component = si(component));
        break;
      case ParamType::points:
      case ParamType::file:
        break;  // what a scenario gives or leaves out
    }
  }

  void read_choices() {
    spec_.choices = table_.texts("choices").value_or(std::vector<std::string>{});
    spec_.default_text = table_.text("default");
    if (spec_.choices.empty())
      return table_.error("choices", "missing, expected a list of texts: choices = { \"a\", \"b\" }");
    if (spec_.default_text &&
        std::find(spec_.choices.begin(), spec_.choices.end(), *spec_.default_text) == spec_.choices.end())
      table_.error("default", fmt::format("`{}`, expected {}", *spec_.default_text, one_of(spec_.choices)));
  }

  std::string name_;
  TableReader table_;
  ParamSpec spec_;
  Unit unit_;  // as declared
};

class ManifestReader {
 public:
  ManifestReader(const Value& table, const std::map<std::string, Location>& functions,
                 Diagnostics& diagnostics)
      : manifest_(table), table_(table, "", diagnostics), functions_(functions), diagnostics_(diagnostics) {}

  std::optional<PluginSpec> read() {
    const bool kind_known = read_kind();
    spec_.name = table_.required_text("name");
    if (!spec_.name.empty() && !is_identifier(spec_.name))
      table_.error("name",
                   fmt::format("`{}`, expected small letters, digits and _, a letter first", spec_.name));
    spec_.doc = table_.required_text("doc");
    spec_.source = table_.text("source").value_or("");
    spec_.validity = table_.text("validity").value_or("");
    spec_.native = table_.text("native").value_or("");
    const auto form = table_.text("form");
    if (kind_known) {
      read_form(form);
      check_entry();
    }
    read_history();
    read_params();
    read_reads();
    table_.finish();
    if (table_.failed() || params_failed_) return std::nullopt;
    return spec_;
  }

 private:
  bool read_kind() {
    const std::string kind = table_.required_text("kind");
    if (const auto known = plugin_kind(kind)) {
      spec_.kind = *known;
      return true;
    }
    if (kind.empty()) return false;
    const std::string hint = did_you_mean(kind, kind_names());
    table_.error("kind", fmt::format("unknown kind `{}`{}", kind,
                                     hint.empty() ? ", expected " + one_of(kind_names()) : hint));
    return false;
  }

  void read_form(const std::optional<std::string>& form) {
    if (spec_.kind == PluginKind::restitution) {
      spec_.form = form.value_or("newton");
      if (!restitution_form(spec_.form))
        table_.error("form", fmt::format("`{}`, expected `newton`, `newton_mean`, `poisson`, `energy` or `velocity`",
                                         spec_.form));
    } else if (form) {
      table_.error("form", fmt::format("a {} has no form: only a restitution has", name_of(spec_.kind)));
    }
  }

  /// Either native or the function of its kind, and no other function.
  void check_entry() {
    const std::string entry(entry_point(spec_.kind));
    const bool native = manifest_.find("native");
    for (const auto& [name, at] : functions_) {
      if (name != entry)
        table_.error(
            name, fmt::format("a {} has no function `{}`, expected `{}`", name_of(spec_.kind), name, entry),
            &at);
      else if (native)
        table_.error("native",
                     fmt::format("both `native` and the function `{}`, expected one of the two", entry));
    }
    if (const Value* other = table_.field(entry))
      table_.error(entry, other->kind() + ", expected a function");
    else if (!native && functions_.empty())
      table_.error(entry, fmt::format("missing: a {} needs the function `{}`, or `native`",
                                      name_of(spec_.kind), entry));
  }

  void read_reads() {
    const auto reads = table_.texts("reads");
    spec_.declares_reads = reads.has_value();
    if (!reads) return;
    std::vector<std::string> known;
    for (const BlastFieldInfo& field : blast_fields()) known.push_back(fmt::format("blast.{}", field.path));
    for (const ContactField& field : contact_fields()) known.push_back(fmt::format("contact.{}", field.name));
    for (const std::string& text : *reads) {
      const FieldRead read = read_of(text);
      if (std::find(known.begin(), known.end(), read.field) == known.end()) {
        const std::string hint = did_you_mean(read.field, known);
        table_.error("reads", fmt::format("unknown field `{}`{}", read.field,
                                          hint.empty() ? ", expected one of " + one_of(known) : hint));
      }
      if (!read.always()) check_condition(read);
      spec_.reads.push_back(read);
    }
  }

  /// "FIELD" or "FIELD if PARAM is CHOICE or CHOICE".
  static FieldRead read_of(const std::string& text) {
    const auto cut = [](const std::string& whole, std::string_view at) {
      const std::size_t place = whole.find(at);
      if (place == whole.npos) return std::pair(whole, std::string());
      return std::pair(whole.substr(0, place), whole.substr(place + at.size()));
    };
    FieldRead read;
    std::string condition, choices;
    std::tie(read.field, condition) = cut(text, " if ");
    std::tie(read.param, choices) = cut(condition, " is ");
    while (!choices.empty()) {
      std::string choice;
      std::tie(choice, choices) = cut(choices, " or ");
      read.choices.push_back(choice);
    }
    return read;
  }

  void check_condition(const FieldRead& read) {
    const int param = spec_.find(read.param);
    if (param < 0 || spec_.params[param].type != ParamType::choice)
      return table_.error("reads", fmt::format("`{}` is no parameter with choices, expected `FIELD if PARAM is CHOICE`", read.param));
    const std::vector<std::string>& known = spec_.params[param].choices;
    for (const std::string& choice : read.choices)
      if (std::find(known.begin(), known.end(), choice) == known.end())
        table_.error("reads", fmt::format("`{}` is no choice of `{}`, expected {}", choice, read.param, one_of(known)));
    if (read.choices.empty()) table_.error("reads", fmt::format("`{}` without a choice, expected `FIELD if PARAM is CHOICE`", read.param));
  }

  /// What a law remembers: names, and whether each contact or each pair of bodies has its own.
  void read_history() {
    spec_.history = table_.texts("history").value_or(std::vector<std::string>{});
    const auto owner = table_.text("history_of");
    const bool law = spec_.kind == PluginKind::restitution || spec_.kind == PluginKind::friction ||
                     spec_.kind == PluginKind::rolling || spec_.kind == PluginKind::unilateral;
    if (!spec_.history.empty() && !law)
      table_.error("history", fmt::format("a {} has no history: only laws of contacts have", name_of(spec_.kind)));
    if (spec_.history.size() > most_history)
      table_.error("history", fmt::format("{} names, expected at most {}", spec_.history.size(), most_history));
    for (std::size_t i = 0; i < spec_.history.size(); ++i) {
      const std::string& name = spec_.history[i];
      if (!is_identifier(name))
        table_.error("history", fmt::format("`{}`, expected small letters, digits and _, a letter first", name));
      if (std::find(spec_.history.begin(), spec_.history.begin() + i, name) != spec_.history.begin() + i)
        table_.error("history", fmt::format("`{}` twice", name));
    }
    if (!owner) return;
    if (spec_.history.empty()) table_.error("history_of", "says whose history it is, and there is none: expected `history`");
    if (*owner != "pair" && *owner != "contact")
      table_.error("history_of", fmt::format("`{}`, expected `pair` or `contact`", *owner));
    spec_.history_of_contact = *owner == "contact";
  }

  void read_params() {
    const Value* params = table_.field("params");
    if (!params) return;
    const bool empty = params->list() && params->list()->empty();
    if (!params->map() && !empty)
      return table_.error("params", params->kind() + ", expected a table of named parameters");
    if (empty) return;
    for (const Entry& entry : *params->map()) {
      auto param = ParamReader(entry, diagnostics_).read();
      if (param)
        spec_.params.push_back(std::move(*param));
      else
        params_failed_ = true;
    }
  }

  const Value& manifest_;
  TableReader table_;
  const std::map<std::string, Location>& functions_;
  Diagnostics& diagnostics_;
  PluginSpec spec_;
  bool params_failed_ = false;
};

}  // namespace

std::string_view entry_point(PluginKind kind) { return entry_points[static_cast<std::size_t>(kind)]; }

std::optional<PluginSpec> read_manifest(const Value& table, const std::map<std::string, Location>& functions,
                                        Diagnostics& diagnostics) {
  return ManifestReader(table, functions, diagnostics).read();
}

}  // namespace flyrock
