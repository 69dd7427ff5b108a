// Blocks between joints, from a survey to their table.

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "program.h"
#include "rows.h"

using namespace flyrock::test;

namespace joint_blocks_test {

/// A box of 12 x 10 x 8 m on a floor, cut by three sets through (0.3, 0.4, 0.5).
std::string box(const std::string& sets, const std::string& more = "") {
  return fmt::format(R"(flyrock: 1
dimension: 3
method: nscd
trials: 2
rock_contacts: on
terrain: {{ type: plane, material: rock }}
materials: {{ rock: {{ restitution: {{ type: newton, en: 0 }}, friction: {{ type: coulomb, angle: 35 deg }} }} }}
rocks:
  - name: blocks
    type: joint_blocks
    region: {{ points: [[0, 0, 0], [12, 0, 0], [12, 10, 0], [0, 10, 0], [0, 0, 8], [12, 0, 8], [12, 10, 8], [0, 10, 8]] }}
    {}
    least_volume: 0
    density: 2700 kg/m3
    material: rock
    {}
stop: {{ time: 1 ms }}
)",
                     sets, more);
}

constexpr const char* bricks = R"(sets:
      - { name: a, dip: 90 deg, dip_direction: 90 deg, spacing: 2 m, origin: [0.3, 0.4, 0.5] }
      - { name: b, dip: 90 deg, dip_direction: 0, spacing: 2.5 m, origin: [0.3, 0.4, 0.5] }
      - { name: c, dip: 0, dip_direction: 0, spacing: 1.6 m, origin: [0.3, 0.4, 0.5] })";

nlohmann::json summary_of(const Folder& folder, const std::string& result) {
  return nlohmann::json::parse(read(folder.path() / result / "summary.json"));
}

TEST_CASE("a box between three sets has the bricks of the closed form, with the same bytes for any threads") {
  const Folder folder;
  folder.write("box.yaml", box(bricks, "only: factor_below_1"));
  const Output checked = call(folder, "check box.yaml");
  INFO(checked.err);
  REQUIRE(checked.code == 0);
  CHECK(checked.out.find("blocks of trial 0: 210 (960 m3) from 15 joints, Jv 1.53 joints/m") !=
        std::string::npos);
  for (const char* threads : {"1", "8"})
    REQUIRE(call(folder, fmt::format("run box.yaml --quiet -o out{0} -j {0}", threads)).code == 0);
  for (const char* file : {"rocks.csv", "summary.json", "report.html"})
    CHECK(read(folder.path() / "out1" / file) == read(folder.path() / "out8" / file));
  const nlohmann::json blocks = summary_of(folder, "out1")["points"][0]["blocks"];
  CHECK(blocks["all"]["count"] == 210);
  CHECK(blocks["all"]["volume_m3"].get<double>() == Approx(960).epsilon(1e-12));
  CHECK(blocks["joint_count_per_m"].get<double>() == Approx(1.525).epsilon(1e-9));
  CHECK(blocks["factor_below_1"]["count"] == 0);  // all stand on a level base
  REQUIRE(call(folder, "export out1 --to csv -o tables").code == 0);
  const std::string table = read(folder.path() / "tables" / "blocks.csv");
  CHECK(std::count(table.begin(), table.end(), '\n') == 1 + 2 * 210);
  CHECK(table.find(
            "point,trial,block,rock,x_m,y_m,z_m,volume_m3,faces,free_area_m2,joint_area_m2,removable,mode,"
            "joints,trend_deg,plunge_deg,factor,reason") == 0);
}

TEST_CASE("the sets of a survey are found, and joint_blocks reads them") {
  const Folder folder;
  const std::string survey = FLYROCK_SOURCE_DIR "/scenarios/quarry/joint_survey.csv";
  const Output found = call(folder, "joints " + survey + " --face 70/90 --friction 34 -o found");
  INFO(found.err);
  REQUIRE(found.code == 0);
  const nlohmann::json data = nlohmann::json::parse(read(folder.path() / "found" / "joints.json"));
  REQUIRE(data["sets"].size() == 3);
  CHECK(data["sets"][0]["spacing_m"]["value"].get<double>() > 0.5);
  for (const char* share : {"plane", "wedge", "toppling"}) {
    const auto interval = data["shares"][share]["interval"];
    CHECK(interval[0].get<double>() <= data["shares"][share]["value"].get<double>());
    CHECK(data["shares"][share]["value"].get<double>() <= interval[1].get<double>());
  }
  CHECK(read(folder.path() / "found" / "joints.html").find("<svg") != std::string::npos);
  folder.write("box.yaml", box("sets: found/sets.yaml", "only: factor_below_1"));
  const Output checked = call(folder, "check box.yaml");
  INFO(checked.err);
  CHECK(checked.code == 0);
  const std::string shown = call(folder, "show box.yaml").out;
  CHECK(shown.find("name: set_3") != std::string::npos);
}

