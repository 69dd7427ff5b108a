// Measured holes: what their rocks read, where they leave, how they are ranked.

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/program.h"

namespace flyrock::holes_test {

namespace {

using namespace flyrock::test;
using Json = nlohmann::json;

std::vector<std::string> cut(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

/// The rows of rocks.csv by column.
std::vector<std::map<std::string, std::string>> rows_of(const Folder& folder, const std::string& out) {
  std::istringstream file(read(folder.path() / out / "rocks.csv"));
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> heads = cut(line);
  std::vector<std::map<std::string, std::string>> rows;
  while (std::getline(file, line)) {
    const std::vector<std::string> cells = cut(line);
    auto& row = rows.emplace_back();
    for (std::size_t i = 0; i < heads.size() && i < cells.size(); ++i) row[heads[i]] = cells[i];
  }
  return rows;
}

Json blast_of(const Folder& folder, const std::string& out) {
  return Json::parse(read(folder.path() / out / "summary.json"))["points"][0]["blast"];
}

void run_it(const Folder& folder, const std::string& scenario, const std::string& out = "out") {
  const Output run = call(folder, "run " + scenario + " --quiet --force -o " + out);
  INFO(run.err << run.out);
  REQUIRE(run.code == 0);
}

/// A scenario on level ground without air, with one launch.
std::string scenario_of(const std::string& blast, const std::string& launch, const std::string& more = "",
                        const std::string& count = "per_hole: 1") {
  return "flyrock: 1\ndimension: 2\nmethod: ballistic\ntrials: 3\nplugins: [own.lua]\n"
         "terrain: { type: profile, points: [[-1000, 0], [9000, 0]] }\nblast:\n"
         "  explosive: { density: 850 kg/m3, detonation_velocity: 4273 m/s }\n"
         "  rock_density: 2700 kg/m3\n  breakout_angle: 90 deg\n" +
         blast + "rocks:\n  - name: face\n    " + count +
         "\n    density: 2700\n    shape: { type: disk, radius: 0.1 }\n    release: { position: [0, 0] }\n"
         "    launch: " +
         launch + "\n" + more + "stop: { time: 300 s }\n";
}

const std::string own_model = R"(local fr = require "flyrock"
return fr.plugin {
  kind = "velocity", name = "own", doc = "Burden and charge of its hole.",
  reads = { "blast.burden", "blast.hole.diameter", "blast.explosive.density", "blast.hole.stemming" },
  launch = function(p, rock, blast, rng)
    local m = math.pi / 4 * blast.hole_diameter ^ 2 * blast.explosive_density
    local v = 20 * (math.sqrt(m) / blast.burden) ^ 1.3 + 0.1 * blast.hole_stemming
    return { velocity = { v, v } }
  end,
}
)";

}  // namespace

TEST_CASE("of two holes the one with half the burden throws by Richards and Moore") {
  const Folder folder;
  folder.write("own.lua", own_model);
  folder.write("s.yaml",
               scenario_of("  hole: { diameter: 102 mm }\n  holes:\n"
                           "    - { hole: whole, burden: 3 m, linear_charge: 7 kg/m }\n"
                           "    - { hole: half, burden: 1.5 m, charge: 35 kg, charge_length: 5 m }\n",
                           "{ type: richards_moore, k: 20 }", "gates: [{ name: road, x: 30 m }]\n"));
  run_it(folder, "s.yaml");
  for (const auto& row : rows_of(folder, "out")) {
    const double burden = row.at("hole") == "half" ? 1.5 : 3;
    CHECK(std::stod(row.at("launch_speed_m_s")) ==
          Approx(20 * std::pow(std::sqrt(7.0) / burden, 1.3)).epsilon(1e-9));
  }
  // v^2/g: 28.8 m of the whole burden, 175 m of the half one. All that passes the road is of the second hole.
  const Json risk = blast_of(folder, "out")["risk"];
  REQUIRE(risk.size() == 1);
  CHECK(risk[0]["of"] == "gate road");
  CHECK(risk[0]["rocks"] == 3);
  REQUIRE(risk[0]["holes"].size() == 1);
  CHECK(risk[0]["holes"][0]["hole"] == "half");
  CHECK(risk[0]["holes"][0]["share"] == 1.0);
}

TEST_CASE("each launch model reads its own hole as if it were the blast", "[slow]") {
  const std::string alone =
      "  hole: { diameter: 115 mm, stemming: 2.2 m, charge_length: 6 m, linear_charge: 8.1 kg/m }\n  burden: "
      "2.4 m\n";
  const std::string measured =
      "  hole: { diameter: 76 mm, stemming: 9 m, charge_length: 1 m }\n  burden: 5 m\n  holes:\n"
      "    - { burden: 3.1 m, stemming: 3 m, charge_length: 5 m }\n"
      "    - { diameter: 115 mm, stemming: 2.2 m, charge_length: 6 m, linear_charge: 8.1 kg/m, burden: 2.4 m "
      "}\n";
  const std::string launches[] = {
      "{ type: richards_moore, k: 20 }",
      "{ type: richards_moore, mode: cratering, k: 20 }",
      "{ type: richards_moore, mode: stemming_ejection, k: 20, drill_angle: 80 deg }",
      "{ type: gurney }",
      "{ type: bench_fit, rock: limestone }",
      "{ type: mckenzie }",
      "{ type: lundborg }",
      "{ type: own }"};
  const Folder folder;
  folder.write("own.lua", own_model);
  for (const std::string& launch : launches) {
    INFO(launch);
    folder.write("alone.yaml", scenario_of(alone, launch, "", "per_trial: 1"));
    folder.write("holes.yaml", scenario_of(measured, launch));
    run_it(folder, "alone.yaml", "alone");
    run_it(folder, "holes.yaml", "holes");
    const double wanted = std::stod(rows_of(folder, "alone").at(0).at("launch_speed_m_s"));
    const auto rows = rows_of(folder, "holes");
    CHECK(std::stod(rows.at(1).at("launch_speed_m_s")) == Approx(wanted).epsilon(1e-9));
    CHECK(std::stod(rows.at(0).at("launch_speed_m_s")) != Approx(wanted).epsilon(1e-3));
  }
}

TEST_CASE("holes are ranked by their share of the farthest rocks, and have their charge and powder factor") {
  const Folder folder;
  folder.write("own.lua", own_model);
  // Speeds depend on the burden alone, so the order of the ranges is that of the burdens. 3 trials of 4
  // rocks.
  folder.write(
      "s.yaml",
      scenario_of("  hole: { diameter: 100 mm, length: 10.5 m, subdrilling: 0.5 m, stemming: 2.5 m }\n"
                  "  spacing: 3 m\n  holes:\n"
                  "    - { hole: a, burden: 2.5 m }\n    - { hole: b, burden: 2 m, time: 25 ms }\n"
                  "    - { hole: c, burden: 1.5 m, stemming: 0.5 m, time: 50 ms }\n",
                  "{ type: richards_moore, k: 20 }", "clearance: [{ name: people, probability: 0.4 }]\n",
                  "per_hole: 4"));
  REQUIRE(call(folder, "run s.yaml --quiet --force --trials 30 -o out").code == 0);
  const Json blast = blast_of(folder, "out");
  REQUIRE(blast["risk"].size() == 1);
  const Json& risk = blast["risk"][0];
  CHECK(risk["of"] == "clearance people");
  CHECK(risk["holes"][0]["hole"] == "c");
  CHECK(risk["holes"][0]["rocks"] == 120);
  const double charge = M_PI / 4 * 0.01 * 850;
  CHECK(blast["measured"][0]["charge_kg"].get<double>() == Approx(8 * charge).epsilon(1e-12));
  CHECK(blast["measured"][2]["charge_kg"].get<double>() == Approx(10 * charge).epsilon(1e-12));
  CHECK(blast["measured"][1]["charge_to_mass"].get<double>() == Approx(charge / (2700 * 4)).epsilon(1e-12));
  CHECK(blast["measured"][1]["powder_factor_kg_m3"].get<double>() ==
        Approx(8 * charge / (2 * 3 * 10)).epsilon(1e-12));
  CHECK(blast["explosive_kg"].get<double>() == Approx(26 * charge).epsilon(1e-12));
  CHECK(blast["powder_factor_kg_m3"].get<double>() == Approx(26 * charge / (6 * 3 * 10)).epsilon(1e-12));
  CHECK(blast["last_hole_s"].get<double>() == Approx(0.05));
}

TEST_CASE("a table of holes says what the same list says, in any order of its columns") {
  const Folder folder;
  folder.write("own.lua", own_model);
  folder.write("holes.csv",
               "delay_ms;stemming [m];note;burden_m;hole;charge_kg_per_m;dip_deg\n"
               "17;2,2;wet;2,4;h 1;7,3;80\n34;;;2,9;h 2;7,1;\n");
  folder.write("other.csv", "B,S,id,q,t_s\n2.4,2.2,h 1,7.3,0.017\n2.9,,h 2,7.1,0.034\n");
  const std::string common = "  hole: { diameter: 102 mm, stemming: 2.6 m }\n  holes: ";
  folder.write("table.yaml", scenario_of(common + "{ file: holes.csv }\n", "{ type: own }"));
  folder.write("mapped.yaml",
               scenario_of(common + "{ file: other.csv, columns: { burden: B, stemming: S, hole: id, "
                                    "linear_charge: q, time: t_s } }\n",
                           "{ type: own }"));
  folder.write(
      "list.yaml",
      scenario_of(common + "\n    - { hole: h 1, burden: 2.4 m, stemming: 2.2 m, linear_charge: 7.3 kg/m, "
                           "time: 17 ms, dip: 80 deg }\n    - { hole: h 2, burden: 2.9 m, linear_charge: 7.1 "
                           "kg/m, time: 34 ms }\n",
                  "{ type: own }"));
  for (const char* name : {"table", "mapped", "list"}) run_it(folder, std::string(name) + ".yaml", name);
  CHECK(read(folder.path() / "table/rocks.csv") == read(folder.path() / "list/rocks.csv"));
  CHECK(rows_of(folder, "mapped")[1].at("runout_m") == rows_of(folder, "list")[1].at("runout_m"));
  const Output strict = call(folder, "check --strict table.yaml");
  CHECK(strict.code == 2);
  CHECK((strict.err + strict.out).find("the column `note`") != std::string::npos);
}

TEST_CASE("scatter is added to each hole of each trial, and shared by the rocks of the hole") {
  const Folder folder;
  folder.write("own.lua", own_model);
  folder.write(
      "s.yaml",
      scenario_of("  hole: { diameter: 102 mm }\n  holes:\n    - { burden: 3 m }\n    - { burden: 2 m "
                  "}\n  scatter: { burden: { uniform: [-0.5 m, 0.5 m] } }\n",
                  "{ type: richards_moore, k: 20 }", "", "per_hole: 2"));
  run_it(folder, "s.yaml");
  const double charge = M_PI / 4 * 0.102 * 0.102 * 850;
  std::map<std::string, double> burdens;
  for (const auto& row : rows_of(folder, "out")) {
    const double burden = std::sqrt(charge) / std::pow(std::stod(row.at("launch_speed_m_s")) / 20, 1 / 1.3);
    CHECK(std::abs(burden - (row.at("hole") == "1" ? 3 : 2)) <= 0.5);
    const auto [first, is_new] = burdens.emplace(row.at("trial") + " " + row.at("hole"), burden);
    if (!is_new) CHECK(burden == Approx(first->second).epsilon(1e-12));
  }
  CHECK(burdens.size() == 6);
}

TEST_CASE("rocks leave from the collar of their hole, and start when it goes off") {
  const Folder folder;
  const std::string head = "flyrock: 1\nmethod: nscd\ntrials: 1\n";
  const std::string tail =
      "rocks:\n  - name: top\n    per_hole: 1\n    mass: 10 kg\n    shape: SHAPE\n    launch: { type: "
      "fixed, speed: 5 m/s, elevation: 45 deg }\nstop: { time: 60 s }\noutput: { trajectories: { every: 1 s "
      "} }\n";
  const auto with_shape = [&](const char* shape) {
    std::string text = tail;
    return text.replace(text.find("SHAPE"), 5, shape);
  };
  const std::string materials =
      "materials: { rock: { restitution: { type: newton, en: 0 }, friction: { type: coulomb, mu: 0.6 } } }\n";
  folder.write("plane.yaml",
               head + materials +
                   "dimension: 2\nterrain: { type: profile, points: [[-50, 10], [50, 0], [60, 0]], "
                   "material: rock }\nblast: { holes: [{ x: -10 m, y: 77 m, time: 250 ms }, { x: 0 m, z: "
                   "9 m }] }\n" +
                   with_shape("{ type: disk, radius: 0.1 }"));
  folder.write("space.yaml",
               head + materials +
                   "dimension: 3\nterrain: { type: plane, material: rock }\nblast: { holes: [{ x: -10 m, "
                   "y: 7 m, time: 250 ms }, { x: 0 m, y: 3 m, z: 2 m }] }\n" +
                   with_shape("{ type: sphere, radius: 0.1 }"));
  for (const char* name : {"plane", "space"}) {
    INFO(name);
    run_it(folder, std::string(name) + ".yaml", name);
    const Output first =
        shell(folder, std::string("'" FLYROCK_BINARY "' export ") + name + " --to csv -o " + name + "_csv");
    INFO(first.err);
    CHECK(first.code == 0);
  }
  std::istringstream plane(read(folder.path() / "plane_csv/trajectories.csv"));
  std::string line;
  std::getline(plane, line);
  const std::vector<std::string> heads = cut(line);
  const auto column = [&](const std::string& name) {
    return static_cast<std::size_t>(std::find(heads.begin(), heads.end(), name) - heads.begin());
  };
  std::getline(plane, line);
  std::vector<std::string> row = cut(line);
  CHECK(std::stod(row.at(column("time_s"))) == Approx(0.25));
  CHECK(std::stod(row.at(column("x_m"))) == Approx(-10));
  // On a slope of 1 in 10: the disk touches it.
  CHECK(std::stod(row.at(column("y_m"))) == Approx(6 + 0.1 * std::sqrt(1.01)).margin(1e-6));
  while (std::getline(plane, line) && cut(line).at(column("rock")) != "1") {
  }
  CHECK(std::stod(cut(line).at(column("time_s"))) == 0);
  // The collar lies 4 m above the ground at 5 m.
  CHECK(std::stod(cut(line).at(column("y_m"))) == Approx(9 + 0.1 * std::sqrt(1.01)).margin(1e-6));
}

TEST_CASE("a thousand holes are read in less than a second") {
  const Folder folder;
  folder.write("own.lua", own_model);
  std::string table = "hole,x_m,y_m,burden_m,stemming_m,charge_kg_per_m,time_ms\n";
  for (int i = 0; i < 1000; ++i)
    table += std::to_string(i) + "," + std::to_string(-3 - i / 50) + "," + std::to_string(i % 50) + ",2." +
             std::to_string(i % 10) + ",2.5,7.1," + std::to_string(17 * i) + "\n";
  folder.write("holes.csv", table);
  folder.write("s.yaml",
               scenario_of("  hole: { diameter: 102 mm }\n  holes: { file: holes.csv }\n", "{ type: own }"));
  const auto start = std::chrono::steady_clock::now();
  CHECK(call(folder, "check s.yaml").code == 0);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  CHECK(spent.count() < 3);  // the program and its plugins included; a busy machine
}

TEST_CASE("branches happen as often as they should, and say what a branch does") {
  const Folder folder;
  folder.write("own.lua", own_model);
  folder.write(
      "s.yaml",
      scenario_of("  hole: { diameter: 102 mm, stemming: 2.5 m }\n  holes:\n    - { burden: 3 m }\n    - { "
                  "burden: 2.5 m, stemming: 2 m }\n",
                  "{ type: own }",
                  "branches:\n"
                  "  - { name: void, probability: 0.1, set: { blast.burden: 1 m } }\n"
                  "  - { name: wet, probability: 0.2, per: blast, set: { blast.hole.stemming: 1 m } }\n"
                  "gates: [{ name: road, x: 200 m }]\n"));
  const Output run = call(folder, "run s.yaml --quiet --force -o out --trials 2000");
  INFO(run.err);
  REQUIRE(run.code == 0);
  const double charge = M_PI / 4 * 0.102 * 0.102 * 850;
  std::map<std::string, int> blasts_of_wet;
  int voids = 0, rocks = 0;
  for (const auto& row : rows_of(folder, "out")) {
    ++rocks;
    const std::string branch = row.at("branch");
    const double burden = branch == "void" ? 1 : row.at("hole") == "1" ? 3 : 2.5;
    const double stemming = branch == "wet" ? 1 : row.at("hole") == "1" ? 2.5 : 2;
    const double v = 20 * std::pow(std::sqrt(charge) / burden, 1.3) + 0.1 * stemming;
    CHECK(std::stod(row.at("launch_speed_m_s")) == Approx(std::sqrt(2.0) * v).epsilon(1e-9));
    voids += branch == "void";
    if (branch == "wet") ++blasts_of_wet[row.at("trial")];
  }
  for (const auto& [trial, count] : blasts_of_wet) CHECK(count == 2);  // all holes of the blast
  const Json point = Json::parse(read(folder.path() / "out/summary.json"))["points"][0];
  const Json branches = point["branches"];
  REQUIRE(branches.size() == 3);
  CHECK(branches[0]["branch"] == "regular");
  CHECK(branches[0]["probability"].get<double>() == Approx(0.7));
  CHECK(branches[1]["units"] == voids);
  CHECK(branches[2]["units"] == blasts_of_wet.size());
  CHECK(branches[1]["share"].get<double>() == Approx(voids / 4000.0));
  // Binomials: 4000 holes at 0.1, 2000 blasts at 0.2; four standard deviations.
  CHECK(std::abs(voids / 4000.0 - 0.1) < 4 * std::sqrt(0.1 * 0.9 / 4000));
  CHECK(std::abs(static_cast<double>(blasts_of_wet.size()) / 2000 - 0.2) < 4 * std::sqrt(0.2 * 0.8 / 2000));
  // Only the void reaches the road; of the regular holes none: 1 - 0.025^(1/n).
  for (const Json& risk : branches[0]["risk"])
    if (risk["of"] == "gate road") {
      CHECK(risk["units"] == 0);
      CHECK(risk["interval"][1].get<double>() ==
            Approx(1 - std::pow(0.025, 1 / branches[0]["units"].get<double>())).epsilon(1e-9));
    }
  CHECK(branches[1]["risk"][0]["units"] == voids);
  CHECK(rocks == 4000);
}

TEST_CASE("branches do not change what is regular") {
  const Folder folder;
  folder.write("own.lua", own_model);
  const std::string blast =
      "  hole: { diameter: 102 mm, stemming: { uniform: [2 m, 3 m] } }\n  burden: { uniform: [2 m, 3 m] }\n  "
      "rows: { "
      "holes: 4 }\n";
  folder.write("without.yaml", scenario_of(blast, "{ type: own }", "", "per_trial: 4"));
  folder.write(
      "with.yaml",
      scenario_of(blast, "{ type: own }",
                  "branches: [{ name: failed, probability: 0.3, set: { blast.hole.stemming: 0.5 m } }]\n",
                  "per_trial: 4"));
  for (const char* name : {"without", "with"}) {
    const Output run =
        call(folder, std::string("run ") + name + ".yaml --quiet --force --trials 50 -o " + name);
    INFO(run.err);
    REQUIRE(run.code == 0);
  }
  const auto plain = rows_of(folder, "without"), rows = rows_of(folder, "with");
  REQUIRE(plain.size() == rows.size());
  int failed = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool is_regular = rows[i].at("branch") == "regular";
    failed += !is_regular;
    CHECK((rows[i].at("launch_speed_m_s") == plain[i].at("launch_speed_m_s")) == is_regular);
  }
  CHECK(failed > 20);
}

