// Types of the engine, read from its sources: a type is defined once. Two definitions of one name in one
// namespace break the rule of one definition without a word from the compiler.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// The types that a file defines for other files to see, as "namespace::Type".
std::vector<std::string> types_of(const fs::path& path) {
  static const std::regex space("^(?:inline )?namespace ?([\\w:]*) ?\\{"), end("^\\}  // namespace"),
      type("^(?:struct|class|enum class) (\\w+)(?: final)?(?: : [^;]*)? \\{");
  std::vector<std::string> spaces, types;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    std::smatch match;
    if (std::regex_search(line, match, space)) spaces.push_back(match[1]);
    if (std::regex_search(line, end) && !spaces.empty()) spaces.pop_back();
    const bool is_local = std::count(spaces.begin(), spaces.end(), "") > 0;
    if (is_local || !std::regex_search(line, match, type)) continue;
    std::string name;
    for (const std::string& each : spaces) name += each + "::";
    types.push_back(name + match[1].str());
  }
  return types;
}

}  // namespace

TEST_CASE("A type of the engine is defined in one file") {
  const fs::path root = FLYROCK_SOURCE_DIR;
  std::map<std::string, std::string> defined_in;
  for (const fs::path& tree : {root / "engine", root / "lua"})
    for (const auto& entry : fs::recursive_directory_iterator(tree)) {
      const std::string extension = entry.path().extension();
      if (extension != ".h" && extension != ".cpp") continue;
      for (const std::string& type : types_of(entry.path())) {
        const auto [first, is_new] = defined_in.emplace(type, entry.path());
        INFO(type << " in " << entry.path() << " and in " << first->second);
        CHECK(is_new);
      }
    }
  CHECK(defined_in.size() > 300);
}
