// What shells, manual pages and editors know of the program follows from its own tables.

#include <catch2/catch.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "cli/program.h"

namespace flyrock::shell_test {

using namespace flyrock::test;

bool has_program(const Folder& folder, const std::string& name) {
  return shell(folder, "command -v " + name).code == 0;
}

std::set<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::set<std::string> words;
  for (std::string word; std::getline(stream, word);) words.insert(word);
  return words;
}

std::vector<std::string> command_names(const Folder& folder) {
  const std::string help = call(folder, "--help").out;
  std::vector<std::string> names;
  static const std::regex line("\n  flyrock ([a-z]+)");
  for (auto found = std::sregex_iterator(help.begin(), help.end(), line); found != std::sregex_iterator();
       ++found)
    names.push_back((*found)[1]);
  return names;
}

/// What bash offers after these words; the last one is the one under way.
std::set<std::string> offered(const Folder& folder, const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += "'" + word + "' ";
  folder.write("offer.sh",
               "source ./completion\nCOMP_WORDS=(" + list +
                   ")\nCOMP_CWORD=" + std::to_string(words.size() - 1) +
                   "\n_flyrock 2>&1\n((${#COMPREPLY[@]})) && printf '%s\\n' \"${COMPREPLY[@]}\"\n:\n");
  const Output output = shell(folder, "bash --norc offer.sh");
  INFO(output.err);
  CHECK(output.code == 0);
  return words_of(output.out);
}

TEST_CASE("bash completes commands, options, files, plugins and labs") {
  const Folder folder;
  REQUIRE(call(folder, "completion bash > completion").code == 0);
  folder.write("slope.yaml", "");
  folder.write("slope.txt", "");
  fs::create_directories(folder.path() / "slopes");
  using Words = std::set<std::string>;
  CHECK(offered(folder, {"flyrock", "cal"}) == Words{"calibrate"});
  CHECK(offered(folder, {"flyrock", "run", "sl"}) == Words{"slope.yaml", "slopes/"});
  CHECK(offered(folder, {"flyrock", "run", "slope.yaml", "--st"}) == Words{"--strict"});
  CHECK(offered(folder, {"flyrock", "run", "slope.yaml", "-o", "sl"}) == Words{"slopes/"});
  CHECK(offered(folder, {"flyrock", "run", "slope.yaml", "--trials", ""}).empty());
  CHECK(offered(folder, {"flyrock", "export", "slopes", "--to", ""}) ==
        Words{"asc", "csv", "dxf", "geojson", "gltf", "gpkg", "hdf5", "obj", "tif", "vtk"});
  CHECK(offered(folder, {"flyrock", "law", "restitution/new"}) == Words{"restitution/newton"});
  CHECK(offered(folder, {"flyrock", "course", "bounc"}) == Words{"bouncing_ball"});
  CHECK(offered(folder, {"flyrock", "grade", "slope.yaml", "--with", "bounc"}) == Words{"bouncing_ball"});
  CHECK(offered(folder, {"flyrock", "new", "quarry/fence"}) == Words{"quarry/fence_design"});
  CHECK(offered(folder, {"flyrock", "man", "ex"}) == Words{"explain", "export"});
  // Every option that the help shows is offered.
  for (const std::string& command : command_names(folder)) {
    INFO(command);
    const std::string help = call(folder, command + " --help").out;
    const Words options = offered(folder, {"flyrock", command, "-"});
    static const std::regex option("(?:^|\n)  (?:-\\w \\[ )?(--[a-z-]+)");
    for (auto found = std::sregex_iterator(help.begin(), help.end(), option); found != std::sregex_iterator();
         ++found)
      CHECK(options.contains((*found)[1]));
    CHECK(options.contains("--help"));
  }
}

TEST_CASE("zsh reads its completion") {
  const Folder folder;
  const Output made = call(folder, "completion zsh > _flyrock");
  REQUIRE(made.code == 0);
  CHECK(read(folder.path() / "_flyrock").starts_with("#compdef flyrock\n"));
  CHECK(call(folder, "completion fish").code == 2);
  if (!has_program(folder, "zsh")) {
    WARN("SKIPPED: no zsh");
    return;
  }
  const Output checked = shell(folder, "zsh -n _flyrock");
  INFO(checked.err);
  CHECK(checked.code == 0);
}

TEST_CASE("every command has a manual page without a warning") {
  const Folder folder;
  REQUIRE(call(folder, "man > flyrock.1").code == 0);
  const std::string page = read(folder.path() / "flyrock.1");
  for (const std::string& command : command_names(folder)) {
    INFO(command);
    CHECK(page.find("flyrock\\-" + command) != std::string::npos);
    REQUIRE(call(folder, "man " + command + " > flyrock-" + command + ".1").code == 0);
  }
  const Output unknown = call(folder, "man expot");
  CHECK(unknown.code == 2);
  CHECK(unknown.err.find("did you mean `export`") != std::string::npos);
  if (!has_program(folder, "groff")) {
    WARN("SKIPPED: no groff");
    return;
  }
  const Output set = shell(folder, "for page in *.1; do groff -man -Tascii -ww -z $page || exit 1; done");
  CHECK(set.code == 0);
  CHECK(set.err.empty());
  CHECK(shell(folder, "groff -man -Tascii flyrock-run.1 | grep -Eq 'runs +shard +i +of +n'").code == 0);
}

}  // namespace flyrock::shell_test
