// flyrock schema: what editors know of scenarios.

#include <fmt/format.h>

#include "cli/command.h"
#include "describe/json_schema.h"
#include "describe/lua_annotations.h"
#include "host/session.h"
#include "host/share.h"

namespace flyrock::cli {

int schema(const Command& command, const Arguments& arguments) {
  boost::program_options::options_description options("options");
  options.add_options()("lua",
                        "annotations of LuaLS in place of the JSON Schema: scenarios and plugins in Lua");
  const CommandLine line = parse(command, options, arguments, 0, 0);
  if (line.help) return done;
  const LuaSession session(share_folder());
  if (line.has("lua"))
    fmt::print("{}", lua_annotations(session.registry()));
  else
    fmt::print("{}\n", scenario_schema(session.registry()).dump(1));
  return done;
}

}  // namespace flyrock::cli