TEST_CASE("the face of a blast gives the burdens of its front row") {
  const Folder folder;
  folder.write("own.lua", own_model);
  // A face that leans by 0.35 m per m, through x = 0 at the crest. A hole 2.7 m behind it, its charge
  // from 2.3 m on.
  std::string points = "x_m,y_m,z_m\n", profile = "hole,depth,distance\n";
  for (int i = 0; i <= 40; ++i)
    for (int k = 0; k <= 60; ++k)
      points += std::to_string(0.35 * 0.2 * k) + "," + std::to_string(0.5 * i - 10) + "," +
                std::to_string(-0.2 * k) + "\n";
  for (int k = 0; k <= 12; ++k)
    profile += "1," + std::to_string(k) + "," + std::to_string(2.7 + 0.35 * k) + "\n";
  folder.write("points.csv", points);
  folder.write("profile.csv", profile);
  folder.write("face.obj", "v 0 -10 0\nv 0 10 0\nv 4.2 10 -12\nv 4.2 -10 -12\nf 1 4 3\nf 1 3 2\n");
  folder.write("track.csv", "hole,depth,x,y,z\n1,0,-2.7,0,0\n1,2.3,-2.7,0,-2.3\n1,11,-1.0,0,-11\n");
  const auto with_face = [&](const std::string& face, const std::string& more) {
    return "flyrock: 1\ndimension: 3\nmethod: ballistic\nplugins: [own.lua]\nterrain: { type: plane "
           "}\nblast:\n"
           "  explosive: ANFO\n  hole: { diameter: 102 mm, length: 10.6 m, stemming: 2.3 m }\n"
           "  burden: 9 m\n  holes:\n    - { hole: 1, x: -2.7 m, y: 0 m, z: 0 m" +
           more +
           " }\n"
           "    - { hole: 2, row: 2, x: -6 m, y: 0 m, z: 0 m, burden: 3.3 m }\n  face: " +
           face +
           "\nrocks:\n  - name: face\n    per_hole: 1\n    density: 2700\n    shape: { type: sphere, radius: "
           "0.1 }\n"
           "    launch: { type: own3 }\nstop: { time: 60 s }\n";
  };
  std::string model = own_model;
  model.replace(model.find("\"own\""), 5, "\"own3\"");
  model.replace(model.find("{ v, v }"), 8, "{ v, 0, v }");
  folder.write("own.lua", model);
  const double lean = 1 / std::sqrt(1 + 0.35 * 0.35);
  const struct {
    const char *face, *more;
    double burden;
  } cases[] = {{"{ mesh: face.obj }", "", (2.7 + 0.35 * 2.3) * lean},
               {"{ points: points.csv }", "", (2.7 + 0.35 * 2.3) * lean},
               {"{ profiles: profile.csv }", "", (2.7 + 0.35 * 2.3) * lean},
               // Along the face: the same distance at each depth.
               {"{ mesh: face.obj }", ", dip: 70.70995 deg, azimuth: 0 deg", 2.7 * lean},
               {"{ mesh: face.obj, track: track.csv }", "", (2.7 + 0.35 * 2.3) * lean}};
  for (const auto& [face, more, burden] : cases) {
    INFO(face << more);
    folder.write("s.yaml", with_face(face, more));
    run_it(folder, "s.yaml");
    const Json blast = blast_of(folder, "out");
    CHECK(blast["measured"][0]["burden_m"].get<double>() == Approx(burden).epsilon(1e-6));
    CHECK(blast["measured"][1]["burden_m"] == 3.3);
    CHECK(blast["face"]["burdens"].size() == 1);
    // The model reads it.
    const double charge = M_PI / 4 * 0.102 * 0.102 * 850;
    const double v = 20 * std::pow(std::sqrt(charge) / burden, 1.3) + 0.1 * 2.3;
    CHECK(std::stod(rows_of(folder, "out")[0].at("launch_speed_m_s")) ==
          Approx(std::sqrt(2.0) * v).epsilon(1e-5));
  }
  // The survey ends 3 m below the crest.
  folder.write("face.obj", "v 0 -10 0\nv 0 10 0\nv 1.05 10 -3\nv 1.05 -10 -3\nf 1 4 3\nf 1 3 2\n");
  folder.write("s.yaml", with_face("{ mesh: face.obj }", ""));
  const Output check = call(folder, "check s.yaml");
  CHECK(check.code == 0);
  CHECK((check.out + check.err).find("the survey ends beside hole 1, at depths of ") != std::string::npos);
}

