#include <cmath>
#include <limits>

#include "geometry/mesh_edges.h"
#include "geometry/terrain_fault.h"
#include "host/answer_reader.h"
#include "host/read_answer.h"

namespace flyrock {

namespace {

class TerrainReader : public AnswerReader {
 public:
  using AnswerReader::AnswerReader;

  Mesh mesh(const Value& answer) const {
    check_keys(answer, "", {"vertices", "triangles", "part", "parts", "faces"});
    Mesh mesh;
    mesh.vertices = points_3d(required(answer, "vertices", "a list of { x, y, z }"), "vertices");
    const List& triangles =
        list(required(answer, "triangles", "a list of { a, b, c }"), "triangles", "a list of { a, b, c }");
    for (std::size_t i = 0; i < triangles.size(); ++i)
      mesh.triangles.push_back(triangle(triangles[i], i, mesh));
    parts(answer, mesh);
    if (const Value* given = answer.find("faces")) faces(*given, mesh);
    return welded(std::move(mesh));
  }

  HeightGrid grid(const Value& answer) const {
    check_keys(answer, "", {"heights", "cell", "corner"});
    HeightGrid grid;
    grid.cell = number(required(answer, "cell", "a number above 0"), "cell");
    if (const Value* corner = answer.find("corner")) grid.corner = point(*corner, "corner");
    const List& rows = list(*answer.find("heights"), "heights", "a list of rows");
    grid.rows = static_cast<int>(rows.size());
    for (std::size_t row = 0; row < rows.size(); ++row) {
      const std::string path = join_path("heights", row);
      const List& heights = list(rows[row], path, "a list of heights");
      if (row == 0) grid.columns = static_cast<int>(heights.size());
      if (static_cast<int>(heights.size()) != grid.columns)
        call_.fail(fmt::format("returned {} with {} heights, expected {} as in the first row", path,
                               heights.size(), grid.columns));
      for (std::size_t i = 0; i < heights.size(); ++i)
        grid.heights.push_back(height(heights[i], join_path(path, i)));
    }
    return grid;
  }

 private:
  const Value& required(const Value& answer, const char* key, const char* expected) const {
    const Value* value = answer.find(key);
    if (!value) call_.fail(fmt::format("returned no `{}`, expected {}", key, expected));
    return *value;
  }

  std::vector<Vec3> points_3d(const Value& value, const std::string& path) const {
    std::vector<Vec3> result;
    const List& items = list(value, path, "a list of { x, y, z }");
    for (std::size_t i = 0; i < items.size(); ++i) result.push_back(vector(items[i], join_path(path, i), 3));
    return result;
  }

  /// A whole number from 1 to `most`, less 1.
  int index(const Value& value, const std::string& path, std::size_t most) const {
    const double one = number(value, path);
    if (!(one >= 1 && one <= static_cast<double>(most) && one == std::floor(one)))
      wrong(path, value, fmt::format("a whole number from 1 to {}", most));
    return static_cast<int>(one) - 1;
  }

  std::array<int, 3> triangle(const Value& value, std::size_t i, const Mesh& mesh) const {
    const std::string path = join_path("triangles", i);
    const List& corners = list(value, path, "{ a, b, c }");
    if (corners.size() != 3) wrong(path, value, "{ a, b, c }");
    std::array<int, 3> result{};
    for (int k = 0; k < 3; ++k) result[k] = index(corners[k], join_path(path, k), mesh.vertices.size());
    return result;
  }

  void parts(const Value& answer, Mesh& mesh) const {
    const Value *names = answer.find("parts"), *of = answer.find("part");
    if ((names == nullptr) != (of == nullptr))
      call_.fail("returned one of `part` and `parts`, expected both or neither");
    mesh.parts = {""};
    mesh.part.assign(mesh.triangles.size(), 0);
    if (!names) return;
    mesh.parts.clear();
    const List& texts = list(*names, "parts", "a list of names");
    for (std::size_t i = 0; i < texts.size(); ++i) {
      if (!texts[i].text()) wrong(join_path("parts", i), texts[i], "the name of a part");
      mesh.parts.push_back(*texts[i].text());
    }
    const List& indices = list(*of, "part", "a list with the part of each triangle");
    if (indices.size() != mesh.triangles.size())
      call_.fail(fmt::format("returned {} elements of `part`, expected {}: one for each triangle",
                             indices.size(), mesh.triangles.size()));
    for (std::size_t i = 0; i < indices.size(); ++i)
      mesh.part[i] = index(indices[i], join_path("part", i), mesh.parts.size());
  }

  void faces(const Value& given, Mesh& mesh) const {
    const List& items = list(given, "faces", "a list of { name =, toe = { ... }, crest = { ... } }");
    for (std::size_t i = 0; i < items.size(); ++i) {
      const std::string path = join_path("faces", i);
      check_keys(items[i], path, {"name", "toe", "crest"});
      const Value *name = items[i].find("name"), *toe = items[i].find("toe"), *crest = items[i].find("crest");
      if (!name || !name->text() || !toe || !crest) wrong(path, items[i], "`name`, `toe` and `crest` in it");
      Mesh::Face face{*name->text(), points_3d(*toe, path + ".toe"), points_3d(*crest, path + ".crest")};
      if (face.toe.size() != face.crest.size() || face.toe.size() < 2)
        call_.fail(
            fmt::format("returned {} with {} points of its toe and {} of its crest, expected equally many, "
                        "at least two",
                        path, face.toe.size(), face.crest.size()));
      mesh.faces.push_back(std::move(face));
    }
  }

  double height(const Value& value, const std::string& path) const {
    if (const bool* none = value.boolean(); none && !*none) return std::numeric_limits<double>::quiet_NaN();
    return number(value, path);
  }
};

}  // namespace

TerrainShape3 read_terrain_3d(const LuaCall& call, const Value& answer) {
  refuse_dimension(call, answer, {"points"}, 2, "`vertices` and `triangles`, or `heights`");
  const TerrainReader reader(call);
  const TerrainShape3 shape =
      answer.find("heights") ? TerrainShape3(reader.grid(answer)) : TerrainShape3(reader.mesh(answer));
  if (const std::string wrong = fault(shape); !wrong.empty())
    call.fail("returned a terrain that is not a ground: " + wrong);
  return shape;
}

}  // namespace flyrock
