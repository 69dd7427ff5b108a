#include "host/manifest.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <tuple>

#include "blast/blast.h"
#include "document/value.h"
#include "host/param_reader.h"
#include "host/table_reader.h"
#include "plugin/contact_law.h"
#include "plugin/gain.h"

namespace flyrock {

namespace {

constexpr std::array<std::string_view, plugin_kinds> entry_points{
    "build", "rocks", "impact", "friction", "rolling", "condition", "launch", "build"};

std::vector<std::string> kind_names() {
  std::vector<std::string> names;
  for (int k = 0; k < plugin_kinds; ++k) names.emplace_back(name_of(static_cast<PluginKind>(k)));
  return names;
}

bool is_for_native_only(ParamType type) {
  return type == ParamType::shapes || type == ParamType::records || type == ParamType::law;
}

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
    else if (spec_.name.size() > most_letters)
      table_.error("name",
                   fmt::format("a name of {} letters, expected at most {}", spec_.name.size(), most_letters));
    spec_.doc = table_.required_text("doc");
    spec_.source = table_.text("source").value_or("");
    spec_.validity = table_.text("validity").value_or("");
    read_dimension();
    read_native();
    const auto form = table_.text("form");
    if (kind_known) {
      read_form(form);
      check_entry();
    }
    read_history();
    const bool may_gain = table_.boolean("may_gain").value_or(false);
    read_params();
    read_gain(may_gain);
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
                                     hint.empty() ? ", expected " + choice_text(kind_names()) : hint));
    return false;
  }

  void read_dimension() {
    const auto dimension = table_.number("dimension");
    if (!dimension) return;
    if (*dimension != 2 && *dimension != 3)
      return table_.error("dimension", shortest(*dimension) + ", expected 2 or 3, or nothing for both");
    spec_.dimension = static_cast<int>(*dimension);
  }

  /// Reads a file name in the folder of the manifest and never a path, because its code runs as soon as it is
  /// opened.
  void read_native() {
    const auto native = table_.text("native");
    if (native && !is_identifier(*native))
      table_.error(
          "native",
          fmt::format("`{}`, expected the name of a shared object beside the manifest: small letters, "
                      "digits and _, a letter first",
                      *native));
    spec_.native = native.value_or("");
  }

  void read_form(const std::optional<std::string>& form) {
    if (spec_.kind == PluginKind::restitution) {
      spec_.form = form.value_or("newton");
      if (!restitution_form(spec_.form))
        table_.error("form",
                     fmt::format("`{}`, expected `newton`, `newton_mean`, `poisson`, `energy` or `velocity`",
                                 spec_.form));
    } else if (form) {
      table_.error("form", fmt::format("a {} has no form: only a restitution has", name_of(spec_.kind)));
    }
  }

  /// A restitution that may not gain energy has a parameter that permits it.
  void read_gain(bool may_gain) {
    const bool is_restitution = spec_.kind == PluginKind::restitution;
    if (may_gain && !is_restitution)
      table_.error("may_gain",
                   fmt::format("a {} gains no energy: only a restitution may", name_of(spec_.kind)));
    if (!is_restitution || may_gain) return;
    if (spec_.find(allow_gain) >= 0)
      table_.error("params",
                   fmt::format("`{}` is a key of every restitution, expected another name", allow_gain));
    else
      add_allow_gain(spec_);
  }

  /// Requires either native or the function of the kind, and no other function.
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
    for (const ContactField& field : contact_fields())
      if (known.back() != field.read_name()) known.push_back(field.read_name());
    for (const std::string& text : *reads) {
      const FieldRead read = read_of(text);
      if (std::find(known.begin(), known.end(), read.field) == known.end()) {
        const std::string hint = did_you_mean(read.field, known);
        table_.error("reads", fmt::format("unknown field `{}`{}", read.field,
                                          hint.empty() ? ", expected one of " + choice_text(known) : hint));
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
      return table_.error(
          "reads", fmt::format("`{}` is not a parameter with choices, expected `FIELD if PARAM is CHOICE`",
                               read.param));
    const std::vector<std::string>& known = spec_.params[param].choices;
    for (const std::string& choice : read.choices)
      if (std::find(known.begin(), known.end(), choice) == known.end())
        table_.error("reads", fmt::format("`{}` is not a choice of `{}`, expected {}", choice, read.param,
                                          choice_text(known)));
    if (read.choices.empty())
      table_.error("reads",
                   fmt::format("`{}` without a choice, expected `FIELD if PARAM is CHOICE`", read.param));
  }

  /// Reads the memory of a law: its names, and whether each contact or each pair of bodies has its own.
  void read_history() {
    spec_.history = table_.texts("history").value_or(std::vector<std::string>{});
    const auto owner = table_.text("history_of");
    if (!spec_.history.empty() && !is_law(spec_.kind))
      table_.error("history",
                   fmt::format("a {} has no history: only laws of contacts have", name_of(spec_.kind)));
    if (spec_.history.size() > most_history)
      table_.error("history",
                   fmt::format("{} names, expected at most {}", spec_.history.size(), most_history));
    for (std::size_t i = 0; i < spec_.history.size(); ++i) {
      const std::string& name = spec_.history[i];
      if (!is_identifier(name))
        table_.error("history",
                     fmt::format("`{}`, expected small letters, digits and _, a letter first", name));
      if (std::find(spec_.history.begin(), spec_.history.begin() + i, name) != spec_.history.begin() + i)
        table_.error("history", fmt::format("`{}` twice", name));
    }
    if (!owner) return;
    if (spec_.history.empty())
      table_.error("history_of", "says whose history it is, and there is none: expected `history`");
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
    constexpr std::size_t most_params = 200;
    if (params->map()->size() > most_params)
      return table_.error(
          "params", fmt::format("{} parameters, expected at most {}", params->map()->size(), most_params));
    for (const Entry& entry : *params->map()) {
      auto params_of_entry = read_param(entry, diagnostics_);
      if (!params_of_entry) params_failed_ = true;
      for (ParamSpec& param : params_of_entry.value_or(std::vector<ParamSpec>()))
        spec_.params.push_back(std::move(param));
    }
    if (!params_failed_ && !check_bounds(*params->map(), spec_.params, diagnostics_)) params_failed_ = true;
    for (const ParamSpec& param : spec_.params)
      if (is_for_native_only(param.type) && spec_.native.empty())
        table_.error("params",
                     fmt::format("`{}` takes {}, which only a native plugin can read: expected "
                                 "`native`, or a parameter of another type",
                                 param.name, param.type == ParamType::law ? "a law" : name_of(param.type)));
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
