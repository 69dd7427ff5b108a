// Directions as a compass shows them: launches, holes, faces, what is printed; and holes of which one is
// doubtful.

#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace flyrock::bearings_test {

namespace {

using namespace flyrock::test;
using Json = nlohmann::json;

Json summary_of(const Folder& folder, const std::string& scenario) {
  const Output run = call(folder, "run " + scenario + " --quiet --force -o out");
  INFO(run.err << run.out);
  REQUIRE(run.code == 0);
  return Json::parse(read(folder.path() / "out/summary.json"));
}

/// A rock that leaves a bench whose face looks to azimuth 10 deg.
std::string thrown(const std::string& direction, const std::string& terrain = "") {
  return "flyrock: 1\ndimension: 3\nmethod: ballistic\ntrials: 20\n"
         "terrain: { type: benches, count: 1, height: 10 m, face_angle: 80 deg, berm: 0 m, top: 300 m, "
         "floor: 900 m, "
         "length: 900 m, azimuth: 10 deg" +
         terrain +
         " }\nrocks:\n  - name: face\n    density: 2700 kg/m3\n    shape: { type: sphere, radius: 0.1 m }\n"
         "    release: { from: face, bench: 1 }\n    launch: { type: fixed, speed: 20 m/s, elevation: 10 "
         "deg" +
         direction + " }\nstop: { time: 60 s }\n";
}

/// The sectors of 10 deg to which rocks went.
Json sectors_of(const Folder& folder, const std::string& scenario) {
  folder.write("s.yaml", scenario);
  return summary_of(folder, "s.yaml")["points"][0]["runout_by_azimuth"][0]["sectors"];
}

/// Holes that lean by 10 deg, 3 m behind an upright face at x = 3 m; charges from 2.5 m to 12.4 m along them.
std::string blast_of(const std::string& holes, const std::string& more = "") {
  return "flyrock: 1\ndimension: 3\nmethod: ballistic\ntrials: 2\n"
         "terrain: { type: benches, count: 1, height: 12 m, face_angle: 89 deg, berm: 0 m, top: 200 m, "
         "floor: 900 m, "
         "length: 1500 m }\n"
         "blast:\n  explosive: ANFO\n  hole: { diameter: 102 mm, length: 12.4 m, stemming: 2.5 m }\n"
         "  spacing: 4 m\n  rock_density: 2700 kg/m3\n  breakout_angle: 90 deg\n  face: { points: face.csv "
         "}\n" +
         more + "  holes: " + holes +
         "\nrocks:\n  - name: face\n    per_hole: 1\n    density: 2700 kg/m3\n    shape: { type: sphere, "
         "radius: 0.1 m "
         "}\n    release: { from: face, bench: 1 }\n    launch: { type: gurney, elevation: 20 deg }\n"
         "stop: { time: 60 s }\n";
}

void write_face(const Folder& folder) {
  std::string face = "Easting (m),Northing (m),RL (m)\n";
  for (int y = -20; y <= 20; y += 2)
    for (int z = -2; z <= 12; ++z) face += "3," + std::to_string(y) + "," + std::to_string(z) + "\n";
  folder.write("face.csv", face);
}

double burden_of(const Folder& folder, const std::string& scenario) {
  folder.write("s.yaml", scenario);
  return summary_of(folder, "s.yaml")["points"][0]["blast"]["measured"][0]["burden_m"].get<double>();
}

const double lean = std::cos(80 * M_PI / 180);

}  // namespace

TEST_CASE("a launch by a bearing is absolute, one by an azimuth counts from the face") {
  const Folder folder;
  const std::pair<std::string, std::string> launches[] = {
      {", azimuth: 15 deg", ""},                                   // 25 deg from +x
      {", bearing: 65 deg", ""},                                   // 90 - 65
      {", bearing: { uniform: [61 deg, 69 deg] }", ""},            // 21 to 29 deg
      {", bearing: { normal: { mean: 65 deg, sd: 1 deg } }", ""},  //
      {", bearing: 50 deg", ", north: 75 deg"},                    // 75 - 50
      {", bearing: -295 deg", ""}};
  for (const auto& [direction, terrain] : launches) {
    INFO(direction << terrain);
    const Json sectors = sectors_of(folder, thrown(direction, terrain));
    REQUIRE(sectors.size() == 1);
    CHECK(sectors[0]["from_deg"] == 20.0);
    CHECK(sectors[0]["bearing_from_deg"] == (terrain.empty() ? 60.0 : 45.0));
  }
}

TEST_CASE("a bench whose face looks to a bearing throws there") {
  const Folder folder;
  std::string scenario = thrown("");
  scenario.replace(scenario.find("azimuth: 10 deg"), 15, "bearing: 125 deg");
  const Json sectors = sectors_of(folder, scenario);
  REQUIRE(sectors.size() == 1);
  CHECK(sectors[0]["bearing_from_deg"] == 120.0);
  folder.write("s.yaml",
               scenario.replace(scenario.find("bearing: 125 deg"), 16, "bearing: 125 deg, azimuth: 3 deg"));
  CHECK(call(folder, "check s.yaml").err.find("terrain.bearing: says the same as `azimuth`") !=
        std::string::npos);
}

