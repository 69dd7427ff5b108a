#include "cli/given_parameters.h"

#include <fmt/format.h>

#include <set>

#include "cli/command.h"
#include "cli/terminal.h"
#include "document/yaml_reader.h"
#include "scenario/decode_params.h"
#include "scenario/normalise_params.h"

namespace flyrock::cli {

namespace {

/// The settings as lines of YAML: "mu: 0.6".
std::string yaml_of(const std::vector<std::string>& settings) {
  std::string lines;
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos)
      throw UsageError(fmt::format("--set {}: expected PARAMETER=VALUE", setting));
    lines += setting.substr(0, equals) + ": " + setting.substr(equals + 1) + '\n';
  }
  return lines;
}

}  // namespace

std::optional<PluginUse> decode_use(const Registry& registry, const PluginSpec& spec,
                                    const std::vector<std::string>& settings) {
  Diagnostics diagnostics;
  std::optional<PluginUse> use;
  if (const auto value = read_yaml("type: " + spec.name + '\n' + yaml_of(settings), "--set", diagnostics)) {
    const std::set<std::string> no_sweep;
    DecodeContext context{registry, ".", diagnostics, no_sweep};
    const Value normalised = normalise_plugin(context, Node::root(*value), spec.kind, {});
    use = decode_plugin(context, Node::root(normalised), spec.kind);
  }
  tell("{}", diagnostics.to_text());
  if (diagnostics.has_errors()) return std::nullopt;
  return use;
}

std::optional<std::vector<ParamValue>> decode_given(const Registry& registry, const PluginSpec& spec,
                                                    const std::vector<std::string>& settings, int dimension) {
  if (settings.empty()) return std::vector<ParamValue>(spec.params.size());
  std::vector<ParamSpec> params = spec.params;
  for (ParamSpec& param : params) {
    param.optional = true;  // what is not given stays so
    param.default_number.reset();
    param.default_text.reset();
    param.default_vector.reset();
  }
  Diagnostics diagnostics;
  std::vector<ParamValue> given;
  if (const auto value = read_yaml(yaml_of(settings), "--set", diagnostics)) {
    const std::set<std::string> no_sweep;
    DecodeContext context{registry, ".", diagnostics, no_sweep};
    context.dimension = dimension;
    std::vector<std::string> names;
    for (const ParamSpec& param : params)
      names.emplace_back(param.group().empty() ? param.own_name() : param.group());
    Node::root(*value).refuse_unknown_keys(names, diagnostics);
    Value normalised;
    normalised.data = normalise_params(context, Node::root(*value), params, {});
    if (!diagnostics.has_errors()) given = decode_params(context, Node::root(normalised), params);
  }
  tell("{}", diagnostics.to_text());
  if (diagnostics.has_errors()) return std::nullopt;
  return given;
}

}  // namespace flyrock::cli
