// Trees on the paths of rocks by all methods: energy, bytes of trees that take none, threads and shards.
#include <catch2/catch.hpp>
#include <map>
#include <sstream>
#include <vector>

#include "program.h"
#include "rows.h"

using namespace flyrock::test;

namespace {

/// Balls that fly and roll down a slope, through the wood that is given.
std::string slope(const std::string& method, const std::string& forest) {
  const std::string materials =
      "materials: { soil: { restitution: { type: newton, en: 0.5 }, friction: { type: coulomb, mu: 0.5 } } "
      "}\n";
  return "flyrock: 1\ndimension: 3\nmethod: " + method +
         "\ntrials: 40\nterrain:\n  type: plane\n  point: [0, 0, 0]\n  normal: [0.4, 0, 1]\n  material: "
         "soil\n"
         "  zones: [{ name: wood, polygon: [[2, -15], [60, -15], [60, 15], [2, 15]] }]\n" +
         materials +
         "rocks:\n  - { name: balls, density: 2600, shape: { type: sphere, radius: { uniform: [0.2, 0.5] } "
         "},\n"
         "      release: { along: [[0, -5, 3], [0, 5, 3]] },\n"
         "      launch: { type: fixed, speed: 14 m/s, elevation: 20 deg, spin: [0, 3, 1] } }\n" +
         forest + "stop: { time: 8 s }\n";
}

std::string trees(const std::string& law) {
  return "forest: { density: 0.05, diameter: { uniform: [20 cm, 50 cm] }, zone: wood, " + law + " }\n";
}

/// The rows of a table as numbers by column; texts are 0.
std::vector<std::map<std::string, double>> rows_of(const fs::path& file) {
  std::istringstream lines(read(file));
  std::string line, cell;
  std::vector<std::string> names;
  std::vector<std::map<std::string, double>> rows;
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    std::map<std::string, double> row;
    for (std::size_t i = 0; std::getline(cells, cell, ','); ++i) {
      if (names.size() <= i && rows.empty())
        names.push_back(cell);
      else
        row[names.at(i)] = std::strtod(cell.c_str(), nullptr);
    }
    if (!row.empty()) rows.push_back(row);
  }
  return rows;
}

const char* const methods[] = {"ballistic", "lumped_mass", "nscd"};

}  // namespace

TEST_CASE("a tree takes its energy of a rock, by every method", "[slow]") {
  const Folder folder;
  for (const char* method : methods) {
    INFO(method);
    folder.write("s.yaml", slope(method, trees("law: fixed, energy: 20 kJ, turn: 10 deg")));
    const Output run = call(folder, "run s.yaml --quiet --force -o out");
    INFO(run.err);
    REQUIRE(run.code == 0);
    REQUIRE(call(folder, "export out --to csv -o csv").code == 0);
    const auto hits = rows_of(folder.path() / "csv/trees.csv"),
               rocks = rows_of(folder.path() / "csv/rocks.csv");
    REQUIRE(hits.size() > 10);
    int stopped = 0;
    for (const auto& hit : hits) {
      const double before = hit.at("energy_before_J"), after = hit.at("energy_after_J");
      CHECK(before - after == Approx(std::min(before, 20000.0)).epsilon(1e-12));
      CHECK(hit.at("height_m") > 0);
      CHECK(hit.at("height_m") <= 20);
      stopped += after == 0;
    }
    CHECK(stopped > 0);
    CHECK(read(folder.path() / "out/summary.json").find("\"stopped\": " + std::to_string(stopped)) !=
          std::string::npos);
  }
}

TEST_CASE("trees that take no energy and turn no rock leave all other rows as they are, to the byte",
          "[slow]") {
  const Folder folder;
  for (const char* method : methods) {
    INFO(method);
    folder.write("none.yaml", slope(method, ""));
    folder.write("thin.yaml", slope(method, trees("energy_factor: 0")));
    REQUIRE(call(folder, "run none.yaml --quiet --force -o none").code == 0);
    REQUIRE(call(folder, "run thin.yaml --quiet --force -o thin").code == 0);
    for (const char* out : {"none", "thin"})
      REQUIRE(call(folder, std::string("export ") + out + " --to csv -o csv_" + out).code == 0);
    CHECK(rows_of(folder.path() / "csv_thin/trees.csv").size() > 10);
    CHECK(read(folder.path() / "thin/rocks.csv") == read(folder.path() / "none/rocks.csv"));
    for (const char* table : {"impacts", "trajectories"})
      CHECK(read(folder.path() / "csv_thin" / (std::string(table) + ".csv")) ==
            read(folder.path() / "csv_none" / (std::string(table) + ".csv")));
  }
}

