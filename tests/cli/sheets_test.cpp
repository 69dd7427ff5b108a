// Tables in workbooks: the same scenario with a CSV file, a sheet of xlsx and one of ods.

#include <catch2/catch.hpp>

#include "../workbook_file.h"
#include "cli/program.h"

namespace flyrock::sheets_test {

namespace {

using namespace flyrock::test;
using namespace workbooks;

const std::vector<std::vector<std::string>> hole_rows = {
    {"Hole ID", "x (m)", "y (m)", "Burden (m)", "delay_ms"},
    {"1", "0", "0", "3", "0"},
    {"2", "0", "3.2", "2.9", "17"},
    {"3", "0", "6.4", "1.9", "34"}};

std::string csv_of(const std::vector<std::vector<std::string>>& rows) {
  std::string text;
  for (const auto& row : rows) text += fmt::format("{}\n", fmt::join(row, ","));
  return text;
}

std::string ods_sheet(const std::string& name, const std::vector<std::vector<std::string>>& rows) {
  std::string table = "<table:table table:name=\"" + name + "\">";
  for (const auto& row : rows) {
    table += "<table:table-row>";
    for (const std::string& cell : row)
      table +=
          "<table:table-cell office:value-type=\"string\"><text:p>" + cell + "</text:p></table:table-cell>";
    table += "</table:table-row>";
  }
  return table + "</table:table>";
}

std::string scenario(const std::string& holes, const std::string& terrain = "points: [[-200, 0], [900, 0]]",
                     const std::string& more = "") {
  return "flyrock: 1\ndimension: 2\nmethod: ballistic\ntrials: 5\nterrain: { type: profile, " + terrain +
         " }\nblast:\n  explosive: ANFO\n  hole: { diameter: 102 mm, length: 12 m, stemming: 2.6 m }\n"
         "  burden: 3 m\n  spacing: 3.2 m\n  rock_density: 2700 kg/m3\n  breakout_angle: 90 deg\n"
         "  holes: { file: \"" +
         holes +
         "\" }\nrocks:\n  - name: face\n    per_hole: 3\n    density: 2700 kg/m3\n"
         "    shape: { type: disk, radius: 0.1 m }\n    release: { position: [0, 1] }\n"
         "    launch: { type: gurney, elevation: 30 deg }\nstop: { time: 60 s }\n" +
         more;
}

}  // namespace

TEST_CASE("holes, profiles and points of a sweep say the same as sheets and as CSV") {
  const Folder folder;
  const std::vector<std::vector<std::string>> section = {{"x", "height"}, {"-200", "0.5"}, {"900", "0"}};
  const std::vector<std::vector<std::string>> designs = {
      {"label", "blast.hole.diameter [mm]"}, {"a", "102"}, {"b", "89"}};
  folder.write("holes.csv", csv_of(hole_rows));
  folder.write("section.csv", csv_of(section));
  folder.write("designs.csv", csv_of(designs));
  const Parts sheets = {
      {"Holes", xlsx_sheet(hole_rows)}, {"A", xlsx_sheet(section)}, {"Designs", xlsx_sheet(designs)}};
  folder.write("pit.xlsx", xlsx_of(sheets));
  folder.write("pit.ods", ods_of(ods_sheet("Holes", hole_rows) + ods_sheet("A", section) +
                                 ods_sheet("Designs", designs)));
  folder.write("csv.yaml", scenario("holes.csv", "file: section.csv", "sweep: { table: designs.csv }\n"));
  REQUIRE(call(folder, "run csv.yaml --quiet -o csv").code == 0);
  for (const std::string kind : {"xlsx", "ods"}) {
    const std::string book = "pit." + kind;
    folder.write(kind + ".yaml", scenario(book + "#Holes", "file: " + book + "#A",
                                          "sweep: { table: " + book + "#Designs }\n"));
    const Output run = call(folder, "run " + kind + ".yaml --quiet -o " + kind);
    INFO(kind << run.err);
    REQUIRE(run.code == 0);
    CHECK(read(folder.path() / kind / "rocks.csv") == read(folder.path() / "csv/rocks.csv"));
    CHECK(read(folder.path() / kind / "manifest.json").find("\"" + book + "\"") != std::string::npos);
  }
  CHECK(call(folder, "check xlsx.yaml").out.find("holes of pit.xlsx#Holes: 3 rows;") != std::string::npos);
}

TEST_CASE("a fault in a sheet is one line with file, sheet and row, and exit code 2") {
  const Folder folder;
  auto rows = hole_rows;
  rows[2][3] = "wide";
  folder.write("holes.xlsx", xlsx_of({{"Holes", xlsx_sheet(rows)}}));
  folder.write("s.yaml", scenario("holes.xlsx#Holes"));
  const Output wide = call(folder, "check s.yaml");
  CHECK(wide.code == 2);
  INFO(wide.err);
  CHECK(wide.err.find("holes.xlsx#Holes:3:") != std::string::npos);
  CHECK(wide.err.find("`wide` is not a number, expected `burden`") != std::string::npos);
  folder.write("s.yaml", scenario("holes.xlsx#Hols"));
  const Output misspelt = call(folder, "check s.yaml");
  CHECK(misspelt.code == 2);
  CHECK(misspelt.err.find("has no sheet `Hols`, did you mean `Holes`?") != std::string::npos);
  folder.write("s.yaml", scenario("none.xlsx#Holes"));
  CHECK(call(folder, "check s.yaml").err.find("there is no file `none.xlsx` in the scenario's folder") !=
        std::string::npos);
}

TEST_CASE("a workbook outside of the folder is refused by --confined") {
  const Folder folder;
  folder.write("holes.xlsx", xlsx_of({{"Holes", xlsx_sheet(hole_rows)}}));
  std::filesystem::create_directory(folder.path() / "inner");
  folder.write("inner/s.yaml", scenario("../holes.xlsx#Holes"));
  CHECK(call(folder, "check inner/s.yaml").code == 0);
  const Output confined = call(folder, "check --confined inner/s.yaml");
  CHECK(confined.code == 2);
  CHECK(confined.err.find("is outside of the scenario's folder, which --confined refuses") !=
        std::string::npos);
}

}  // namespace flyrock::sheets_test
