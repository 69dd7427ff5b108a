// The plugins that docs/writing-a-plugin.md shows are plugins.

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "host/session.h"
#include "plugin/conformance.h"
#include "temporary_file.h"

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

TEST_CASE("the guide has a row for each field of a contact") {
  const std::string page = read(FLYROCK_SOURCE_DIR "/docs/writing-a-plugin.md");
  for (const ContactField& field : contact_fields()) {
    INFO(field.name);
    CHECK(page.find("| `" + std::string(field.name) + "` | " + std::string(field.unit) + " | " +
                    std::string(field.doc) + " |\n") != std::string::npos);
  }
}

TEST_CASE("the plugins of the guide load and conform") {
  const auto blocks = lua_plugins(read(FLYROCK_SOURCE_DIR "/docs/writing-a-plugin.md"));
  REQUIRE(blocks.size() == 7);
  LuaSession session(FLYROCK_SHARE_DIR);
  for (const std::string& block : blocks) {
    const TemporaryFile file("guide.lua", block);
    Diagnostics diagnostics;
    session.load_plugin(file.path, "guide.lua", {}, diagnostics);
    CHECK(diagnostics.to_text() == "");
  }
  const std::pair<PluginKind, const char*> shown[] = {
      {PluginKind::restitution, "mass_law"}, {PluginKind::velocity, "scaled_burden"},
      {PluginKind::friction, "worn"},        {PluginKind::population, "loose_blocks"},
      {PluginKind::velocity, "down_slope"},  {PluginKind::friction, "wet_gully"},
      {PluginKind::terrain, "gully"},
  };
  for (const auto& [kind, name] : shown) {
    INFO(name);
    const Plugin* plugin = session.registry().find(kind, name);
    REQUIRE(plugin);
    CHECK(conformance(*plugin).faults == std::vector<std::string>{});
  }
}
