#include <fmt/format.h>

#include "cli/command.h"
#include "cli/plugin_text.h"
#include "host/session.h"
#include "host/share.h"

namespace flyrock::cli {

namespace {

/// The plugins that "KIND" or "KIND/NAME" selects; all where the text is empty.
std::vector<const PluginSpec*> select(const Registry& registry, const std::string& wanted) {
  const std::size_t slash = wanted.find('/');
  const std::string kind_word = wanted.substr(0, slash);
  const std::optional<PluginKind> kind = plugin_kind(kind_word);
  if (!wanted.empty() && !kind) {
    std::vector<std::string> kinds;
    for (int k = 0; k < plugin_kinds; ++k) kinds.emplace_back(name_of(static_cast<PluginKind>(k)));
    const std::string near = nearest_name(kind_word, kinds);
    throw UsageError(fmt::format("unknown kind `{}`, expected one of: {}{}", kind_word, fmt::join(kinds, ", "),
                                 near.empty() ? "" : fmt::format("; did you mean `{}`?", near)));
  }
  std::vector<const PluginSpec*> specs;
  for (int k = 0; k < plugin_kinds; ++k)
    if (!kind || *kind == static_cast<PluginKind>(k))
      for (const Plugin* plugin : registry.of_kind(static_cast<PluginKind>(k))) specs.push_back(&plugin->spec);
  if (slash == std::string::npos) return specs;

  const std::string name = wanted.substr(slash + 1);
  if (const Plugin* plugin = registry.find(*kind, name)) return {&plugin->spec};
  const std::vector<std::string> names = registry.names(*kind);
  const std::string near = nearest_name(name, names);
  throw UsageError(fmt::format("unknown {} `{}`, expected one of: {}{}", kind_word, name, fmt::join(names, ", "),
                               near.empty() ? "" : fmt::format("; did you mean `{}`?", near)));
}

}  // namespace

int plugins(const Command& command, const Arguments& arguments) {
  boost::program_options::options_description options("options");
  options.add_options()("markdown", "pages for a reference")("json", "a list of objects");
  const CommandLine line = parse(command, options, arguments, 0, 1);
  if (line.help) return done;
  if (line.has("markdown") && line.has("json")) throw UsageError("expected one of --markdown and --json");
  const std::string wanted = line.words.empty() ? "" : line.words[0];
  const LuaSession session(share_folder());
  const std::vector<const PluginSpec*> specs = select(session.registry(), wanted);

  if (line.has("json")) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const PluginSpec* spec : specs) list.push_back(json_of(*spec));
    fmt::print("{}\n", list.dump(2));
    return done;
  }
  const bool single = wanted.find('/') != std::string::npos;
  for (const PluginSpec* spec : specs) {
    if (line.has("markdown") && spec != specs.front()) fmt::print("\n");
    fmt::print("{}", line.has("markdown") ? markdown(*spec) : single ? full_text(*spec) : short_text(*spec));
  }
  return done;
}

}  // namespace flyrock::cli
