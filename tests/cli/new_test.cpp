// flyrock new: what it copies is sound, and nothing is overwritten.

#include <catch2/catch.hpp>
#include <sstream>

#include "cli/program.h"

namespace flyrock::new_test {

using namespace flyrock::test;

TEST_CASE("new lists what there is, and each template of a plugin is a sound one", "[slow]") {
  const Folder folder;
  const Output list = call(folder, "new");
  REQUIRE(list.code == 0);
  CHECK(list.out.find("quarry/fence_design\n") != std::string::npos);
  CHECK(list.out.find("course/cradle\n") != std::string::npos);
  // Of two scenarios of one name, that in Lua is taken by its ending.
  CHECK(list.out.find("ninh_dan/benches_2d\nninh_dan/benches_2d.lua\n") != std::string::npos);
  CHECK(call(folder, "new ninh_dan/benches_2d -o site").out.starts_with("site/benches_2d.yaml\n"));
  std::istringstream names(list.out);
  int templates = 0;
  for (std::string name; std::getline(names, name);) {
    if (name.find('/') != std::string::npos || name.ends_with("-native")) continue;
    CAPTURE(name);
    CHECK(call(folder, "new " + name).code == 0);
    const Output check = call(folder, "check " + name + ".lua");
    INFO(check.err);
    CHECK(check.code == 0);
    CHECK(check.out.find("a sound plugin") != std::string::npos);
    ++templates;
  }
  CHECK(templates == 8);
}

TEST_CASE("A shipped scenario is found by its name from any folder, unless a file has the name") {
  const Folder folder;
  for (const char* name : {"quarry/catch_ditch", "quarry/catch_ditch.yaml", "ninh_dan/benches_2d.lua"}) {
    INFO(name);
    CHECK(call(folder, std::string("check ") + name).code == 0);
  }
  CHECK(call(folder, "check quarry/no_such").code == 2);
  CHECK(call(folder, "check --confined quarry/catch_ditch").code == 2);
  fs::create_directories(folder.path() / "quarry");
  folder.write("quarry/catch_ditch.yaml", "flyrock: 1\n");
  CHECK(call(folder, "check quarry/catch_ditch.yaml").code == 2);
}

TEST_CASE("new copies a scenario with the files that it names, and never over a file", "[slow]") {
  const Folder folder;
  const Output made = call(folder, "new quarry/permit -o site");
  INFO(made.err);
  REQUIRE(made.code == 0);
  CHECK(folder.has("site/permit_holes.csv"));
  CHECK(folder.has("site/permit_face.csv"));
  CHECK_FALSE(folder.has("site/fence_design.yaml"));
  CHECK(call(folder, "check site/permit.yaml").code == 0);
  folder.write("site/permit.yaml", "mine");
  const Output again = call(folder, "new quarry/permit -o site");
  CHECK(again.code == 2);
  CHECK(again.err.find("exists already") != std::string::npos);
  CHECK(read(folder.path() / "site/permit.yaml") == "mine");
  const Output wrong = call(folder, "new quarry/fence_desing");
  CHECK(wrong.code == 2);
  CHECK(wrong.err.find("did you mean `quarry/fence_design`") != std::string::npos);
}

}  // namespace flyrock::new_test
