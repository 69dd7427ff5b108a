#include "cli/plugin_text.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/command.h"
#include "cli/shape_pictures.h"
#include "document/value.h"
#include "document/wording.h"
#include "host/share.h"
#include "units/units.h"

namespace flyrock::cli {

namespace {

using Json = nlohmann::ordered_json;

/// A value in SI units as the manifest would write it: "9.144 m/s", "90 deg".
std::string in_unit(double value, const ParamSpec& param) {
  if (param.unit.empty()) return shortest(value);
  const double factor = parse_unit(param.unit)->factor;
  const std::string number = factor == 1 ? shortest(value) : fmt::format("{:.12g}", value / factor);
  return number + " " + param.unit;
}

std::string default_text(const ParamSpec& param) {
  if (param.default_number) {
    if (param.type == ParamType::boolean) return *param.default_number != 0 ? "true" : "false";
    return in_unit(*param.default_number, param);
  }
  if (param.default_text) return *param.default_text;
  if (param.default_vector) {
    std::vector<std::string> numbers;
    for (double number : *param.default_vector) numbers.push_back(in_unit(number, param));
    return fmt::format("[{}]", fmt::join(numbers, ", "));
  }
  if (param.needed_in != 0) return fmt::format("required in {}D", param.needed_in);
  return param.optional ? "may be left out" : "required";
}

/// "at least 0, below 1", "linear | as_printed"; empty if everything is allowed.
std::string allowed_text(const ParamSpec& param) {
  std::vector<std::string> limits;
  if (param.min) limits.push_back("at least " + in_unit(*param.min, param));
  if (param.above) limits.push_back("above " + in_unit(*param.above, param));
  if (param.max) limits.push_back("at most " + in_unit(*param.max, param));
  if (param.below) limits.push_back("below " + in_unit(*param.below, param));
  for (const ParamBound& bound : param.bounds)
    limits.push_back(fmt::format("{} {}", name_of(bound.relation), bound.other));
  if (param.usual)
    limits.push_back(fmt::format("usually {} to {}", in_unit(param.usual->least, param),
                                 in_unit(param.usual->greatest, param)));
  if (!param.choices.empty()) limits.push_back(fmt::format("{}", fmt::join(param.choices, " | ")));
  return fmt::format("{}", fmt::join(limits, ", "));
}

/// "bond, slip, per contact"
std::string memory_text(const PluginSpec& spec) {
  return fmt::format("{}, per {}", fmt::join(spec.history, ", "),
                     spec.history_of_contact ? "contact" : "pair of bodies");
}

/// Wraps a text at words into lines of at most 80 columns.
std::string wrapped(const std::string& text, const std::string& indent) {
  constexpr std::size_t width = 80;
  std::string lines, line = indent;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (line.size() > indent.size() && line.size() + 1 + word.size() > width) {
      lines += line + '\n';
      line = indent;
    }
    line += (line.size() > indent.size() ? " " : "") + word;
  }
  return lines + line + '\n';
}

/// All parameters, with the fields of records as `sets[].dip` behind them.
std::vector<ParamSpec> with_fields(const std::vector<ParamSpec>& params) {
  std::vector<ParamSpec> all;
  for (const ParamSpec& param : params) {
    all.push_back(param);
    for (ParamSpec field : param.fields) {
      field.name = fmt::format("{}{}.{}", param.name, param.single ? "" : "[]", field.name);
      all.push_back(std::move(field));
    }
  }
  return all;
}

/// Escapes a text for a cell of a Markdown table.
std::string cell(const std::string& text) {
  std::string escaped;
  for (char c : text) escaped += c == '|' ? std::string("\\|") : std::string(1, c);
  return escaped;
}

Json default_json(const ParamSpec& param) {
  if (param.default_number) {
    if (param.type == ParamType::boolean) return *param.default_number != 0;
    return *param.default_number;
  }
  if (param.default_text) return *param.default_text;
  if (param.default_vector) return *param.default_vector;
  return nullptr;
}

}  // namespace

std::vector<const PluginSpec*> select_plugins(const Registry& registry, const std::string& wanted) {
  const std::size_t slash = wanted.find('/');
  const std::string kind_word = wanted.substr(0, slash);
  const std::optional<PluginKind> kind = plugin_kind(kind_word);
  if (!wanted.empty() && !kind) {
    std::vector<std::string> kinds;
    for (int k = 0; k < plugin_kinds; ++k) kinds.emplace_back(name_of(static_cast<PluginKind>(k)));
    throw UsageError(fmt::format("unknown kind `{}`{}", kind_word, suggestion(kind_word, kinds)));
  }
  std::vector<const PluginSpec*> specs;
  for (int k = 0; k < plugin_kinds; ++k)
    if (!kind || *kind == static_cast<PluginKind>(k))
      for (const Plugin* plugin : registry.of_kind(static_cast<PluginKind>(k)))
        specs.push_back(&plugin->spec);
  if (slash == std::string::npos) return specs;

  const std::string name = wanted.substr(slash + 1);
  if (const Plugin* plugin = registry.find(*kind, name)) return {&plugin->spec};
  throw UsageError(
      fmt::format("unknown {} `{}`{}", kind_word, name, suggestion(name, registry.names(*kind))));
}

