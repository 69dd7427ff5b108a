#include "survey/projection_file.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "../../temporary_file.h"
#include "survey/well_known_text.h"

using namespace flyrock;

namespace projection_file_test {

const std::string degrees =
    R"(GEOGCS["GCS_NAD83",DATUM["D_NAD83",SPHEROID["GRS_1980",6378137.0,298.257222101]],PRIMEM["Greenwich",0.0],UNIT["Degree",0.0174532925199433]])";

/// A system in plan with a unit, as ESRI and GDAL write it.
std::string in_plan(const std::string& unit, const std::string& more = "") {
  return "PROJCS[\"Plan\"," + degrees +
         ",PROJECTION[\"Lambert_Conformal_Conic\"],PARAMETER[\"False_Easting\",1000000.0]," + unit + more +
         "]";
}

const std::string metre = R"(UNIT["Meter",1.0])", us_foot = R"(UNIT["Foot_US",0.3048006096012192])";

}  // namespace projection_file_test

using namespace projection_file_test;

TEST_CASE("units of places and heights are each those of their own system") {
  const Projection plan = projection_of(in_plan(us_foot) + R"(,VERTCS["h",VDATUM["d"],)" + metre + "]");
  CHECK(plan.plan_unit == "us_ft");
  CHECK(plan.height_unit == "m");
  const Projection heights = projection_of(in_plan(metre) + R"(,VERTCS["h",VDATUM["d"],)" + us_foot + "]");
  CHECK(heights.plan_unit == "m");
  CHECK(heights.height_unit == "us_ft");
  const Projection both =
      projection_of("COMPD_CS[\"both\"," + in_plan(metre, R"(,AUTHORITY["EPSG","2056"])") +
                    R"(,VERT_CS["h",VERT_DATUM["d",2005],UNIT["foot",0.3048]],AUTHORITY["EPSG","9999"]])");
  CHECK(both.plan_unit == "m");
  CHECK(both.height_unit == "ft");
  CHECK(both.crs == "EPSG:2056");
}

TEST_CASE("a projection in degrees is one in any words") {
  CHECK(projection_of(degrees).is_geographic);
  CHECK(
      projection_of(
          R"(GEOGCRS["ETRS89",DATUM["E",ELLIPSOID["GRS 1980",6378137,298.257,LENGTHUNIT["metre",1]]],CS[ellipsoidal,2],AXIS["latitude",north],AXIS["longitude",east],ANGLEUNIT["degree",0.0174532925199433],ID["EPSG",4258]])")
          .is_geographic);
  CHECK(projection_of("Projection GEOGRAPHIC\nDatum WGS84\nUnits DD\nZunits METERS\nParameters\n")
            .is_geographic);
  const Projection wkt2 = projection_of(
      R"p(PROJCRS["CH1903+",BASEGEOGCRS["b",DATUM["d",ELLIPSOID["e",6377397,299,LENGTHUNIT["metre",1]]]],CONVERSION["c",METHOD["m"],PARAMETER["p",0,ANGLEUNIT["degree",0.0174]]],CS[Cartesian,2],AXIS["(E)",east],AXIS["(N)",north],LENGTHUNIT["metre",1],ID["EPSG",2056]])p");
  CHECK_FALSE(wkt2.is_geographic);
  CHECK(wkt2.plan_unit == "m");
  CHECK(wkt2.crs == "EPSG:2056");
}

TEST_CASE("the keywords of ArcInfo give its feet, and what is not understood says so") {
  const Projection feet = projection_of(
      "Projection    STATEPLANE\r\nFipszone      0600\r\nUnits         FEET\r\nZunits        FEET\r\n");
  CHECK(feet.plan_unit == "us_ft");
  CHECK(feet.height_unit == "us_ft");
  CHECK(feet.fault.empty());
  CHECK(projection_of("Projection UTM\nZone 32\nUnits METERS\nZunits NO\n").plan_unit == "m");
  CHECK(projection_of("Projection UTM\nUnits RODS\n").fault.find("`Units RODS` is not known") !=
        std::string::npos);
  CHECK(projection_of("EPSG 2056").fault.find("neither well-known text") != std::string::npos);
  CHECK(projection_of(in_plan(R"(UNIT["Foot_Clarke",0.3047972654])"))
            .fault.find("unit `Foot_Clarke` of 0.3047972654 m") != std::string::npos);
  CHECK(projection_of("PROJCS[\"cut\",").fault.find("no well-known text") != std::string::npos);
}

TEST_CASE("a file .prj is found in any case of its ending") {
  const TemporaryFile grid("dem.asc", "");
  const std::filesystem::path beside = std::filesystem::path(grid.path).replace_extension(".PRJ");
  std::ofstream(beside) << in_plan(us_foot);
  CHECK(projection_beside(grid.path).plan_unit == "us_ft");
  std::filesystem::remove(beside);
  CHECK(projection_beside(grid.path).plan_unit.empty());
}
