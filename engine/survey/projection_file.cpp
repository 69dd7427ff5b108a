#include "survey/projection_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

#include "plugin/words.h"
#include "survey/well_known_text.h"
#include "units/units.h"

namespace flyrock {

namespace {

/// m, ft or us_ft; empty for another length [m].
std::string name_of_unit(double metres) {
  const auto is = [&](double unit) { return std::abs(metres - unit) < 1e-9; };
  return is(1) ? "m" : is(0.3048) ? "ft" : is(1200.0 / 3937.0) ? "us_ft" : "";
}

/// The node of the unit of a system: its own, or that of its axes; null: none.
const WktNode* unit_node(const WktNode& system) {
  if (const WktNode* unit = system.child({"UNIT", "LENGTHUNIT"})) return unit;
  for (const WktNode& child : system.children)
    if (child.keyword == "AXIS")
      if (const WktNode* unit = child.child({"UNIT", "LENGTHUNIT"})) return unit;
  return nullptr;
}

/// The unit of lengths of a system. What has another one has a fault.
std::string unit_of(const WktNode& system, const char* what, std::string& fault) {
  const WktNode* unit = unit_node(system);
  if (!unit) return {};
  double metres = 0;
  const bool is_number = unit->values.size() > 1 && to_number(unit->values[1], metres);
  const std::string name = is_number ? name_of_unit(metres) : "";
  if (name.empty())
    fault = fmt::format(
        "its {} are in the unit `{}`{}, expected metres, feet or US survey feet: project it first, "
        "for example with gdalwarp",
        what, unit->values.empty() ? "" : unit->values[0],
        is_number ? fmt::format(" of {:.10g} m", metres) : "");
  return name;
}

/// "EPSG:2056" of AUTHORITY["EPSG","2056"] or ID["EPSG",2056].
std::string code_of(const WktNode& system) {
  const WktNode* id = system.child({"AUTHORITY", "ID"});
  return id && id->values.size() > 1 && id->values[0] == "EPSG" ? "EPSG:" + id->values[1] : "";
}

bool is_in_plan(const WktNode& node) {
  return node.keyword == "PROJCS" || node.keyword == "PROJCRS" || node.keyword == "PROJECTEDCRS";
}
bool is_in_degrees(const WktNode& node) {
  return node.keyword == "GEOGCS" || node.keyword == "GEOGCRS" || node.keyword == "GEOGRAPHICCRS" ||
         node.keyword == "GEODCRS" || node.keyword == "GEODETICCRS";
}
bool is_of_heights(const WktNode& node) {
  return node.keyword == "VERT_CS" || node.keyword == "VERTCS" || node.keyword == "VERTCRS" ||
         node.keyword == "VERTICALCRS";
}

void take(const std::vector<WktNode>& nodes, Projection& projection) {
  for (const WktNode& node : nodes) {
    if (is_in_plan(node)) {
      projection.plan_unit = unit_of(node, "coordinates", projection.fault);
      projection.crs = code_of(node);
    } else if (is_in_degrees(node)) {
      projection.is_geographic = true;
      projection.crs = code_of(node);
    } else if (is_of_heights(node)) {
      projection.height_unit = unit_of(node, "heights", projection.fault);
    } else if (node.keyword == "COMPD_CS" || node.keyword == "COMPOUNDCRS" || node.keyword == "BOUNDCRS" ||
               node.keyword == "SOURCECRS") {
      take(node.children, projection);
    } else if (node.keyword == "LOCAL_CS" || node.keyword == "ENGCRS" || node.keyword == "ENGINEERINGCRS") {
      projection.plan_unit = unit_of(node, "coordinates", projection.fault);
    }
  }
}

/// A unit of ArcInfo, whose FEET are those of the US survey.
std::string arcinfo_unit(const std::string& word) {
  const std::string name = lower(word);
  if (name == "meters" || name == "metres" || name == "m") return "m";
  if (name == "feet" || name == "us_feet" || name == "us_foot") return "us_ft";
  if (name == "int_feet" || name == "international_feet") return "ft";
  double per_metre = 0;  // a number is units in a metre
  return to_number(word, per_metre) && per_metre > 0 ? name_of_unit(1 / per_metre) : "";
}

/// Lines of a keyword and its value: `Units FEET`.
Projection read_keywords(const std::string& text) {
  std::map<std::string, std::string> values;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string key, value;
    if (words >> key >> value) values.emplace(lower(key), value);
  }
  Projection projection;
  if (!values.contains("projection")) {
    projection.fault = "it is neither well-known text nor has it the keywords of ArcInfo";
    return projection;
  }
  const std::string units = lower(values["units"]);
  projection.is_geographic =
      lower(values["projection"]) == "geographic" || units == "dd" || units == "ds" || units == "dms";
  if (!projection.is_geographic) projection.plan_unit = arcinfo_unit(values["units"]);
  if (!projection.is_geographic && projection.plan_unit.empty())
    projection.fault = fmt::format("its `Units {}` is not known, expected METERS or FEET", values["units"]);
  const std::string heights = lower(values["zunits"]);
  if (!heights.empty() && heights != "no") projection.height_unit = arcinfo_unit(values["zunits"]);
  return projection;
}

}  // namespace

Projection projection_of(const std::string& text) {
  if (text.find_first_of("[(") == text.npos) return read_keywords(text);
  Projection projection;
  take(read_well_known_text(text), projection);
  const bool is_known = projection.is_geographic || !projection.plan_unit.empty();
  if (!is_known && projection.fault.empty())
    projection.fault = "it is no well-known text of a system in metres, feet or degrees";
  return projection;
}

Projection projection_beside(const std::string& grid) {
  const std::filesystem::path path(grid);
  const std::filesystem::path folder =
      path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  std::vector<std::filesystem::path> found;
  std::error_code code;
  for (const auto& entry : std::filesystem::directory_iterator(folder, code))
    if (entry.path().stem() == path.stem() && lower(entry.path().extension().string()) == ".prj")
      found.push_back(entry.path());
  if (found.empty()) return {};
  std::ifstream file(*std::max_element(found.begin(), found.end()), std::ios::binary);  // .prj before .PRJ
  constexpr std::size_t longest = 100'000;
  std::string text;
  for (std::istreambuf_iterator<char> c(file), end; c != end && text.size() < longest; ++c) text += *c;
  return projection_of(text);
}

}  // namespace flyrock
