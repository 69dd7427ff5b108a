// Rocks from tables and their comparison with what was measured, as a user runs it.

#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace flyrock::measured_test {

namespace {

using namespace flyrock::test;
using Json = nlohmann::json;

Json summary_of(const Folder& folder, const std::string& scenario, const std::string& out = "out") {
  const Output run = call(folder, "run " + scenario + " --quiet --force -o " + out);
  INFO(run.err << run.out);
  REQUIRE(run.code == 0);
  return Json::parse(read(folder.path() / out / "summary.json"));
}

/// Rocks that are thrown to the ground and stay where they land: at x + 2 v^2/g sin cos.
std::string thrown(int dimension, const std::string& rocks, const std::string& observed) {
  const std::string d = std::to_string(dimension);
  return "flyrock: 1\ndimension: " + d + "\nmethod: ballistic\ntrials: 40\nterrain: " +
         (dimension == 2 ? "{ type: profile, points: [[-500, 0], [500, 0]] }" : "{ type: plane }") +
         "\nrocks:\n  - { name: r, density: 2500, shape: { type: from_lengths, form: sphere }, " + rocks +
         " }\nobserved: " + observed + "\nstop: { time: 100 s }\n";
}

}  // namespace

TEST_CASE("a height is no part of a measured distance, in 2D as in 3D") {
  // Starts 12 m above the ground and 3 m along it; stops that were measured at x = 40 and 50 m.
  for (const int dimension : {2, 3})
    for (const std::string of : {"runout", "place"}) {
      INFO(dimension << "D, " << of);
      const Folder folder;
      folder.write("rocks.csv",
                   "name,mass_kg,x_m,y_m,z_m,vx_m_s,vy_m_s,vz_m_s\na,10,3,0,12,8,0,0\nb,10,3,0,12,10,0,0\n");
      folder.write("stops.csv", "name,x_m,y_m\na,40,0\nb,50,0\n");
      folder.write("s.yaml", thrown(dimension, "table: rocks.csv", "{ file: stops.csv, of: " + of + " }"));
      const Json observed = summary_of(folder, "s.yaml")["points"][0]["observed"];
      CHECK(observed["measured"]["min"].get<double>() == Approx(37));
      CHECK(observed["measured"]["max"].get<double>() == Approx(47));
      CHECK(observed["measured"]["p50"].get<double>() == Approx(42));
      const Output checked = call(folder, "check s.yaml");
      INFO(checked.out << checked.err);
      CHECK(checked.out.find("observed: 2 rows, " + of + " 37 to 47 m") != std::string::npos);
      CHECK(checked.out.find("median 42 m") != std::string::npos);
    }
}

TEST_CASE("a table with velocities flies each rock by its own, distances measured so have no bias") {
  for (const int dimension : {2, 3}) {
    const Folder folder;
    std::string rocks = "name,mass_kg,x_m,y_m,z_m,vx_m_s,vy_m_s,vz_m_s\n";
    for (int i = 0; i < 12; ++i)
      rocks += "r" + std::to_string(i) + "," + std::to_string(10 + i) + ",5,0,0.5," + std::to_string(3 + i) +
               ",0," + std::to_string(4 + 0.5 * i) + "\n";
    // In the other order: names pair them.
    std::string measured = "name,distance_m\n";
    for (int i = 11; i >= 0; --i) {
      const double vx = 3 + i, vz = 4 + 0.5 * i;
      measured += "r" + std::to_string(i) + "," +
                  std::to_string(vx * (vz + std::sqrt(vz * vz + 2 * 9.81 * 0.5)) / 9.81) + "\n";
    }
    folder.write("rocks.csv", rocks);
    folder.write("stops.csv", measured);
    folder.write("s.yaml", thrown(dimension, "table: rocks.csv", "{ file: stops.csv, of: runout }"));
    const Json summary = summary_of(folder, "s.yaml");
    const Json observed = summary["points"][0]["observed"];
    CHECK(observed["paired"] == true);
    CHECK(observed["rows"] == 12);
    CHECK(std::abs(observed["bias"].get<double>()) < 1e-4);
    CHECK(observed["energy_distance"].get<double>() < 1e-4);
    // Every trial is alike, and the page says so.
    CHECK(observed["scatter"] == false);
    CHECK(observed["inside_90"]["share"].is_null());
    CHECK(summary["answer"].get<std::string>().find("no scatter") != std::string::npos);
  }
}

TEST_CASE("a model with scatter has bands, the comparison does not change other results") {
  const Folder folder;
  folder.write("rocks.csv", "mass,x,y,z\n100,0,0,1\n200,0,0,1\n300,0,0,1\n");
  folder.write("stops.csv", "x,y\n20,0\n0,25\n300,0\n");
  const std::string launch =
      "table: rocks.csv, launch: { type: fixed, speed: { uniform: [10, 18] }, elevation: 45 deg }";
  folder.write("with.yaml", thrown(3, launch, "{ file: stops.csv, of: runout }"));
  const Json observed = summary_of(folder, "with.yaml")["points"][0]["observed"];
  CHECK(observed["scatter"] == true);
  CHECK(observed["inside_90"]["of"] == 3);
  CHECK(observed["inside_90"]["rows"] == 2);
  CHECK(observed["energy_noise_p90"].get<double>() > 0);
  CHECK(observed["energy_distance"].get<double>() > observed["energy_noise_p90"].get<double>());
  CHECK(observed["bias"].get<double>() == Approx(-93).margin(8));
  std::string without = thrown(3, launch, "");
  without.erase(without.find("observed: \n"), 11);
  folder.write("without.yaml", without);
  const Json other = summary_of(folder, "without.yaml", "other");
  CHECK_FALSE(other["points"][0].contains("observed"));
  CHECK(read(folder.path() / "out/rocks.csv") == read(folder.path() / "other/rocks.csv"));
}