std::string short_text(const PluginSpec& spec) {
  return fmt::format("{}/{}\n{}", name_of(spec.kind), spec.name, wrapped(spec.doc, "  "));
}

std::vector<std::string> texts_of(const std::vector<FieldRead>& reads) {
  std::vector<std::string> texts;
  for (const FieldRead& read : reads) texts.push_back(read.text());
  return texts;
}

std::string full_text(const PluginSpec& spec) {
  std::string text = short_text(spec);
  if (!spec.source.empty()) text += fmt::format("  source: {}\n", spec.source);
  if (!spec.validity.empty()) text += wrapped("valid: " + spec.validity, "  ");
  if (spec.dimension) text += fmt::format("  only in {}D\n", spec.dimension);
  if (!spec.form.empty()) text += fmt::format("  form: {}\n", spec.form);
  if (!spec.reads.empty()) text += fmt::format("  reads: {}\n", fmt::join(texts_of(spec.reads), ", "));
  if (!spec.history.empty()) text += fmt::format("  remembers: {}\n", memory_text(spec));
  text += fmt::format("  file: {}{}\n", spec.file, spec.native.empty() ? "" : " (native)");
  if (spec.params.empty()) text += "  no parameters\n";
  for (const ParamSpec& param : with_fields(spec.params)) {
    text += fmt::format(
        "\n  {}: {}{}, {}\n", param.name, name_of(param.type),
        param.unit.empty() ? "" : fmt::format(" [{}]", param.unit_text()),
        param.required() || param.optional ? default_text(param) : "default " + default_text(param));
    text += wrapped(param.doc, "    ");
    if (const std::string allowed = allowed_text(param); !allowed.empty())
      text += fmt::format("    {}\n", allowed);
  }
  return text;
}

std::string markdown(const PluginSpec& spec) {
  std::string text = fmt::format("## {}/{}\n\n{}\n", name_of(spec.kind), spec.name, spec.doc);
  if (spec.kind == PluginKind::shape && !example_of(spec, share_folder()).empty())
    text += fmt::format("\n![The rocks of its example](shapes/{}.svg)\n", spec.name);
  if (!spec.source.empty()) text += fmt::format("\nSource: {}\n", spec.source);
  if (!spec.validity.empty()) text += fmt::format("\nValid: {}\n", spec.validity);
  if (spec.dimension) text += fmt::format("\nOnly in {}D.\n", spec.dimension);
  if (!spec.form.empty()) text += fmt::format("\nForm: `{}`\n", spec.form);
  if (!spec.reads.empty()) text += fmt::format("\nReads: `{}`\n", fmt::join(texts_of(spec.reads), "`, `"));
  if (!spec.history.empty()) text += fmt::format("\nRemembers: {}\n", memory_text(spec));
  if (spec.params.empty()) return text + "\nNo parameters.\n";
  text += "\n| parameter | type | unit | default | allowed | |\n|---|---|---|---|---|---|\n";
  for (const ParamSpec& param : with_fields(spec.params))
    text += fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", param.name, name_of(param.type),
                        cell(param.unit_text()), cell(default_text(param)), cell(allowed_text(param)),
                        cell(param.doc));
  return text;
}

Json json_of(const PluginSpec& spec) {
  Json params = Json::array();
  for (const ParamSpec& param : with_fields(spec.params)) {
    Json entry = {{"name", param.name},           {"type", name_of(param.type)},
                  {"unit", param.unit_text()},    {"default", default_json(param)},
                  {"required", param.required()}, {"doc", param.doc}};
    if (param.min) entry["min"] = *param.min;
    if (param.max) entry["max"] = *param.max;
    if (param.above) entry["above"] = *param.above;
    if (param.below) entry["below"] = *param.below;
    if (param.usual) entry["usual"] = {param.usual->least, param.usual->greatest};
    for (const ParamBound& bound : param.bounds) entry[std::string(key_of(bound.relation))] = bound.other;
    if (!param.choices.empty()) entry["choices"] = param.choices;
    params.push_back(entry);
  }
  Json data = {{"kind", name_of(spec.kind)}, {"name", spec.name}, {"doc", spec.doc},
               {"source", spec.source},      {"file", spec.file}, {"native", !spec.native.empty()}};
  if (!spec.validity.empty()) data["validity"] = spec.validity;
  if (spec.dimension) data["dimension"] = spec.dimension;
  if (!spec.form.empty()) data["form"] = spec.form;
  data["reads"] = texts_of(spec.reads);
  data["params"] = params;
  return data;
}

}  // namespace flyrock::cli