TEST_CASE("the answer says the bearing to which an area reaches") {
  const Folder folder;
  folder.write("s.yaml",
               "flyrock: 1\ndimension: 3\nmethod: ballistic\ntrials: 400\nterrain: { type: plane }\nrocks:\n"
               "  - name: thrown\n    density: 2700 kg/m3\n    shape: { type: sphere, radius: 0.1 m }\n"
               "    release: { position: [0, 0, 1 m] }\n    launch: { type: fixed, speed: { uniform: [10 "
               "m/s, 20 m/s] }, "
               "elevation: 45 deg, bearing: { uniform: [123 deg, 131 deg] } }\n"
               "clearance: [{ name: people, probability: 0.3, sectors: 4 }]\nstop: { time: 60 s }\n");
  const Output run = call(folder, "run s.yaml --force -o out");
  INFO(run.out << run.err);
  CHECK((run.out + run.err).find("reaches farthest at bearing 135 deg, south-east, from") !=
        std::string::npos);
}

TEST_CASE("holes lean to their bearing, in a table, in a list and by their toes, with the burden by hand") {
  const Folder folder;
  write_face(folder);
  const double to_face = 3 - 12.4 * lean, away = 3 + 2.5 * lean;
  folder.write("east.csv", "Hole ID,x_m,y_m,z_m,dip_deg,Bearing (deg)\n1,0,0,12,80,90\n");
  folder.write("west.csv", "Hole ID,x_m,y_m,z_m,dip_deg,Bearing (deg)\n1,0,0,12,80,270\n");
  folder.write("math.csv", "hole,x_m,y_m,z_m,dip_deg,azimuth_deg\n1,0,0,12,80,0\n");
  folder.write("toe.csv", "hole,x,y,z,toe_x,toe_y,toe_z\n1,0,0,12," + std::to_string(12.4 * lean) + ",0," +
                              std::to_string(12 - 12.4 * std::sin(80 * M_PI / 180)) + "\n");
  CHECK(burden_of(folder, blast_of("{ file: east.csv }")) == Approx(to_face).epsilon(1e-6));
  CHECK(burden_of(folder, blast_of("{ file: toe.csv }")) == Approx(to_face).epsilon(1e-5));
  CHECK(burden_of(folder, blast_of("{ file: math.csv }", "  azimuths: mathematical\n")) ==
        Approx(to_face).epsilon(1e-6));
  CHECK(burden_of(folder, blast_of("\n    - { x: 0, y: 0, z: 12, dip: 80 deg, bearing: 90 deg }")) ==
        Approx(to_face).epsilon(1e-6));
  CHECK(burden_of(folder, blast_of("{ file: west.csv }")) == Approx(away).epsilon(1e-6));
  folder.write("s.yaml", blast_of("{ file: west.csv }"));
  const Output check = call(folder, "check s.yaml");
  CHECK(check.out.find(
            "holes of west.csv: 1 row; x 0 m, y 0 m, z 12 m, dip 80 deg, bearing 270 deg; holes lean "
            "to the west, 80 deg from horizontal") != std::string::npos);
  CHECK(check.err.find("hole 1 of the front row leans to the west, away from its face") != std::string::npos);
  folder.write("s.yaml", blast_of("{ file: math.csv }"));
  const Output refused = call(folder, "check s.yaml");
  CHECK(refused.code == 2);
  CHECK(refused.err.find("math.csv:1:26: error: blast.holes: `azimuth_deg`: expected `bearing_deg`") !=
        std::string::npos);
}

TEST_CASE("without a survey a hole that leans away from its bench face is named, in 2D too") {
  const Folder folder;
  for (const char* dimension : {"2", "3"}) {
    for (const auto& [bearing, is_away] : {std::pair("270 deg", true), std::pair("90 deg", false)}) {
      folder.write(
          "s.yaml",
          std::string("flyrock: 1\nmethod: ballistic\ndimension: ") + dimension +
              "\nterrain: { type: benches, count: 1, height: 12 m, face_angle: 75 deg, berm: 0 m, "
              "top: 50 m, floor: 900 m }\nblast:\n  explosive: ANFO\n  hole: { diameter: 102 mm }\n"
              "  holes: [{ x: -3 m, y: 0, burden: 3 m, dip: 80 deg, bearing: " +
              bearing +
              " }]\nrocks:\n  - name: top\n    per_hole: 1\n    density: 2700\n    shape: { type: " +
              (dimension == std::string("2") ? "disk" : "sphere") +
              ", radius: 0.1 }\n    launch: { type: richards_moore, k: 14 }\nstop: { time: 60 s }\n");
      const Output check = call(folder, "check s.yaml");
      INFO(dimension << bearing << check.err);
      CHECK(check.code == 0);
      CHECK((check.err.find("away from its face") != std::string::npos) == is_away);
    }
  }
}