TEST_CASE("trees give the same bytes over one and three threads, and merged from shards") {
  const Folder folder;
  folder.write("s.yaml", slope("nscd", trees("turn: { uniform: [-5 deg, 20 deg] }")));
  REQUIRE(call(folder, "run s.yaml --quiet -j 1 -o one").code == 0);
  REQUIRE(call(folder, "run s.yaml --quiet -j 3 -o three").code == 0);
  REQUIRE(call(folder, "run s.yaml --quiet --shard 1/2 -o a").code == 0);
  REQUIRE(call(folder, "run s.yaml --quiet --shard 2/2 -o b").code == 0);
  REQUIRE(call(folder, "merge a b -o merged").code == 0);
  for (const char* file : {"rocks.csv", "summary.json", "results.db"}) {
    CHECK(read(folder.path() / "three" / file) == read(folder.path() / "one" / file));
    CHECK(read(folder.path() / "merged" / file) == read(folder.path() / "one" / file));
  }
}

TEST_CASE("a malformed file of trees is refused with line and column") {
  const Folder folder;
  folder.write("s.yaml",
               slope("ballistic", "forest: { file: t.csv, species: [{ name: beech, factor: 1 }] }\n"));
  const auto says = [&](const std::string& text) {
    folder.write("t.csv", text);
    const Output check = call(folder, "check s.yaml");
    CHECK(check.code == 2);
    const std::size_t at = check.err.find("t.csv:");
    return at == std::string::npos ? check.err : check.err.substr(at, check.err.find('\n', at) - at);
  };
  const std::string header = "x,y,dbh_cm,height_m,species\n", where = "error: forest.file: ";
  CHECK(says("").find("forest.file: the file t.csv is empty") != std::string::npos);
  CHECK(says("x,y\n") == "t.csv:1:1: " + where + "no column is `dbh` (in m, or `dbh` with a unit)");
  CHECK(says(header + "1,2,30,20,beech\n\n1, 2, 3O, 20, beech\n") ==
        "t.csv:4:7: " + where + "`3O` is not a number, expected `dbh`");
  CHECK(says(header + "1,2,30\n") == "t.csv:2:1: " + where + "the line has 3 values, the heads are 5");
  CHECK(says(header + "1,2,30,20,beech\n1,2,-30,20,beech\n1,2,30,20,beech\n") ==
        "t.csv:3:5: " + where + "`dbh` is -0.3 m, expected 0.001 m to 10 m");
  CHECK(says(header + "1,2,30,20,baech\n") ==
        "t.csv:2:11: " + where + "`baech` is not a species of `forest.species`, did you mean `beech`?");
  // Metres under a head in centimetres, and centimetres under a head without unit.
  CHECK(says(header + "1,2,0.3,20,beech\n3,4,0.4,20,beech\n") ==
        "t.csv:2:5: " + where +
            "the median of `dbh` is 0.004 m, expected 0.02 m to 3 m of trees: name the unit of its numbers "
            "in its "
            "head, `dbh_cm` or `dbh_m`");
  CHECK(says("x,y,dbh,height\n1,2,35,20\n").find("the median of `dbh` is 35 m") != std::string::npos);
  folder.write("t.csv", "\xef\xbb\xbfx,y,dbh_cm,height_m\r\n5,0,30,20\r\n");
  CHECK(call(folder, "check s.yaml").code == 0);
}

TEST_CASE("a file of trees has its columns in any order, under other heads, with others between") {
  const Folder folder;
  const auto stems = [&](const std::string& keys, const std::string& text) {
    folder.write("s.yaml", slope("ballistic", "forest: { file: t.csv" + keys + " }\n"));
    folder.write("t.csv", text);
    const Output run = call(folder, "run s.yaml --quiet --trials 1 -o out --force");
    CHECK(run.err == "");
    REQUIRE(run.code == 0);
    return query(folder.path() / "out" / "results.db",
                 "SELECT x_m || ' ' || y_m || ' ' || round(diameter_m, 6) || ' ' || height_m FROM stems");
  };
  const std::vector<std::string> plain = stems("", "x,y,dbh_cm,height_m\n5,0.5,30,20\n");
  CHECK(stems("", "id;Height [m];North;East;DBH (mm);vigour\n7;20;0,5;5;300;good\n") == plain);
  CHECK(stems("", "d130_m\ty_m\tx_m\th\n0.3\t0.5\t5\t20\n") == plain);
  CHECK(stems(", columns: { dbh: BHD_2019_cm, height: top }", "top,BHD_2019_cm,x,y\n20,30,5,0.5\n") == plain);
}

TEST_CASE("trees of a file off the ground are counted, and refused if that is all of them") {
  const Folder folder;
  folder.write("s.yaml", slope("ballistic", "forest: { file: t.csv }\n"));
  folder.write("t.csv", "x,y,dbh_cm,height_m\n5,0,30,20\n2600000,1200000,30,20\n");
  Output check = call(folder, "check s.yaml");
  CHECK(check.code == 0);
  CHECK(check.err.find("1 of 2 trees have no ground below them, the first at (2600000, 1200000)") !=
        std::string::npos);
  folder.write("t.csv", "x,y,dbh_cm,height_m\n2600000,1200000,30,20\n");
  check = call(folder, "check s.yaml");
  CHECK(check.code == 2);
  CHECK(check.err.find("1 of 1 trees have no ground below them") != std::string::npos);
}
