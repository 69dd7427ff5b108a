// What the pages show works: each page is followed in a folder of its own, as a reader would.
//   - A block whose first line is a comment with nothing but a file name is written to that file.
//   - A block ```sh is run, and must end with exit code 0; its lines that start with `make` are left out.

#include <algorithm>
#include <catch2/catch.hpp>
#include <regex>

#include "program.h"

using namespace flyrock::test;

namespace {

struct Block {
  std::string language, text;
};

std::vector<Block> blocks_of(const std::string& page) {
  std::vector<Block> blocks;
  std::istringstream lines(page);
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```")) {
      inside = !inside;
      if (inside) blocks.push_back({line.substr(3), ""});
    } else if (inside) {
      blocks.back().text += line + '\n';
    }
  }
  return blocks;
}

/// The file that a block names: "-- laws/my_law.lua", "# my.yaml", "// damped.cpp"; else an empty text.
std::string file_of(const Block& block) {
  static const std::regex name("(?:--|#|//) ([a-z0-9_/]+\\.[a-z]+)\n");
  std::smatch match;
  const bool found = std::regex_search(block.text, match, name, std::regex_constants::match_continuous);
  return found ? match[1].str() : "";
}

/// A file that can be read as it stands, and is therefore to be named: the commands of its page use it.
bool is_whole(const Block& block) {
  if (block.language == "yaml") return block.text.find("flyrock: 1") != std::string::npos;
  return block.language == "lua" && block.text.find("return fr.") != std::string::npos;
}

std::string without_make(const std::string& commands) {
  std::istringstream lines(commands);
  std::string kept;
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with("make")) kept += line + '\n';
  return kept;
}

std::vector<fs::path> pages() {
  const fs::path source = FLYROCK_SOURCE_DIR;
  std::vector<fs::path> list = {source / "README.md", source / "CONTRIBUTING.md"};
  for (const auto& entry : fs::recursive_directory_iterator(source / "docs"))
    if (entry.path().extension() == ".md") list.push_back(entry.path());
  for (const auto& entry : fs::directory_iterator(source / "scenarios"))
    if (fs::exists(entry.path() / "README.md")) list.push_back(entry.path() / "README.md");
  std::sort(list.begin(), list.end());
  return list;
}

void follow(const fs::path& page) {
  const Folder folder;
  fs::copy(FLYROCK_SOURCE_DIR "/scenarios", folder.path() / "scenarios", fs::copy_options::recursive);
  const fs::path bin = fs::path(FLYROCK_BINARY).parent_path();
  const std::string setting = "set -eu\nPATH='" + bin.string() +
                              "':$PATH FLYROCK='" FLYROCK_SOURCE_DIR "' FLYROCK_BUILD='" +
                              bin.parent_path().string() + "'\n";
  for (const Block& block : blocks_of(read(page))) {
    INFO(page << ":\n" << block.text);
    const std::string file = file_of(block);
    if (is_whole(block)) CHECK_FALSE(file.empty());
    if (!file.empty()) {
      fs::create_directories((folder.path() / file).parent_path());
      folder.write(file, block.text);
    }
    if (block.language != "sh") continue;
    folder.write("commands.sh", setting + without_make(block.text));
    const std::string line = "cd '" + folder.path().string() + "' && sh commands.sh >output 2>&1 </dev/null";
    const int code = std::system(line.c_str());
    INFO(read(folder.path() / "output"));
    CHECK(code == 0);
  }
}

}  // namespace

TEST_CASE("The reference is what the manifests say: make reference") {
  const Folder folder;
  int kinds = 0;
  for (const auto& entry : fs::directory_iterator(FLYROCK_SOURCE_DIR "/docs/reference")) {
    const std::string kind = entry.path().stem().string();
    CHECK(call(folder, "plugins " + kind + " --markdown").out == read(entry.path()));
    ++kinds;
  }
  CHECK(kinds == 8);
}

TEST_CASE("The pages do what they say", "[slow]") {
  for (const fs::path& page : pages()) follow(page);
}
