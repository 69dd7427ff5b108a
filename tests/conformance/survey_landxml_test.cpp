// LandXML files as programs write them, compared with the ground that they were made from, and files that are
// wrong.

#include <algorithm>
#include <catch2/catch.hpp>

#include "samples.h"
#include "survey_of.h"
#include "surveyed_meshes.h"

using namespace flyrock;

namespace survey_landxml_test {

using namespace surveyed_meshes;

namespace {

/// `turn`: every third triangle is clockwise, and one more is hidden.
std::string surface_of(const Mesh& mesh, const std::string& name, double unit, bool turn = false) {
  std::string text = fmt::format("<Surface name=\"{}\"><Definition surfType=\"TIN\">\n<Pnts>\n", name);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Vec3 v = mesh.vertices[i] / unit;
    text += fmt::format("<P id=\"{}\">{:.17g} {:.17g}\n {:.17g}</P>\n", 10 * i + 7, v.y(), v.x(), v.z());
  }
  text += "</Pnts><!-- points above, faces below -->\n<Faces>\n";
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    auto corners = mesh.triangles[t];
    if (turn && t % 3 == 0) std::swap(corners[0], corners[1]);
    text += fmt::format("<F n=\"0 2 0\">{} {} {}</F>\n", 10 * corners[0] + 7, 10 * corners[1] + 7,
                        10 * corners[2] + 7);
  }
  if (turn) text += "<F i=\"1\">7 17 27</F>\n";
  return text + "</Faces></Definition></Surface>\n";
}

std::string landxml(const std::string& surfaces, const std::string& head = "") {
  return "<?xml version=\"1.0\"?>\n<LandXML xmlns=\"http://www.landxml.org/schema/LandXML-1.2\" "
         "version=\"1.2\">\n" +
         head + "<Surfaces>\n" + surfaces + "</Surfaces></LandXML>\n";
}

std::string landxml_error(const std::string& content, const SurveyKeys& keys = {}) {
  return survey_error("mesh", TemporaryFile("bad.xml", content), keys);
}

}  // namespace

TEST_CASE("a LandXML surface is the ground that it was made from, in metres and in feet") {
  const struct {
    std::string unit;
    double metres;
  } units[] = {{"", 1},
               {"<Units><Metric areaUnit=\"squareMeter\" linearUnit=\"meter\"/></Units>\n", 1},
               {"<Units><Imperial linearUnit=\"foot\"/></Units>\n", 0.3048},
               {"<Units><Imperial linearUnit=\"USSurveyFoot\"/></Units>\n", 1200. / 3937}};
  for (int seed = 0; seed < samples(100); ++seed) {
    CAPTURE(seed);
    RandomStream rng(static_cast<std::uint64_t>(seed), "landxml", {});
    const auto& unit = units[rng.integer(0, 3)];
    Mesh made = random_sheet(rng).mesh();
    for (Vec3& vertex : made.vertices) vertex += Vec3(600000, 200000, 0);
    const std::string system = "<CoordinateSystem epsgCode=\"2056\"/>\n";
    const TemporaryFile file(
        "ground.XML", landxml(surface_of(made, "pit", unit.metres, rng.uniform() < 0.5), unit.unit + system));
    const Survey read = survey_of("mesh", file.path);
    const Mesh& mesh = std::get<Mesh>(read.shape);
    CHECK(read.report.notes.size() == (unit.metres == 1 ? 0 : 1));
    REQUIRE(mesh.triangles.size() == made.triangles.size());
    CHECK(read.report.crs == (unit.metres == 1 ? "EPSG:2056" : ""));
    CHECK(read.report.is_converted == (unit.metres != 1));
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      Vec3 found = Vec3::Zero(), expected = Vec3::Zero();
      for (int k = 0; k < 3; ++k) {
        found += mesh.vertices[mesh.triangles[t][k]];
        expected += made.vertices[made.triangles[t][k]];
      }
      CHECK((found - expected).norm() / 3 < 1e-9);
    }
  }
}

