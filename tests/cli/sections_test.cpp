// Several surveyed sections in one scenario, and earthworks on profiles.

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "../workbook_file.h"
#include "cli/program.h"

namespace flyrock::sections_test {

namespace {

using namespace flyrock::test;
using namespace workbooks;
using Json = nlohmann::json;

/// Rocks start on the upper end of a slope.
std::string scenario(const std::string& terrain, const std::string& more = "") {
  return "flyrock: 1\ndimension: 2\nmethod: nscd\ntrials: 5\nterrain: { " + terrain +
         " }\nmaterials:\n  rock: { restitution: { type: newton, en: 0.3 }, friction: { type: coulomb, mu: "
         "0.5 } }\n"
         "  sand: { restitution: { type: newton, en: 0.05 }, friction: { type: coulomb, mu: 0.9 } }\n"
         "rocks:\n  - name: loose\n    density: 2700 kg/m3\n"
         "    shape: { type: polygon, sides: 6, diameter: { uniform: [0.4 m, 0.8 m] } }\n"
         "    release: { x: -1, above_ground: 1 m }\n    launch: { type: fixed, velocity: [6 m/s, 0 m/s] }\n"
         "gates: [{ name: road, x: 40 }]\nstop: { time: 60 s }\n" +
         more;
}

const std::vector<std::vector<std::string>> section_a = {
    {"distance", "height"}, {"-20", "20"}, {"0", "20"}, {"20", "0"}, {"100", "0"}};
const std::vector<std::vector<std::string>> section_b = {
    {"distance", "height"}, {"-20", "20"}, {"0", "20"}, {"12", "0"}, {"100", "-2"}};

Json points_of(const Folder& folder, const std::string& out) {
  return Json::parse(read(folder.path() / out / "summary.json"))["points"];
}

double p50_of(const Json& point) { return point["rocks"][0]["runout"]["p50"].get<double>(); }

}  // namespace

TEST_CASE("sections of a workbook are the points of a sweep, named by their letters, each as it is alone") {
  const Folder folder;
  folder.write("pit.xlsx", xlsx_of({{"A", xlsx_sheet(section_a)}, {"B", xlsx_sheet(section_b)}}));
  const std::string profile = "type: profile, file: \"pit.xlsx#A\", material: rock";
  folder.write(
      "all.yaml",
      scenario(profile,
               "sweep:\n  rows:\n    - { label: A, terrain.file: \"pit.xlsx#A\", gates.road.x: 40 }\n"
               "    - { label: B, terrain.file: \"pit.xlsx#B\", gates.road.x: 35 }\n"));
  const Output run = call(folder, "run all.yaml --quiet -o all");
  INFO(run.err);
  REQUIRE(run.code == 0);
  const std::string answer = Json::parse(read(folder.path() / "all/summary.json"))["answer"].dump();
  INFO(answer);
  CHECK(answer.find("(B)") != std::string::npos);
  CHECK(answer.find("pit.xlsx") == std::string::npos);
  CHECK(call(folder, "check all.yaml").out.find("terrain at B: 4 points, -2 to 20 m\n") != std::string::npos);
  folder.write("b.yaml", scenario("type: profile, file: \"pit.xlsx#B\", material: rock"));
  REQUIRE(call(folder, "run b.yaml --quiet -o b --set gates.road.x=35").code == 0);
  const Json all = points_of(folder, "all");
  REQUIRE(all.size() == 2);
  CHECK(p50_of(all[1]) == p50_of(points_of(folder, "b")[0]));
  CHECK(p50_of(all[0]) != p50_of(all[1]));
  const Output csv = call(folder, "export all --to csv -o tables");
  CHECK(read(folder.path() / "tables/sweep.csv").find(",B\n") != std::string::npos);
}

TEST_CASE("a ditch and a bund on a surveyed profile hold rocks back, on a section of a terrain in 3D alike") {
  const Folder folder;
  folder.write("a.csv", "-20,20\n0,20\n20,0\n100,0\n");
  const std::string works =
      "ditch: { x: 20, width: 4, depth: 2 m }, bund: { height: 2 m }, materials: { ditch: sand, bund: sand }";
  const std::string profile = "type: profile, file: a.csv, material: rock";
  folder.write("bare.yaml", scenario(profile));
  folder.write("works.yaml", scenario(profile + ", " + works));
  folder.write(
      "mesh.obj",
      "v -20 -30 20\nv 0 -30 20\nv 20 -30 0\nv 100 -30 0\nv -20 30 20\nv 0 30 20\nv 20 30 0\nv 100 30 0\n"
      "f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\n");
  folder.write("cut.yaml",
               scenario("type: section, of: { type: mesh, file: mesh.obj }, from: [-20, 0], to: [100, 0], "
                        "material: rock, ditch: { x: 40, width: 4, depth: 2 m }, bund: { height: 2 m }, "
                        "materials: { ditch: sand, bund: sand }"));
  for (const char* name : {"bare", "works"}) {
    const Output run = call(folder, std::string("run ") + name + ".yaml --quiet -o " + name);
    INFO(run.err);
    REQUIRE(run.code == 0);
  }
  CHECK(p50_of(points_of(folder, "works")[0]) < p50_of(points_of(folder, "bare")[0]) - 1);
  const Output cut = call(folder, "check cut.yaml --set rocks.loose.release.x=15 --set gates.road.x=60");
  INFO(cut.err);
  CHECK(cut.code == 0);
  const Output swept =
      call(folder, "check works.yaml --set \"terrain.bund.height={ sweep: [1 m, 2 m, 3 m] }\"");
  INFO(swept.err);
  CHECK(swept.out.find("at each of 3 sweep points") != std::string::npos);
}

TEST_CASE("a ditch at the rounded place of a toe begins at the toe") {
  const Folder folder;
  folder.write("a.csv", "-20,20\n0,20\n20.004,0\n100,0\n");
  for (const double x : {20.0, 20.004, 20.01}) {
    folder.write("s.yaml",
                 scenario(fmt::format("type: profile, file: a.csv, material: rock, ditch: {{ x: {}, "
                                      "width: 4, depth: 2 m }}, materials: {{ ditch: sand }}",
                                      x)));
    const Output check = call(folder, "check s.yaml");
    INFO(x << check.err);
    CHECK(check.code == 0);
  }
}

TEST_CASE("earthworks say what they need, and benches keep their own") {
  const Folder folder;
  folder.write("a.csv", "-20,20\n0,20\n20,0\n100,0\n");
  const auto said = [&](const std::string& works) {
    folder.write("s.yaml", scenario("type: profile, file: a.csv, material: rock, " + works));
    const Output output = call(folder, "check s.yaml");
    CHECK(output.code == 2);
    return output.err;
  };
  CHECK(said("bund: { height: 2 m }").find("terrain.bund: has no place, expected `x`, or a `ditch`") !=
        std::string::npos);
  CHECK(said("bund: { x: 30, distance: 1, height: 2 m }").find("expected one of both") != std::string::npos);
  CHECK(said("ditch: { x: 95, width: 9, depth: 2 m }").find("the ditch ") != std::string::npos);
  CHECK(said("ditch: { x: 30, width: 9, depth: 2 m, on: floor }").find("terrain.ditch.on: unknown key") !=
        std::string::npos);
  folder.write("s.yaml",
               scenario("type: benches, count: 1, height: 10 m, face_angle: 70 deg, berm: 0 m, floor: 60 m, "
                        "ditch: { width: 3 m, depth: 1 m }, bund: { height: 1 m }, material: rock"));
  const Output benches = call(folder, "check s.yaml");
  INFO(benches.err);
  CHECK(benches.code == 0);
}

}  // namespace flyrock::sections_test
