// docs/your-own-terrain.md, from a workbook and a GeoPackage to the page of a permit.

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "../geopackage.h"
#include "../workbook_file.h"
#include "cli/program.h"

namespace flyrock::plan_page_test {

namespace {

using namespace flyrock::test;
using Json = nlohmann::json;

const std::vector<std::vector<std::string>> holes = {
    {"hole", "row", "x (m)", "y (m)", "z (m)", "length (m)", "subdrilling (m)", "stemming (m)",
     "linear_charge_kg_per_m", "burden (m)", "time_ms"},
    {"1", "1", "-2.9", "-6.4", "12", "12.7", "0.7", "2.3", "7.1", "2.9", "0"},
    {"2", "1", "-2.7", "-3.2", "12", "12.6", "0.7", "2.1", "7.0", "2.7", "17"},
    {"3", "1", "-2.5", "0", "12", "12.7", "0.7", "2.2", "7.2", "2.5", "34"},
    {"4", "1", "-2.8", "3.2", "12", "12.6", "0.7", "1.9", "7.0", "2.8", "51"}};

const std::vector<geopackages::Line> roads = {{"haul", {{90, -200}, {80, 0}, {95, 200}}},
                                              {"public", {{160, -300}, {150, 300}}}};

std::string points_of(const geopackages::Line& line) {
  std::string text;
  for (const auto& point : line.points)
    text += fmt::format("{}[{}, {}]", text.empty() ? "" : ", ", point[0], point[1]);
  return "[" + text + "]";
}

/// The block of the page that begins with a line.
std::string block_of(const std::string& page, const std::string& first_line) {
  const std::size_t begin = page.find("\n" + first_line + "\n");
  REQUIRE(begin != std::string::npos);
  return page.substr(begin + 1, page.find("\n```", begin) - begin - 1);
}

/// The scenario with what the plan says written into it.
std::string written_out(std::string text) {
  const std::string sheet = "\"plan.xlsx#Holes\"";
  text.replace(text.find(sheet), sheet.size(), "holes.csv");
  const std::size_t begin = text.find("  - name: road"), end = text.find("clearance:");
  const std::string entry = text.substr(begin, end - begin);
  std::string entries;
  for (const geopackages::Line& road : roads) {
    std::string one = entry;
    one.replace(one.find("road"), 4, "road_" + road.id);
    const std::size_t layer = one.find("{ layer:");
    one.replace(layer, one.find('}', layer) + 1 - layer, points_of(road));
    entries += one;
  }
  return text.replace(begin, end - begin, entries);
}

}  // namespace

TEST_CASE("a workbook and a GeoPackage lead to the page of a permit, as your-own-terrain.md says", "[slow]") {
  const fs::path bin = fs::path(FLYROCK_BINARY).parent_path();
  if (skips_without_gdal()) return;
  const Folder folder;
  const std::string page = read(FLYROCK_SOURCE_DIR "/docs/your-own-terrain.md");
  const std::string scenario = block_of(page, "# blast_24.yaml");
  folder.write("blast_24.yaml", scenario);
  folder.write("plan.xlsx", workbooks::xlsx_of({{"Notes", workbooks::xlsx_sheet({{"made up"}})},
                                                {"Holes", workbooks::xlsx_sheet(holes)}}));
  geopackages::write_lines(folder.path() / "pit.gpkg", "roads", roads);
  const Output page_run = shell(
      folder, "PATH='" + bin.string() + "':$PATH; set -e\n" + block_of(page, "flyrock check blast_24.yaml"));
  INFO(page_run.out << page_run.err);
  REQUIRE(page_run.code == 0);
  CHECK(page_run.out.find("holes of plan.xlsx#Holes: 4 rows") != std::string::npos);
  CHECK(page_run.out.find("layer roads of pit.gpkg: 3 points, no system of its own") != std::string::npos);

  std::string csv;
  for (const auto& row : holes) csv += fmt::format("{}\n", fmt::join(row, ","));
  folder.write("holes.csv", csv);
  folder.write("written.yaml", written_out(scenario));
  const Output written = call(folder, "run written.yaml --quiet -o written");
  INFO(written.err);
  REQUIRE(written.code == 0);
  const auto point_of = [&](const std::string& out) {
    return Json::parse(read(folder.path() / out / "summary.json"))["points"][0];
  };
  const Json found = point_of("out/blast_24"), expected = point_of("written");
  CHECK(found["questions"].size() == 4);  // the distance, the customary one, two roads
  CHECK(found["questions"] == expected["questions"]);
  CHECK(found["exposure"] == expected["exposure"]);
  const std::string report = read(folder.path() / "out/blast_24/report.html");
  for (const geopackages::Line& road : roads) CHECK(report.find("road_" + road.id) != std::string::npos);
}

}  // namespace flyrock::plan_page_test
