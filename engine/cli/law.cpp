// flyrock law: shows what a contact law does, as a picture and as a table.

#include <fmt/format.h>

#include <set>

#include "batch/safe_file.h"
#include "cli/command.h"
#include "cli/plugin_file.h"
#include "cli/plugin_text.h"
#include "document/yaml_reader.h"
#include "host/session.h"
#include "host/share.h"
#include "report/line_plot.h"
#include "results/law_graph.h"
#include "scenario/decode_params.h"
#include "scenario/normalise_params.h"

namespace flyrock::cli {

namespace {

/// The plugin with the parameters of --set, "name=value" with units as in a scenario. Prints faults.
std::optional<PluginUse> decode_use(const Registry& registry, const PluginSpec& spec,
                                    const std::vector<std::string>& settings) {
  std::string text = "type: " + spec.name + '\n';
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos)
      throw UsageError(fmt::format("--set {}: expected PARAMETER=VALUE", setting));
    text += setting.substr(0, equals) + ": " + setting.substr(equals + 1) + '\n';
  }
  Diagnostics diagnostics;
  std::optional<PluginUse> use;
  if (const auto value = read_yaml(text, "--set", diagnostics)) {
    const std::set<std::string> no_sweep;
    DecodeContext context{registry, ".", diagnostics, no_sweep};
    const Value normalised = normalise_plugin(context, Node::root(*value), spec.kind, {});
    use = decode_plugin(context, Node::root(normalised), spec.kind);
  }
  fmt::print(stderr, "{}", diagnostics.to_text());
  if (diagnostics.has_errors()) return std::nullopt;
  return use;
}

bool is_law(const Plugin* plugin) {
  const PluginKind kind = plugin->spec.kind;
  return kind == PluginKind::restitution || kind == PluginKind::friction || kind == PluginKind::rolling ||
         kind == PluginKind::unilateral;
}

/// KIND/NAME, or the law of a file. If the file has faults, prints them and returns null.
const PluginSpec* law_named(LuaSession& session, const std::string& word) {
  if (!names_plugin_file(word)) {
    if (word.find('/') == std::string::npos)
      throw UsageError(fmt::format("`{}`, expected KIND/NAME, as friction/coulomb, or a Lua file", word));
    return select_plugins(session.registry(), word).front();
  }
  auto plugins = load_plugin_file(session, word);
  if (!plugins) return nullptr;
  std::erase_if(*plugins, [](const Plugin* plugin) { return !is_law(plugin); });
  if (plugins->size() != 1)
    throw UsageError(fmt::format("{} registers {} contact laws, expected one", word,
                                 plugins->empty() ? "no" : fmt::format("{}", plugins->size())));
  return &plugins->front()->spec;
}

/// Prints every tenth part of each curve.
void print_table(const LawGraph& graph) {
  constexpr std::size_t rows = 10;
  fmt::print("\n{}\n", graph.title);
  for (const LawGraph::Case& curve : graph.cases) {
    fmt::print("  {:>36}  {}{}\n", graph.x, graph.y, curve.name.empty() ? "" : ", " + curve.name);
    for (std::size_t i = 0; i <= rows; ++i) {
      const std::size_t k = i * (curve.at.size() - 1) / rows;
      fmt::print("  {:>36.5g}  {:.5g}\n", curve.at[k], curve.value[k]);
    }
  }
}

}  // namespace

int law(const Command& command, const Arguments& arguments) {
  namespace po = boost::program_options;
  po::options_description options("options");
  options.add_options()("output,o", po::value<std::string>()->value_name("FILE"),
                        "writes the graphs there, as SVG")(
      "set", po::value<std::vector<std::string>>()->composing()->value_name("PARAMETER=VALUE"),
      "a parameter of the law");
  const CommandLine line = parse(command, options, arguments, 1, 1);
  if (line.help) return done;
  LuaSession session(share_folder());
  const PluginSpec* spec = law_named(session, line.words[0]);
  if (!spec) return bad_input;
  const auto settings =
      line.has("set") ? line.options["set"].as<std::vector<std::string>>() : std::vector<std::string>{};
  const std::optional<PluginUse> use = decode_use(session.registry(), *spec, settings);
  if (!use) return bad_input;
  std::vector<LawGraph> graphs;
  try {
    graphs = law_graphs(*use);
  } catch (const PluginError& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return bad_input;
  }
  fmt::print("{}", short_text(*spec));
  for (const LawGraph& graph : graphs) print_table(graph);
  if (!line.has("output")) return done;
  std::vector<Plot> plots;
  for (const LawGraph& graph : graphs) {
    plots.push_back({graph.title, graph.x, graph.y, {}});
    for (const LawGraph::Case& curve : graph.cases)
      plots.back().curves.push_back({curve.name, curve.at, curve.value});
  }
  write_file(line.text("output"), svg_of(line.words[0], plots));
  return done;
}

}  // namespace flyrock::cli
