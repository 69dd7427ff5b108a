#include <iostream>

#include "cli/loading.h"

namespace flyrock::cli {

int show(const Command& command, const Arguments& arguments) {
  boost::program_options::options_description options("options");
  options.add_options()("json", "as JSON in place of YAML");
  add_override_options(options);
  const CommandLine line = parse(command, options, arguments, 1, 1);
  if (line.help) return done;
  const auto loaded = load(line.words[0], overrides_of(line), false);
  if (!loaded) return bad_input;
  std::string text = line.has("json") ? to_json(loaded->plan.resolved) : to_yaml(loaded->plan.resolved);
  if (text.empty() || text.back() != '\n') text += '\n';
  std::cout << text;
  return done;
}

}  // namespace flyrock::cli
