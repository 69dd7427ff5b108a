// The plugins that docs/writing-a-plugin.md shows are plugins.

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "host/session.h"
#include "plugin/conformance.h"

using namespace flyrock;

namespace {

std::string read(const std::string& path) {
  std::ifstream file(path);
  REQUIRE(file);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The Lua blocks of a page that hold a whole plugin in Lua.
std::vector<std::string> lua_plugins(const std::string& page) {
  const std::string open = "```lua\n", close = "```";
  std::vector<std::string> blocks;
  for (auto at = page.find(open); at != page.npos; at = page.find(open, at)) {
    at += open.size();
    const std::string block = page.substr(at, page.find(close, at) - at);
    if (block.find("fr.plugin") != block.npos && block.find("native =") == block.npos)
      blocks.push_back(block);
  }
  return blocks;
}

}  // namespace

TEST_CASE("the plugins of the guide load and conform") {
  const auto blocks = lua_plugins(read(FLYROCK_SOURCE_DIR "/docs/writing-a-plugin.md"));
  REQUIRE(blocks.size() == 3);
  LuaSession session(FLYROCK_SHARE_DIR);
  const std::string path = (std::filesystem::temp_directory_path() / "flyrock_guide_plugin.lua").string();
  for (const std::string& block : blocks) {
    std::ofstream(path) << block;
    Diagnostics diagnostics;
    session.load_plugin(path, "guide.lua", {}, diagnostics);
    CHECK(diagnostics.to_text() == "");
  }
  std::filesystem::remove(path);
  const Plugin* law = session.registry().find(PluginKind::restitution, "mass_law");
  const Plugin* launch = session.registry().find(PluginKind::velocity, "scaled_burden");
  const Plugin* remembering = session.registry().find(PluginKind::friction, "worn");
  REQUIRE(law);
  REQUIRE(launch);
  REQUIRE(remembering);
  CHECK(conformance_faults(*law) == std::vector<std::string>{});
  CHECK(conformance_faults(*launch) == std::vector<std::string>{});
  CHECK(conformance_faults(*remembering) == std::vector<std::string>{});
}