TEST_CASE("the page of joints says which K it fits and which intervals are exact") {
  const Folder folder;
  std::string planes = "dip_deg,dip_direction_deg\n";
  for (int n = 0; n < 20; ++n) planes += "40,90\n";
  folder.write("parallel.csv", planes);
  const auto page_of = [&](const std::string& face) {
    REQUIRE(call(folder, "joints parallel.csv" + face + " -o out" + (face.empty() ? "" : "_of_face")).code ==
            0);
    return read(folder.path() / (face.empty() ? "out" : "out_of_face") / "joints.html");
  };
  const std::string alone = page_of("");
  CHECK(alone.find("K 2000") != std::string::npos);
  CHECK(alone.find("with K from 3 to 2000: a set with 2000 may be closer") != std::string::npos);
  CHECK(alone.find("Clopper and Pearson") == std::string::npos);
  CHECK(page_of(" --face 70/90 --friction 34").find("(of shares of none or all by Clopper and Pearson)") !=
        std::string::npos);
}

TEST_CASE("a survey that cannot be read is refused in one line with its place, and nothing is written") {
  const Folder folder;
  folder.write("steep.csv", "dip_deg,dip_direction_deg\n40,90\n140,90\n");
  folder.write("heads.csv", "angle_deg,bearing_deg\n40,90\n");
  folder.write("few.csv", "dip_deg,dip_direction_deg\n40,90\n50,90\n");
  const Output steep = call(folder, "joints steep.csv -o out");
  CHECK(steep.code == 2);
  CHECK(steep.err.find("steep.csv:3:1: error: `dip` is 140 deg, expected 0 to 90 deg") != std::string::npos);
  const Output heads = call(folder, "joints heads.csv -o out");
  CHECK(heads.code == 2);
  CHECK(heads.err.find("heads.csv:1:1: error: no column is `dip`") != std::string::npos);
  CHECK(call(folder, "joints few.csv -o out").err ==
        "error: few.csv: fewer than 3 planes are left, expected more\n");
  CHECK(call(folder, "joints steep.csv --face 70/180")
            .err.find("--face and --friction: expected both or none") != std::string::npos);
  folder.write("line.csv", "dip_deg,dip_direction_deg,scanline_plunge_deg\n40,90,5\n50,90,5\n60,90,5\n");
  CHECK(call(folder, "joints line.csv -o out")
            .err.find("line.csv:2:7: error: `scanline_plunge` needs `scanline_trend`") != std::string::npos);
  const Output of_folder = call(folder, "joints . -o out");
  CHECK(of_folder.code == 2);
  CHECK(of_folder.err == "error: cannot read the file .\n");
  CHECK_FALSE(folder.has("out"));
}

TEST_CASE("dip directions, trends and bearings of joint blocks count from the north of the terrain") {
  // The same joints, bolt and push where north is +y, and where it is +x: every bearing is 90 deg less.
  const auto scenario = [](const std::string& terrain, int north) {
    std::string text = box(fmt::format(R"(sets:
      - {{ name: a, dip: 70 deg, dip_direction: {} deg, spacing: 5 m, origin: [0.3, 0.4, 0.5] }}
      - {{ name: b, dip: 80 deg, dip_direction: {} deg, spacing: 6 m, origin: [0.3, 0.4, 0.5] }}
      - {{ name: c, dip: 25 deg, dip_direction: {} deg, spacing: 4 m, origin: [0.3, 0.4, 0.5] }})",
                                       90 + north, 170 + north, 280 + north),
                           fmt::format(R"(horizontal: 0.1
    bearing: {} deg
    bolts: [{{ at: [1, 1, 7.9], trend: {} deg, plunge: 10 deg, force: 100 kN }}])",
                                       150 + north, 270 + north));
    const std::string plane = "{ type: plane, material: rock }";
    return text.replace(text.find(plane), plane.size(), terrain);
  };
  const Folder folder;
  folder.write("y.yaml", scenario("{ type: plane, material: rock }", 0));
  folder.write("x.yaml", scenario("{ type: plane, material: rock, north: 0 deg }", -90));
  const auto blocks_of = [&](const std::string& name, int north) {
    const Output output = call(folder, fmt::format("run {0}.yaml --quiet -o {0}", name));
    INFO(output.err);
    REQUIRE(output.code == 0);
    return query(folder.path() / name / "results.db",
                 fmt::format("select round(volume_m3, 6), mode, round(factor, 6), round(plunge_deg, 6), "
                             "round(trend_deg - {} + 360, 4) % 360 from blocks order by trial, rock",
                             north));
  };
  const auto of_y = blocks_of("y", 0), of_x = blocks_of("x", -90);
  CHECK(of_y.size() > 20);
  CHECK(of_y == of_x);
}

}  // namespace joint_blocks_test