TEST_CASE("the farthest rock of each blast is compared with distances of blasts") {
  const Folder folder;
  folder.write("throws.csv", "distance\n30\n33\n36\n");
  folder.write("s.yaml", thrown(3,
                                "per_trial: 50, launch: { type: fixed, speed: { uniform: [10, 18] }, "
                                "elevation: 45 deg }, release: { position: [0, 0, 0.1] }",
                                "{ file: throws.csv, of: distance, per: blast }"));
  std::string text = read(folder.path() / "s.yaml");
  const std::string form = "{ type: from_lengths, form: sphere }";
  text.replace(text.find(form), form.size(), "{ type: sphere, radius: 0.1 }");
  folder.write("s.yaml", text);
  const Json observed = summary_of(folder, "s.yaml")["points"][0]["observed"];
  CHECK(observed["paired"] == false);
  CHECK(observed["values"] == 40);                              // one a trial
  CHECK(observed["quantiles"][3]["model"].get<double>() > 31);  // near the farthest possible, 33 m
  CHECK(observed["quantiles"][6]["model"].get<double>() < 33.2);
}

TEST_CASE("check says by how much lengths are scaled, and warns of units that are wrong") {
  const Folder folder;
  folder.write("rocks.csv", "mass,l1,l2,l3,x,y,z\n500000,1,0.5,0.4,0,0,5\n");
  folder.write("s.yaml", thrown(3, "table: rocks.csv", "{ file: stops.csv, of: runout }"));
  folder.write("stops.csv", "distance\n10\n");
  const Output check = call(folder, "check s.yaml");
  CHECK(check.code == 0);
  CHECK((check.out + check.err).find("check the units of the table") != std::string::npos);
}

TEST_CASE(
    "a table of blasts is compared hole by hole: how often the model falls short, and by which factor") {
  const Folder folder;
  std::string blasts = "blast,burden_m,throw_m\n";
  for (int i = 0; i < 24; ++i)
    blasts += "b" + std::to_string(i) + "," + std::to_string(2 + 0.1 * i) + "," +
              std::to_string(i < 18 ? 60 : 20) + "\n";
  folder.write("blasts.csv", blasts);
  const std::string text =
      "flyrock: 1\ndimension: 2\nmethod: ballistic\ntrials: 2\n"
      "terrain: { type: profile, points: [[-500, 0], [500, 0]] }\n"
      "blast: { explosive: ANFO, hole: { diameter: 102 mm, length: 12 m, stemming: 3 m }, spacing: 3 m,\n"
      "  holes: { file: blasts.csv, columns: { hole: blast } } }\n"
      "rocks:\n  - { name: r, per_hole: 3, density: 2500, shape: { type: disk, radius: 0.1 },\n"
      "      release: { position: [0, 0.1] },\n"
      "      launch: { type: fixed, speed: 20 m/s, elevation: 45 deg } }\n"
      "observed: { file: blasts.csv, of: distance, per: hole, columns: { name: blast, distance: throw_m } }\n"
      "stop: { time: 100 s }\n";
  folder.write("s.yaml", text);
  const Json summary = summary_of(folder, "s.yaml");
  const Json observed = summary["points"][0]["observed"];
  CHECK(observed["per"] == "hole");
  CHECK(observed["rows"] == 24);
  CHECK(observed["values"] == 48);  // one a hole and trial
  const double flown = observed["rocks"][0]["p50"];
  CHECK(flown == Approx(20.0 * 20 / 9.81).epsilon(0.01));
  const Json throws = observed["throws"];
  CHECK(throws["blasts"] == 24);
  CHECK(throws["short"] == Approx(0.75));
  CHECK(throws["factors"][1]["factor"] == Approx(60 / flown));
  CHECK(throws["site"]["fitted"] == 12);
  CHECK(throws["site"]["covered"] == 1);
  CHECK(summary["answer"].get<std::string>().find("Of 24 blasts it falls short") != std::string::npos);

  blasts.replace(blasts.find("b7"), 2, "bx");
  folder.write("others.csv", blasts);
  std::string wrong = text;
  wrong.replace(wrong.rfind("blasts.csv"), 10, "others.csv");
  folder.write("wrong.yaml", wrong);
  const Output check = call(folder, "check wrong.yaml");
  CHECK(check.code == 2);
  CHECK(check.err.find("others.csv:9") != std::string::npos);
  CHECK(check.err.find("`bx` is no hole of `blast.holes`") != std::string::npos);
}

}  // namespace flyrock::measured_test