TEST_CASE("of several surfaces of a LandXML file, `surface` names the ground") {
  Sheet sheet;
  const Mesh low = sheet.mesh();
  sheet.hill = 3;
  sheet.columns = 4;
  const std::string both =
      landxml(surface_of(low, "existing", 1) + surface_of(sheet.mesh(), "pit &amp; berm", 1));
  CHECK(
      landxml_error(both) ==
      " has 2 surfaces, `existing`, `pit & berm`: write `surface: existing` for the one that is the ground");
  CHECK(landxml_error(both, {{"surface", "pits"}}) ==
        " has no surface `pits`, it has `existing`, `pit & berm`");
  const TemporaryFile file("both.xml", both);
  CHECK(std::get<Mesh>(survey_of("mesh", file.path, {{"surface", "pit & berm"}}).shape).triangles.size() ==
        sheet.mesh().triangles.size());
  CHECK(survey_error("mesh", TemporaryFile("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n"),
                     {{"surface", "a"}}) ==
        " `surface` names one of LandXML (.xml), or a layer of a drawing (.dxf)");
}

TEST_CASE("a LandXML file that is cut at any byte is refused") {
  Sheet sheet;
  sheet.columns = sheet.rows = 1;
  const std::string whole = landxml(surface_of(sheet.mesh(), "pit", 1));
  REQUIRE(landxml_error(whole) == "no error");
  for (std::size_t size = 0; size + 2 < whole.size(); ++size) {
    CAPTURE(size);
    const std::string error = landxml_error(whole.substr(0, size));
    CHECK(error.find("is no complete XML") != error.npos);
    CHECK(error.find('\n') == error.npos);
  }
}

TEST_CASE("a malformed LandXML file is refused with its line") {
  const auto tin = [](const std::string& points, const std::string& faces, const std::string& type = "TIN") {
    return landxml(
        fmt::format("<Surface name=\"a\"><Definition surfType=\"{}\"><Pnts>\n"
                    "<P id=\"1\">0 0 0</P>\n<P id=\"2\">0 1 0</P>\n{}</Pnts><Faces>{}</Faces>"
                    "</Definition></Surface>",
                    type, points, faces));
  };
  const std::string third = "<P id=\"3\">1 1 0</P>\n", face = "<F>1 2 3</F>";
  REQUIRE(landxml_error(tin(third, face)) == "no error");
  const struct {
    std::string content, error;
    SurveyKeys keys = {};
  } cases[] = {
      {"<kml/>", "1: the first element is `kml`, expected `LandXML`"},
      {"<LandXML/>", " has no `Surface`, expected a TIN in `Surfaces`"},
      {landxml("", "<Units><Metric linearUnit=\"ell\"/></Units>\n"),
       "3: linearUnit is `ell`, expected meter, foot, USSurveyFoot or another unit of LandXML"},
      {tin(third, face, "grid"),
       "4: the surface is of the type `grid`, expected `TIN`: triangles with points"},
      {tin(third, ""), "4: the surface has no faces"},
      {tin("<P id=\"3\">1 1</P>\n", face), "7: `P` has 2 numbers, expected three: northing, easting, height"},
      {tin("<P id=\"3\">1 nan 0</P>\n", face), "7: `nan` is not a number"},
      {tin("<P id=\"2\">1 1 0</P>\n", face), "7: is the second point with the id `2`"},
      {tin(third, "\n<F>1 2 4</F>"), "9: the surface has no point `4`"},
      {tin(third, "<F>1 2 3 1</F>"), "8: `F` has 4 numbers, expected three: the ids of its points"},
      {tin(third, face), " in LandXML z is the height, leave `up` out", {{"up", "y"}}},
  };
  for (const auto& one : cases) CHECK(landxml_error(one.content, one.keys) == one.error);
}

}  // namespace survey_landxml_test
