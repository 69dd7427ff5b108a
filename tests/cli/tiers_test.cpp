// `check` says where contacts are less exact (docs/numerics.md, Tiers of shapes).

#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "program.h"

using namespace flyrock::test;

namespace {

/// What `check` prints of a scene in 3D over level ground with these bodies.
std::string check_of(const std::vector<std::string>& bodies) {
  const Folder folder;
  std::string text =
      "flyrock: 1\ndimension: 3\nmethod: nscd\nmaterials: { m: { friction: { type: coulomb, mu: 0.5 } } }\n"
      "terrain: { type: plane, point: [0, 0, 0], normal: [0, 0, 1], material: m }\n"
      "stop: { time: 1 s }\nbodies:\n";
  for (const std::string& body : bodies) text += fmt::format("  - {{ {}, material: m }}\n", body);
  folder.write("s.yaml", text);
  const Output check = call(folder, "check s.yaml");
  INFO(check.out << check.err);
  REQUIRE(check.code == 0);
  return check.out;
}

const std::string drum =
    "name: drum, shape: { type: cylinder, radius: 0.3 m, height: 1 m }, density: 2700, position: [0, 0, 2]";
const std::string box =
    "name: box, shape: { type: box, size: [1, 1, 1] }, density: 2700, position: [4, 0, 2]";
const std::string ball =
    "name: ball, shape: { type: sphere, radius: 0.3 m }, density: 2700, position: [8, 0, 2]";

}  // namespace

TEST_CASE("check says in one line which bodies have less exact contacts among moving bodies") {
  CHECK(check_of({drum, box})
            .find("`drum`: shape tier B, against moving bodies exact to 0.001 of the size "
                  "(docs/numerics.md, Tiers of shapes)\n") == 0);
  CHECK(check_of({drum}).find("tier") == std::string::npos);  // alone on the terrain
  CHECK(check_of({box, ball}).find("tier") == std::string::npos);
  const std::string tube =
      "name: tube, shape: { type: hollow_cylinder, radius: 5 m, height: 4 m }, fixed: true, "
      "position: [8, 0, 2]";
  CHECK(check_of({ball, tube}).find("`tube`: shape tier C, exact to 0.001 of the size") == 0);
}
