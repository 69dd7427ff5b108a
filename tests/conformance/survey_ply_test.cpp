// PLY files as programs write them, compared with the ground that they were made from, and files that are
// wrong.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>

#include "samples.h"
#include "survey_of.h"
#include "surveyed_meshes.h"

using namespace flyrock;

namespace survey_ply_test {

using namespace surveyed_meshes;

namespace {

/// How a program writes PLY.
struct PlyForm {
  std::string format = "ascii", end = "\n", list = "uchar int vertex_indices";
  bool is_single = false, has_normals = false, has_colours = false, has_edges = false;

  bool is_text() const { return format == "ascii"; }
};

class PlyText {
 public:
  PlyText(const PlyForm& form, const Mesh& mesh) : form_(form) {
    const std::string number = form.is_single ? "float" : "double";
    bytes_ = "ply" + form.end;
    line("format " + form.format + " 1.0");
    line("comment written by a test");
    if (form.has_edges) {
      line("element edge 2");
      line("property int vertex1");
      line("property list uchar float weights");
    }
    line(fmt::format("element vertex {}", mesh.vertices.size()));
    if (form.has_normals) line("property float nx");
    for (const char axis : {'x', 'y', 'z'}) line(fmt::format("property {} {}", number, axis));
    if (form.has_colours) line("property uint8 red");
    line(fmt::format("element face {}", mesh.triangles.size()));
    line("property list " + form.list);
    if (form.has_colours) line("property ushort label");
    line("end_header");
    if (form.has_edges)
      for (int i = 0; i < 2; ++i) {
        put<std::int32_t>(i);
        put<std::uint8_t>(1);
        put<float>(0.5f);
        end_row();
      }
    for (const Vec3& v : mesh.vertices) {
      if (form.has_normals) put(std::nanf(""));  // of a vertex without a face
      for (int k = 0; k < 3; ++k) form.is_single ? put(static_cast<float>(v[k])) : put(v[k]);
      if (form.has_colours) put<std::uint8_t>(200);
      end_row();
    }
    for (const auto& t : mesh.triangles) {
      form.list.starts_with("uchar") ? put<std::uint8_t>(3) : put<std::int32_t>(3);
      for (const int corner : t) put<std::int32_t>(corner);
      if (form.has_colours) put<std::uint16_t>(7);
      end_row();
    }
  }

  const std::string& bytes() const { return bytes_; }

 private:
  void line(const std::string& text) { bytes_ += text + form_.end; }
  void end_row() {
    if (form_.is_text()) bytes_ += form_.end;
  }
  template <class Number>
  void put(Number number) {
    if (form_.is_text()) {
      bytes_ += fmt::format("{} ", number);
      return;
    }
    char raw[sizeof number];
    std::memcpy(raw, &number, sizeof number);
    if (form_.format == "binary_big_endian") std::reverse(raw, raw + sizeof number);
    bytes_.append(raw, sizeof number);
  }

  const PlyForm& form_;
  std::string bytes_;
};

PlyForm random_form(RandomStream& rng) {
  static const std::vector<std::string> formats = {"ascii", "binary_little_endian", "binary_big_endian"};
  static const std::vector<std::string> lists = {"uchar int vertex_indices", "uchar uint vertex_index",
                                                 "int32 int32 vertex_indices"};
  PlyForm form;
  form.format = formats[static_cast<std::size_t>(rng.integer(0, 2))];
  form.list = lists[static_cast<std::size_t>(rng.integer(0, 2))];
  form.end = rng.uniform() < 0.3 ? "\r\n" : "\n";
  form.has_normals = rng.uniform() < 0.5;
  form.has_colours = rng.uniform() < 0.5;
  form.has_edges = rng.uniform() < 0.3;
  return form;
}

/// A mesh far from 0, where single precision would show.
Mesh national(Mesh mesh) {
  for (Vec3& vertex : mesh.vertices) vertex += Vec3(2600000, 1200000, 0);
  return mesh;
}

std::string ply_error(const std::string& content) {
  return survey_error("mesh", TemporaryFile("bad.ply", content));
}

const std::string vertex_head = "property double x\nproperty double y\nproperty double z\n";
const std::string face_head = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

std::string triangle(const std::string& rows) {
  return "ply\nformat ascii 1.0\nelement vertex 3\n" + vertex_head + face_head + rows;
}

}  // namespace

TEST_CASE("a PLY file is the same ground in every form that programs write, to the last digit") {
  for (int seed = 0; seed < samples(200); ++seed) {
    CAPTURE(seed);
    RandomStream rng(static_cast<std::uint64_t>(seed), "ply", {});
    const Mesh made = national(random_sheet(rng).mesh());
    const TemporaryFile file("form.PLY", PlyText(random_form(rng), made).bytes());
    const Survey read = survey_of("mesh", file.path);
    const Mesh& mesh = std::get<Mesh>(read.shape);
    CHECK(read.report.notes.empty());
    REQUIRE(mesh.triangles.size() == made.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (int k = 0; k < 3; ++k)
        CHECK(mesh.vertices[mesh.triangles[t][k]] == made.vertices[made.triangles[t][k]]);
  }
}

TEST_CASE("a PLY file with single precision in national coordinates is read with a note") {
  Sheet sheet;
  sheet.cell = 8;
  PlyForm form;
  form.format = "binary_little_endian";
  form.is_single = true;
  const TemporaryFile file("single.ply", PlyText(form, national(sheet.mesh())).bytes());
  const std::vector<std::string> notes = survey_of("mesh", file.path).report.notes;
  REQUIRE(notes.size() == 1);
  CHECK(notes[0].find("single precision, 0.25 apart near 2600048: export PLY with doubles") !=
        std::string::npos);
}

TEST_CASE("a face of PLY with four corners is two triangles") {
  const TemporaryFile file("quad.ply", "ply\nformat ascii 1.0\nelement vertex 4\n" + vertex_head + face_head +
                                           "0 0 0\n2 0 0\n2 1 0.5\n0 1 0.5\n4 0 1 2 3");
  const Mesh mesh = std::get<Mesh>(survey_of("mesh", file.path).shape);
  CHECK(mesh.triangles == std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}});
}

