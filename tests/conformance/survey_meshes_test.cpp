// Meshes as programs of surveys write them, compared with the ground that they were made from.

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <fstream>

#include "samples.h"
#include "survey_of.h"
#include "surveyed_meshes.h"

using namespace flyrock;

namespace survey_meshes_test {

using namespace surveyed_meshes;

namespace {

Mesh mesh_of(const TemporaryFile& file, const SurveyKeys& keys = {}) {
  return std::get<Mesh>(survey_of("mesh", file.path, keys).shape);
}

std::vector<std::string> notes_of(const TemporaryFile& file, const SurveyKeys& keys = {}) {
  std::vector<std::string> notes = survey_of("mesh", file.path, keys).report.notes;
  for (std::string& note : notes) note.erase(0, file.path.size() + 2);  // "FILE: "
  return notes;
}

std::string obj_of(const Mesh& mesh) {
  std::string text;
  for (const Vec3& v : mesh.vertices) text += fmt::format("v {:.17g} {:.17g} {:.17g}\n", v.x(), v.y(), v.z());
  for (const auto& t : mesh.triangles) text += fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
  return text;
}

/// Two triangles, (0, 0, 0) to (2, 1, 0.5), as binary STL.
std::string binary_stl(const std::string& header = "") {
  std::string text = header + std::string(80 - header.size(), ' ');
  const std::uint32_t count = 2;
  text.append(reinterpret_cast<const char*>(&count), 4);
  const float facets[2][12] = {{0, 0, 1, 0, 0, 0, 2, 0, 0, 2, 1, 0.5},
                               {0, 0, 1, 0, 0, 0, 2, 1, 0.5, 0, 1, 0.5}};
  for (const auto& facet : facets) text.append(reinterpret_cast<const char*>(facet), 48).append(2, '\0');
  return text;
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

}  // namespace

TEST_CASE("an OBJ file is the same ground in every form that programs write") {
  for (int seed = 0; seed < samples(200); ++seed) {
    CAPTURE(seed);
    RandomStream rng(static_cast<std::uint64_t>(seed), "obj", {});
    const Sheet sheet = random_sheet(rng);
    const Mesh made = sheet.mesh();
    const std::string end = rng.uniform() < 0.3 ? "\r\n" : "\n";
    const bool is_clockwise = rng.uniform() < 0.3, has_texture = rng.uniform() < 0.3,
               is_relative = rng.uniform() < 0.3;
    std::string text = rng.uniform() < 0.3 ? "\xEF\xBB\xBF" : "";
    text += rng.uniform() < 0.5 ? "# a survey" + end : "";
    const std::string colour = rng.uniform() < 0.3 ? " 0.5 0.5 0.5" : "";
    for (const Vec3& v : made.vertices) {
      text += fmt::format("v {:.17g} {:.17g} {:.17g}{}{}", v.x(), v.y(), v.z(), colour, end);
      if (has_texture) text += "vt 0 0" + end;
    }
    const auto corner = [&](int v) {
      const int index = is_relative ? v - static_cast<int>(made.vertices.size()) : v + 1;
      return has_texture ? fmt::format("{0}/{0}", index) : fmt::format("{}", index);
    };
    for (const auto& t : made.triangles) {
      text += fmt::format("f {} {} {}{}", corner(t[0]), corner(t[is_clockwise ? 2 : 1]),
                          corner(t[is_clockwise ? 1 : 2]), end);
      if (rng.uniform() < 0.05) text += fmt::format("f {0} {0} {1}{2}", corner(t[0]), corner(t[1]), end);
    }
    const TemporaryFile file("form.obj", text);
    const Mesh read = mesh_of(file);
    for (int i = 0; i < 10; ++i) {
      const Vec2 place = place_on(sheet, rng);
      const auto is = heights_at(read, place), was = heights_at(made, place);
      REQUIRE((is.size() == 1 && was.size() == 1));
      CHECK(std::abs(is[0] - was[0]) < 1e-9);
    }
  }
}

TEST_CASE("names with blanks are parts, and materials where there are no groups") {
  const std::string faces = "f 1 2 3\nusemtl hard rock\nf 1 3 4\n";
  const auto parts = [&](const std::string& text, const SurveyKeys& keys = {}) {
    return mesh_of(TemporaryFile("parts.obj", square + text), keys).parts;
  };
  using Names = std::vector<std::string>;
  CHECK(parts("g pit face_1\nf 1 2 3\ng pit floor \nf 1 3 4\n") == Names{"pit_face_1", "pit_floor"});
  CHECK(parts("o pit face\nf 1 2 3\no pit floor\nf 1 3 4\n") == Names{"pit_face", "pit_floor"});
  CHECK(parts("usemtl gravel\n" + faces) == Names{"gravel", "hard_rock"});
  CHECK(parts("f 1 2 3\nf 1 3 4\n") == Names{""});
  const std::string both = "g top\nusemtl gravel\n" + faces;
  CHECK(parts(both) == Names{"top"});
  CHECK(parts(both, {{"parts", "materials"}}) == Names{"gravel", "hard_rock"});
  CHECK(parts(both, {{"parts", "groups"}}) == Names{"top"});
  const TemporaryFile file("both.obj", square + both);
  CHECK(notes_of(file) ==
        Names{"all faces are of the group `top`; `parts: materials` makes parts of its 2 materials "
              "(gravel, hard_rock)"});
  CHECK(notes_of(file, {{"parts", "groups"}}).empty());
  CHECK(survey_error("mesh", TemporaryFile("none.obj", square + "f 1 2 3\n"), {{"parts", "materials"}}) ==
        " has no line `usemtl`, which `parts: materials` asks for");
}

TEST_CASE("an OBJ file that was joined of two has the byte order mark of each, one of UTF-16 is refused") {
  const std::string mark = "\xEF\xBB\xBF", other = "v 1 0 0\nv 2 0 0.5\nv 2 1 0.5\nf -3 -2 -1\n";
  const Mesh mesh = mesh_of(TemporaryFile("joined.obj", mark + square + "f 1 2 3\nf 1 3 4\n" + mark + other));
  REQUIRE(mesh.triangles.size() == 3);
  CHECK(mesh.vertices[mesh.triangles[2][0]] == Vec3(1, 0, 0));
  std::string wide = "\xFF\xFE";
  for (const char c : square + "f 1 2 3\n") wide += {c, '\0'};
  CHECK(survey_error("mesh", TemporaryFile("wide.obj", wide)) ==
        "1: the text is UTF-16: save the file as UTF-8 or ASCII");
}

TEST_CASE("a line of an OBJ that looks like a vertex is not passed over") {
  const auto error = [](const std::string& first) {
    return survey_error("mesh", TemporaryFile("odd.obj", first + square + "f 1 2 3\n"));
  };
  CHECK(error("V 0 0 1\n") == "1: `V` is no statement of OBJ, expected `v`");
  for (const char* blank : {"\xC2\xA0", "\x0B"})
    CHECK(error(fmt::format("v{}0 0 1\n", blank)).find("in which a letter is none of ASCII") !=
          std::string::npos);
  CHECK(error("\x1A\n") == "no error");
  CHECK(error("vp 0 0 1\nshadow_obj x\n") == "no error");
}

TEST_CASE("tiles that overlap are no slit, because a weld does not close it") {
  Mesh mesh = Sheet{.columns = 8, .rows = 8, .hill = 0}.mesh();
  Sheet other{.columns = 8, .rows = 8, .hill = 0};
  other.corner = {13, 0};  // 3 of 16 m on one plane, with border vertices on the border of the first
  append(mesh, other.mesh());
  const std::string error = survey_error("mesh", TemporaryFile("tiles.obj", obj_of(mesh)));
  CHECK(error.find("two surfaces lie over each other at (") != std::string::npos);
  CHECK(error.find("weld") == std::string::npos);
}

TEST_CASE("STL is read with capitals, bytes at its end, and `solid` in a binary header") {
  const std::string text =
      "SOLID Hill\nFACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 2 0 0\nVERTEX 2 1 "
      "0.5\nENDLOOP\nENDFACET\n"
      "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 2 1 0.5\nvertex 0 1 "
      "5E-1\nendloop\nendfacet\nENDSOLID Hill\n";
  const TemporaryFile capitals("capitals.stl", text), marked("marked.stl", "\xEF\xBB\xBF" + text),
      solid("solid.stl", binary_stl("solid of a scanner")),
      longer("longer.stl", binary_stl("solid") + "more"),
      coloured("coloured.stl", binary_stl("COLOR=") + std::string(120, '\1'));
  for (const TemporaryFile* file : {&capitals, &marked, &solid, &longer, &coloured}) {
    const Mesh mesh = mesh_of(*file);
    CHECK(mesh.vertices.size() == 4);
    REQUIRE(mesh.triangles.size() == 2);
    CHECK(mesh.vertices[mesh.triangles[1][2]] == Vec3(0, 1, 0.5));
  }
  CHECK(notes_of(solid).empty());
  CHECK(notes_of(longer) ==
        std::vector<std::string>{"4 bytes follow the 2 triangles that the file announces: not read"});
  CHECK(survey_error("mesh", TemporaryFile("short.stl", binary_stl("solid").substr(0, 150)))
            .find("is neither STL as text") != std::string::npos);
}

TEST_CASE("all faults of a file come at once, each with what to write") {
  Mesh mesh = Sheet{.columns = 8, .rows = 8}.mesh();
  mesh.triangles.erase(mesh.triangles.begin() + 2 * (8 * 3 + 3));  // a hole
  mesh.part.pop_back();
  Sheet other{.columns = 8, .rows = 8};
  other.corner = {16 + 0.003, 0};  // 3 mm beside
  append(mesh, other.mesh());
  const TemporaryFile file("faults.obj", obj_of(mesh));
  try {
    survey_of("mesh", file.path);
    FAIL("it was read");
  } catch (const FileFaults& found) {
    REQUIRE(found.faults.size() == 2);
    CHECK(found.faults[0].find("has a hole of 3 edges from (") != std::string::npos);
    CHECK(found.faults[0].find("; `repair: { fill_holes: 3 }` fills it") != std::string::npos);
    CHECK(found.faults[1].find("two pieces of the mesh miss each other by") != std::string::npos);
    const std::size_t weld = found.faults[1].find("`repair: { weld: ");
    REQUIRE(weld != std::string::npos);
    const double width = std::stod(found.faults[1].substr(weld + 17));
    CHECK((width > 0.003 && width < 0.006));
    CHECK(survey_error("mesh", file, {{"repair.weld", width}, {"repair.fill_holes", 3.0}}) == "no error");
  }
}

TEST_CASE("heights that no ground has name the axis and the scale") {
  const TemporaryFile up(
      "up.obj", "v 0 500 1200000\nv 10 500 1200000\nv 10 500 1199990\nv 0 500 1199990\nf 1 2 3\nf 1 3 4\n");
  CHECK(survey_error("mesh", up) ==
        " a corner (line 5) has the height 1200000 m, and 6 corners in all are below -1000 m or above 9000 "
        "m, which no "
        "ground is; write `up: y` if y points up in the file, or `scale` if it is not in m");
  CHECK(survey_error("mesh", up, {{"up", "y"}}) == "no error");
  const SurveyReport report = survey_of("mesh", up.path, {{"up", "y"}}).report;
  CHECK(report.size == "2 triangles, 500 to 500 m");
}

}  // namespace survey_meshes_test