TEST_CASE("check says which settings of a branch nothing reads") {
  const Folder folder;
  folder.write("own.lua", own_model);
  folder.write("s.yaml",
               scenario_of("  hole: { diameter: 102 mm }\n  holes: [{ burden: 3 m }]\n",
                           "{ type: richards_moore, k: 20 }",
                           "branches: [{ name: wet, probability: 0.1, set: { blast.hole.stemming: 1 m, "
                           "blast.burden: 2 m } }]\n"));
  const Output strict = call(folder, "check --strict s.yaml");
  CHECK(strict.code == 2);
  CHECK((strict.out + strict.err).find("branches.wet: blast.hole.stemming (") != std::string::npos);
  CHECK((strict.out + strict.err).find("branches.wet: blast.burden") == std::string::npos);
}

TEST_CASE("a column or key is named as not used only if nothing that decides a throw follows from it") {
  // A face 3 m in front of holes that lean to it.
  std::string face = "x,y,z\n";
  for (int y = -12; y <= 12; y += 2)
    for (int z = -2; z <= 14; ++z) face += "3," + std::to_string(y) + "," + std::to_string(z) + "\n";
  const std::string full =
      "hole,x_m,y_m,z_m,length_m,stemming_m,dip_deg,bearing_deg\n1,0,-2,12,12.4,2.5,80,90\n"
      "2,0,2,12,12.4,2.5,80,90\n";
  struct Case {
    const char* name;
    std::string blast, holes;
    std::vector<std::string> not_used;
  };
  const std::string explosive = "  explosive: ANFO\n", diameter = "  hole: { diameter: 102 mm }\n";
  const std::vector<Case> cases = {
      {"the face reads the axis of the charge", diameter + "  face: { points: face.csv }\n", full, {}},
      {"with a burden of their own nobody reads the axis",
       diameter + "  burden: 3 m\n",
       full,
       {"the column `length` (gurney", "the column `stemming` (gurney", "the column `dip` (gurney",
        "the column `bearing` (gurney"}},
      {"the face gives the burdens",
       diameter + "  burden: 3 m\n  face: { points: face.csv }\n",
       full,
       {"blast.burden (blast.face gives the burdens)"}},
      {"a charge takes its length from the table",
       diameter + "  burden: 3 m\n",
       "hole,x_m,y_m,charge_kg,charge_length_m\n1,0,-2,60,9\n2,0,2,50,9\n",
       {}},
      {"a charge takes its length from the blast",
       "  hole: { diameter: 102 mm, length: 12.6 m, stemming: 2.5 m }\n  burden: 3 m\n",
       "hole,x_m,y_m,charge_kg\n1,0,-2,60\n2,0,2,50\n",
       {}},
      {"burdens at crest and toe take the depth of the charge",
       diameter,
       "hole,x_m,y_m,burden_crest_m,burden_toe_m,length_m,stemming_m,subdrilling_m\n1,0,-2,3,4,12,2.5,1\n"
       "2,0,2,3,3.5,12,2.5,1\n",
       {}},
      {"each hole has its own burden",
       diameter + "  burden: 3 m\n",
       "hole,x_m,y_m,burden_m\n1,0,-2,2.5\n2,0,2,3.5\n",
       {"blast.burden (each of the holes has its own)"}},
      {"the charge decides the density of the explosive",
       "  hole: { diameter: 102 mm, charge_length: 9 m }\n  burden: 3 m\n",
       "hole,x_m,y_m,charge_kg,linear_charge\n1,0,-2,60,6\n2,0,2,50,6\n",
       {"blast.hole.charge_length (gurney", "the column `charge` (gurney"}},
  };
  for (const Case& c : cases) {
    INFO(c.name);
    const Folder folder;
    folder.write("face.csv", face);
    folder.write("holes.csv", c.holes);
    folder.write(
        "s.yaml",
        "flyrock: 1\ndimension: 3\nmethod: ballistic\ntrials: 4\n"
        "terrain: { type: benches, count: 1, height: 12 m, face_angle: 89 deg, berm: 0 m, top: 200 m, "
        "floor: 900 m, length: 1500 m }\nblast:\n  spacing: 4 m\n  rock_density: 2700 kg/m3\n"
        "  breakout_angle: 90 deg\n  holes: { file: holes.csv }\n" +
            explosive + c.blast +
            "rocks:\n  - { name: r, per_hole: 2, density: 2700, shape: { type: sphere, radius: 0.1 }, "
            "release: { from: face, bench: 1 }, launch: { type: gurney, elevation: 20 deg, azimuth: 0 deg } "
            "}\nstop: { time: 60 s }\n");
    const Output checked = call(folder, "check s.yaml");
    INFO(checked.out << checked.err);
    CHECK(checked.code == 0);
    std::size_t lines = 0;
    for (std::size_t at = checked.out.find("not used: "); at != std::string::npos;
         at = checked.out.find("not used: ", at + 1))
      ++lines;
    CHECK(lines == c.not_used.size());
    for (const std::string& entry : c.not_used) {
      INFO(entry);
      CHECK(checked.out.find(entry) != std::string::npos);
    }
    CHECK(call(folder, "check s.yaml --strict").code == (c.not_used.empty() ? 0 : 2));
  }
}

