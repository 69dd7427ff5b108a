#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/command.h"
#include "cli/plugin_file.h"
#include "cli/plugin_text.h"
#include "cli/shape_pairs.h"
#include "cli/shape_pictures.h"
#include "host/session.h"
#include "host/share.h"

namespace flyrock::cli {

int plugins(const Command& command, const Arguments& arguments) {
  boost::program_options::options_description options("options");
  options.add_options()("markdown", "pages for a reference")("json", "a list of objects")(
      "svg", "a picture of a shape: the rocks of its example");
  const CommandLine line = parse(command, options, arguments, 0, 1);
  if (line.help) return done;
  if (line.has("markdown") + line.has("json") + line.has("svg") > 1)
    throw UsageError("expected one of --markdown, --json and --svg");
  const std::string wanted = line.words.empty() ? "" : line.words[0];
  LuaSession session(share_folder());
  std::vector<const PluginSpec*> specs;
  if (names_plugin_file(wanted)) {
    const auto own = load_plugin_file(session, wanted);
    if (!own) return bad_input;
    for (const Plugin* plugin : *own) specs.push_back(&plugin->spec);
  } else {
    specs = select_plugins(session.registry(), wanted);
  }

  if (line.has("json")) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const PluginSpec* spec : specs) list.push_back(json_of(*spec));
    fmt::print("{}\n", list.dump(2));
    return done;
  }
  if (line.has("svg")) {
    const std::string folder = names_plugin_file(wanted) ? "" : share_folder();
    const bool is_shape = specs.size() == 1 && specs[0]->kind == PluginKind::shape;
    const std::string example = is_shape ? example_of(*specs[0], folder) : "";
    if (example.empty())
      throw UsageError("--svg draws one shape that has an example beside its manifest, as shape/box has");
    const std::optional<std::string> picture = picture_of(specs[0]->name, example);
    if (picture) fmt::print("{}", *picture);
    return picture ? done : bad_input;
  }
  const bool single = wanted.find('/') != std::string::npos || names_plugin_file(wanted);
  for (const PluginSpec* spec : specs) {
    if (line.has("markdown") && spec != specs.front()) fmt::print("\n");
    fmt::print("{}", line.has("markdown") ? markdown(*spec) : single ? full_text(*spec) : short_text(*spec));
  }
  if (line.has("markdown") && wanted == name_of(PluginKind::shape))
    fmt::print("\n{}", shape_pairs(specs, share_folder()));
  return done;
}

}  // namespace flyrock::cli