TEST_CASE("one hole is doubtful, one row throws, one group flies in air") {
  const Folder folder;
  folder.write(
      "s.yaml",
      "flyrock: 1\ndimension: 2\nmethod: ballistic\ntrials: 300\nair: { cd: 1 }\n"
      "terrain: { type: profile, points: [[-50, 0], [2000, 0]] }\nblast:\n  hole: { diameter: 102 mm }\n"
      "  explosive: ANFO\n  rock_density: 2700 kg/m3\n  holes:\n"
      "    - { hole: 7, row: 1, burden: 3 m }\n    - { hole: 13, row: 1, burden: 3 m }\n"
      "    - { hole: B, row: 2, burden: 3 m }\n"
      "branches: [{ name: void, probability: 0.5, holes: [13], set: { blast.burden: 1 m } }]\nrocks:\n"
      "  - { name: front, per_hole: 2, rows: [1], air: none, density: 2700, shape: { type: disk, radius: 0.1 "
      "}, "
      "release: { position: [0, 0] }, launch: { type: fixed, speed: 20 m/s, elevation: 45 deg } }\n"
      "  - { name: one, per_hole: 1, holes: [B], air: { cd: 0.5 }, density: 2700, shape: { type: disk, "
      "radius: "
      "0.1 }, release: { position: [0, 0] }, launch: { type: fixed, speed: 20 m/s, elevation: 45 deg } }\n"
      "  - { name: all, per_hole: 1, density: 2700, shape: { type: disk, radius: 0.1 }, release: { position: "
      "[0, 0] }, launch: { type: fixed, speed: 20 m/s, elevation: 45 deg } }\nstop: { time: 60 s }\n");
  const Json point = summary_of(folder, "s.yaml")["points"][0];
  CHECK(point["rocks"][1]["count"] == 4 * 300);
  CHECK(point["rocks"][2]["count"] == 1 * 300);
  CHECK(point["rocks"][3]["count"] == 3 * 300);
  const auto p50 = [&](int group) { return point["rocks"][group]["runout"]["p50"].get<double>(); };
  CHECK(p50(1) == Approx(400 / 9.81).epsilon(1e-6));  // v^2 / g
  CHECK(p50(2) < p50(1));
  CHECK(p50(3) < p50(2));  // twice the drag
  const Json branches = point["branches"];
  REQUIRE(branches.size() == 2);
  const double voids = branches[1]["units"].get<double>();
  CHECK(std::abs(voids / 300 - 0.5) < 4 * std::sqrt(0.25 / 300));
  CHECK(branches[1]["share"].get<double>() == Approx(voids / 300));
  CHECK(branches[0]["probability"].get<double>() == Approx(1 - 0.5 / 3));
  CHECK(branches[0]["units"].get<double>() + voids == 900);
}

TEST_CASE("rocks of later rows that leave from the face are warned of, and wrong names of holes refused") {
  const Folder folder;
  const auto with = [](const std::string& group, const std::string& branch = "") {
    return "flyrock: 1\ndimension: 2\nmethod: ballistic\n"
           "terrain: { type: benches, count: 1, height: 12 m, face_angle: 75 deg, berm: 0 m, top: 50 m, "
           "floor: 900 m }\n"
           "blast:\n  explosive: ANFO\n  hole: { diameter: 102 mm }\n  rock_density: 2700 kg/m3\n  "
           "breakout_angle: 90 "
           "deg\n  holes:\n    - { hole: A1, row: 1, burden: 3 m }\n    - { hole: A2, row: 2, burden: 3 m "
           "}\n" +
           branch + "rocks:\n  - { name: face, " + group +
           "density: 2700, shape: { type: disk, radius: 0.1 }, release: { from: face }, launch: { type: "
           "gurney } }\n"
           "stop: { time: 60 s }\n";
  };
  const auto said = [&](const std::string& scenario) {
    folder.write("s.yaml", scenario);
    return call(folder, "check s.yaml").err;
  };
  CHECK(said(with("per_hole: 1, "))
            .find("1 of the 2 holes stand behind row 1, and their rocks leave from the free face "
                  "too: `rows: [1]` takes those of the front row alone") != std::string::npos);
  CHECK(said(with("per_hole: 1, rows: [1], ")).find("stand behind") == std::string::npos);
  CHECK(said(with("per_hole: 1, holes: [A2], ")).find("stand behind") == std::string::npos);
  CHECK(said(with("per_hole: 1, holes: [A3], ")).find("there is no hole `A3`, did you mean `A1`?") !=
        std::string::npos);
  CHECK(said(with("per_hole: 1, rows: [3], ")).find("there is no row `3`") != std::string::npos);
  CHECK(said(with("per_trial: 1, rows: [1], ")).find("chooses holes for `per_hole`") != std::string::npos);
  const std::string branch =
      "branches: [{ name: void, probability: 0.1, holes: [A3], set: { blast.burden: 1 m } }]\n";
  CHECK(said(with("per_hole: 1, rows: [1], ", branch)).find("there is no hole `A3`") != std::string::npos);
}

}  // namespace flyrock::bearings_test
