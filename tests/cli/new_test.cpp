// flyrock new: what it copies is sound, and nothing is overwritten. flyrock grade.

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

TEST_CASE("grade judges students by the expectations of a lab") {
  const Folder folder;
  REQUIRE(call(folder, "new course/bouncing_ball -o good").code == 0);
  REQUIRE(call(folder, "new course/bouncing_ball -o wrong").code == 0);
  const std::string name = folder.has("good/bouncing_ball.lua") ? "bouncing_ball.lua" : "bouncing_ball.yaml";
  std::string text = read(folder.path() / "wrong" / name);
  text.replace(text.find("en: 0.5"), 7, "en: 0.4");
  folder.write("wrong/" + name, text);
  folder.write("empty.yaml", "flyrock: 1\n");
  CHECK(call(folder, "grade good/" + name + " --with bouncing_ball").code == 0);
  CHECK(call(folder, "grade wrong/" + name + " --with bouncing_ball").code == 1);
  CHECK(call(folder, "grade empty.yaml --with bouncing_ball").code == 2);
  const Output all =
      call(folder, "grade good/" + name + " wrong/" + name + " empty.yaml --with bouncing_ball");
  CHECK(all.code == 1);
  CHECK(all.out.starts_with("student,result,held,expectations\ngood/" + name + ",passed,"));
  CHECK(all.out.find("\nwrong/" + name + ",failed,") != std::string::npos);
  CHECK(all.out.find("\nempty.yaml,error,0,0\n") != std::string::npos);
  CHECK(call(folder, "grade good/" + name + " --with bouncing_bal").code == 2);
}

}  // namespace flyrock::new_test
