// flyrock law: shows what a contact law does, as a picture and as a table.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "cli/command.h"
#include "cli/given_parameters.h"
#include "cli/plugin_file.h"
#include "cli/plugin_text.h"
#include "cli/run_program.h"
#include "cli/terminal.h"
#include "files/safe_file.h"
#include "host/session.h"
#include "host/share.h"
#include "report/pictures/line_plot.h"
#include "results/measured/law_graph.h"

namespace flyrock::cli {

namespace {

/// KIND/NAME, or the law of a file. If the file has faults, prints them and returns null.
const PluginSpec* law_named(LuaSession& session, const std::string& word) {
  if (!names_plugin_file(word)) {
    if (word.find('/') == std::string::npos)
      throw UsageError(fmt::format("`{}`, expected KIND/NAME, as friction/coulomb, or a Lua file", word));
    return select_plugins(session.registry(), word).front();
  }
  auto plugins = load_plugin_file(session, word);
  if (!plugins) return nullptr;
  std::erase_if(*plugins, [](const Plugin* plugin) { return !is_law(plugin->spec.kind); });
  if (plugins->size() != 1)
    throw UsageError(fmt::format("{} registers {} contact laws, expected one", word,
                                 plugins->empty() ? "no" : fmt::format("{}", plugins->size())));
  return &plugins->front()->spec;
}

/// The ball that --mass, --radius, --mu and --to describe.
LawBall ball_of(const CommandLine& line) {
  const auto quantity = [&](const char* option) {
    const std::string text = line.text(option);
    const std::optional<Quantity> read = parse_quantity(text);
    if (!read) throw UsageError(fmt::format("--{} {}: expected a number with a unit", option, text));
    return *read;
  };
  const auto positive = [&](const char* option, const Dimension& dimension) {
    const Quantity read = quantity(option);
    if (!(read.si() > 0) || (read.has_unit && read.unit.dimension != dimension))
      throw UsageError(fmt::format("--{} {}: expected a positive number in {}", option, line.text(option),
                                   si_unit(dimension)));
    return read.si();
  };
  LawBall ball;
  if (line.has("mass")) ball.mass = positive("mass", dimension::mass);
  if (line.has("radius")) ball.radius = positive("radius", dimension::length);
  if (line.has("mu")) ball.mu = positive("mu", dimension::none);
  if (line.has("to")) ball.to = quantity("to");
  return ball;
}

/// Writes a picture: an SVG, or by the name of the file a PNG, which the program rsvg-convert makes of it.
void write_picture(const std::string& file, const std::string& svg) {
  if (std::filesystem::path(file).extension() != ".png") {
    write_file(file, svg);
    return;
  }
  const std::string source = file + ".svg";
  write_file(source, svg);
  const bool made = run_program({"rsvg-convert", "--zoom", "2", "-o", file, source});
  std::filesystem::remove(source);
  if (!made)
    throw InputError(fmt::format(
        "{}: a PNG needs the program rsvg-convert (Debian: librsvg2-bin); an SVG does not", file));
}

/// Prints every tenth part of each curve, and all points of one with fewer. What rounding left of 0 is 0.
void print_table(const LawGraph& graph) {
  fmt::print("\n{}\n", graph.title);
  for (const LawGraph::Case& curve : graph.cases) {
    const auto rounded = [](const std::vector<double>& values, std::size_t k) {
      const auto [low, high] = std::minmax_element(values.begin(), values.end());
      return std::abs(values[k]) < 1e-12 * std::max(-*low, *high) ? 0 : values[k];
    };
    fmt::print("  {:>36}  {}{}\n", graph.x, graph.y, curve.name.empty() ? "" : ", " + curve.name);
    const std::size_t rows = std::min<std::size_t>(10, curve.at.size() - 1);
    for (std::size_t i = 0; i <= rows; ++i) {
      const std::size_t k = i * (curve.at.size() - 1) / rows;
      fmt::print("  {:>36.5g}  {:.5g}\n", rounded(curve.at, k), rounded(curve.value, k));
    }
  }
}

}  // namespace

int law(const Command& command, const Arguments& arguments) {
  namespace po = boost::program_options;
  po::options_description options("options");
  options.add_options()("output,o", po::value<std::string>()->value_name("FILE"),
                        "writes the graphs there, as SVG, or as PNG by the name")(
      "set", po::value<std::vector<std::string>>()->composing()->value_name("PARAMETER=VALUE"),
      "a parameter of the law");
  options.add_options()("mass", po::value<std::string>()->value_name("MASS"),
                        "mass of the ball for which the law is drawn; default 500 kg")(
      "radius", po::value<std::string>()->value_name("LENGTH"), "radius of the ball; default 0.3 m")(
      "mu", po::value<std::string>()->value_name("MU"),
      "coefficient of friction in the graphs of a restitution law; default 0.5")(
      "to", po::value<std::string>()->value_name("VALUE"),
      "end of the axis of the first graph: a speed, slip, spin or overlap; default depends on the law");
  const CommandLine line = parse(command, options, arguments, 1, 1);
  if (line.help) return done;
  LuaSession session(share_folder());
  const PluginSpec* spec = law_named(session, line.words[0]);
  if (!spec) return bad_input;
  const auto settings =
      line.has("set") ? line.options["set"].as<std::vector<std::string>>() : std::vector<std::string>{};
  const std::optional<PluginUse> use = decode_use(session.registry(), *spec, settings);
  if (!use) return bad_input;
  const LawBall ball = ball_of(line);
  std::vector<LawGraph> graphs;
  try {
    graphs = law_graphs(*use, ball);
  } catch (const PluginError& error) {
    tell("error: {}\n", error.what());
    return bad_input;
  }
  const std::string drawn = fmt::format("a ball of {:.6g} kg and {:.6g} m radius", ball.mass, ball.radius);
  fmt::print("{}  drawn for {}\n", short_text(*spec), drawn);
  for (const LawGraph& graph : graphs) print_table(graph);
  if (!line.has("output")) return done;
  std::vector<Plot> plots;
  for (const LawGraph& graph : graphs) {
    plots.push_back({graph.title, graph.x, graph.y, {}});
    for (const LawGraph::Case& curve : graph.cases)
      plots.back().curves.push_back({curve.name, curve.at, curve.value, plots.back().curves.size() % 2 == 1});
  }
  write_picture(line.text("output"), svg_of(fmt::format("{}, {}", line.words[0], drawn), plots));
  fmt::print("\n{}\n", line.text("output"));
  return done;
}

}  // namespace flyrock::cli
