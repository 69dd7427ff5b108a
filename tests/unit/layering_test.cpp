// The floors of docs/architecture.md, read from the include lines: a floor includes itself and floors below
// it.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>

namespace {

const std::map<std::string, std::set<std::string>>& may_see() {
  static const std::map<std::string, std::set<std::string>> floors = [] {
    std::map<std::string, std::set<std::string>> sees{{"math", {}}, {"random", {}}, {"units", {}}};
    const auto add = [&](const std::string& floor, std::initializer_list<std::string> below) {
      for (const std::string& b : below) {
        sees[floor].insert(b);
        sees[floor].insert(sees[b].begin(), sees[b].end());
      }
    };
    add("geometry", {"math", "random", "units"});
    add("blast", {"math", "random", "units"});
    add("plugin", {"geometry", "blast"});
    add("collision", {"plugin"});
    add("solver", {"plugin"});
    add("record", {"math"});
    add("elastic", {"geometry"});
    add("world", {"collision", "solver", "elastic", "record"});
    add("flight", {"world"});
    add("document", {"units"});
    add("survey", {"plugin", "document"});
    add("scenario", {"survey", "record"});
    sees["sandbox"] = {};
    add("host", {"plugin", "document", "sandbox"});
    add("trial", {"flight", "scenario"});
    sees["files"] = {};
    add("load", {"trial", "host", "files"});
    add("batch", {"load"});
    add("results", {"batch"});
    add("report", {"results"});
    add("verify", {"results"});
    add("describe", {"scenario"});
    add("cli", {"report", "verify", "describe"});
    add("plugins", {"survey"});
    return sees;
  }();
  return floors;
}

}  // namespace

TEST_CASE("every floor includes only itself and the floors below it") {
  namespace fs = std::filesystem;
  const fs::path root = FLYROCK_SOURCE_DIR;
  const std::regex include("^\\s*#include \"([a-z_]+)/");
  int files = 0;
  for (const fs::path& tree : {root / "engine", root / "lua", root / "plugins"}) {
    for (const auto& entry : fs::recursive_directory_iterator(tree)) {
      const std::string extension = entry.path().extension();
      if (extension != ".h" && extension != ".cpp") continue;
      if (entry.path().parent_path() == tree) continue;  // the precompiled headers
      if (entry.path().string().find("/templates/") != std::string::npos)
        continue;  // of other people's plugins
      const std::string floor =
          tree.filename() == "plugins" ? "plugins" : entry.path().lexically_relative(tree).begin()->string();
      INFO("no floor: " << entry.path());
      REQUIRE(may_see().contains(floor));
      ++files;
      std::ifstream in(entry.path());
      for (std::string line; std::getline(in, line);) {
        std::smatch match;
        INFO(entry.path() << ": " << line);
        if (std::regex_search(line, match, include))
          CHECK((match[1] == floor || may_see().at(floor).contains(match[1])));
        if (floor != "host" && floor != "sandbox") CHECK(line.find("lua.h") == std::string::npos);
      }
    }
  }
  CHECK(files > 50);
}