TEST_CASE("a measured charge without its length is an error where a model reads what follows from it") {
  const Folder folder;
  folder.write("own.lua", own_model);
  folder.write("holes.csv", "hole,x_m,burden_m,charge_kg\nA1,0,3,72.5\nA2,3,2.9,71\n");
  const std::string blast = "  hole: { diameter: 102 mm }\n  holes: { file: holes.csv }\n";
  folder.write("s.yaml", scenario_of(blast, "{ type: gurney, elevation: 30 deg }"));
  const Output refused = call(folder, "check s.yaml");
  CHECK(refused.code == 2);
  INFO(refused.err);
  CHECK(refused.err.find("hole A1 (and 1 more holes): its charge of 72.5 kg is given without its length") !=
        std::string::npos);
  // Whoever gives the length is heard, and a tenth of the charge throws less.
  const std::string with =
      scenario_of("  hole: { diameter: 102 mm, charge_length: 9 m }\n  holes: { file: holes.csv }\n",
                  "{ type: gurney, elevation: 30 deg }");
  folder.write("with.yaml", with);
  run_it(folder, "with.yaml", "much");
  folder.write("holes.csv", "hole,x_m,burden_m,charge_kg\nA1,0,3,7.25\nA2,3,2.9,7.1\n");
  run_it(folder, "with.yaml", "little");
  const auto speed = [&](const std::string& out) {
    return std::stod(rows_of(folder, out).front().at("launch_speed_m_s"));
  };
  CHECK(speed("little") < 0.5 * speed("much"));
}

}  // namespace flyrock::holes_test
