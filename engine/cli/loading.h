#pragma once
// Loading of scenarios for the commands; errors go to stderr.

#include <boost/program_options.hpp>
#include <optional>
#include <string>

#include "cli/command.h"
#include "load/load.h"

namespace flyrock::cli {

/// --set, --seed, --trials and --arg.
void add_override_options(boost::program_options::options_description& options);
Overrides overrides_of(const CommandLine& line);

/// Prints every error and warning; nothing is returned if there are errors. With `strict`, keys that are not
/// read are errors. Where no file has the name, a shipped scenario is meant: quarry/permit.yaml or
/// quarry/permit. Not so where the overrides are confined.
std::optional<LoadedScenario> load(const std::string& path, const Overrides& overrides, bool strict);

}  // namespace flyrock::cli