TEST_CASE("a PLY file that is cut at any byte, or has its bytes in the other order, is refused") {
  Sheet sheet;
  sheet.columns = sheet.rows = 1;
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    PlyForm form;
    form.format = format;
    form.has_colours = true;
    const std::string whole = PlyText(form, sheet.mesh()).bytes();
    REQUIRE(ply_error(whole) == "no error");
    for (std::size_t size = 0; size < whole.size(); ++size) {
      // A text may lack its last line end, and the last digit of a label that nobody reads.
      if (form.is_text() && size + 2 >= whole.size()) continue;
      CAPTURE(format, size);
      const std::string error = ply_error(whole.substr(0, size));
      CHECK(error != "no error");
      CHECK(error.find('\n') == error.npos);
    }
    if (form.is_text()) continue;
    std::string other = whole;
    const std::size_t at = other.find(format);
    other.replace(at, std::string(format).size(),
                  form.format == "binary_big_endian" ? "binary_little_endian" : "binary_big_endian");
    CHECK(ply_error(other) != "no error");
  }
}

TEST_CASE("a malformed PLY file is refused with its line") {
  const std::string corners = "0 0 0\n2 0 0\n2 1 0.5\n";
  REQUIRE(ply_error(triangle(corners + "3 0 1 2\n")) == "no error");
  const struct {
    std::string content, error;
  } cases[] = {
      {"", " is no PLY file: its first line is not `ply`"},
      {"ply\nformat ascii 1.0\n", "2: the head ends here without `end_header`"},
      {"ply\nend_header\n", " its head has no line `format`"},
      {"ply\nformat binary 1.0\n",
       "2: expected `format ascii 1.0`, binary_little_endian or binary_big_endian"},
      {"ply\nelement vertex -3\n", "2: expected `element NAME COUNT` with a whole number of at least 0"},
      {"ply\nelement vertex 1\nproperty real x\n",
       "3: `real` is no type of PLY, expected char, uchar, short, ushort, int, uint, float or double"},
      {"ply\nformat ascii 1.0\nelement vertex 1\nproperty double x\nend_header\n1\n",
       " the element `vertex` lacks one of the properties x, y, z"},
      {"ply\nformat ascii 1.0\nelement vertex 9000000000000000000\n" + vertex_head + "end_header\n0 0 0\n",
       " its head announces 9000000000000000000 times `vertex`, the 6 bytes that follow hold at most 1"},
      {"ply\nformat ascii 1.0\nelement thing 9\nend_header\n", " the element `thing` has no property"},
      {"ply\nformat ascii 1.0\nelement vertex 1\n" + vertex_head + "end_header\n0 0 0\n",
       " has points and no faces: triangulate them (CloudCompare: Edit, Mesh, Delaunay 2.5D), or make a grid "
       "for "
       "the terrain `raster` of them"},
      {triangle("0 0 0\n2 0\n2 1 0.5\n3 0 1 2\n"), "11: the line has 2 numbers, `vertex` needs more"},
      {triangle("0 0 0\n2 0 0 7\n2 1 0.5\n3 0 1 2\n"),
       "11: 4 numbers, expected 3: the properties of `vertex`"},
      {triangle("0 0 0\n2 nan 0\n2 1 0.5\n3 0 1 2\n"), "11: `nan` is not a number"},
      {triangle(corners + "3 0 1 3\n"), "13: a corner is 3, expected a whole number from 0 to 2"},
      {triangle(corners + "3 0 1 -1\n"), "13: a corner is -1, expected a whole number from 0 to 2"},
      {triangle(corners + "2 0 1\n"), "13: the face has 2 corners, expected three or more"},
      {triangle(corners + "3 0 1 2\n3 0 1 2\n"), "14: the file goes on after all that its head announces"},
      {triangle("0 0 0\n2 0 0\n2 1 1e300\n3 0 1 2\n"),
       " a corner in line 13 has the height 1e+300 m, and 1 corners in all are below -1000 m or above 9000 "
       "m, which "
       "no ground is; write `up: y` if y points up in the file, or `scale` if it is not in m"},
  };
  for (const auto& one : cases) CHECK(ply_error(one.content) == one.error);
}

}  // namespace survey_ply_test
