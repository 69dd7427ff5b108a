// Deformable bodies whose meshes are files of Gmsh.

#include <catch2/catch.hpp>

#include "elastic/elastic_mesh.h"
#include "program.h"

using namespace flyrock::test;

namespace gmsh_cli_test {

namespace {

/// A block of a mesh falls flat on the floor.
constexpr const char* block = R"(flyrock: 1
dimension: 2
method: nscd
gravity: 0 m/s2
terrain: { type: profile, points: [[-9, 0], [9, 0]], material: floor }
materials: { floor: { friction: { type: coulomb, mu: 0 } } }
bodies:
  - name: block
    shape: { type: deformable, form: mesh, mesh: block.msh, scale: 0.01, young: 50 GPa, poisson: 0.25 }
    density: 2700 kg/m3
    thickness: 1 m
    position: [0, 0.5]
    velocity: [0, -1]
    material: floor
solver: { time_step: 0.0000232379 s }
stop: { time: 0.002 s, speed: 0 }
output: { series: { every: 0.1 ms } }
)";

/// A square of 100 (cm) as `cells` by `cells` squares, each of four triangles about its middle, and the edge
/// of its base as lines.
std::string crossed_square(int cells) {
  std::string nodes, tags, elements;
  int count = 0, tag = 0, lines = 0;
  const auto add = [&](double x, double y) {
    tags += std::to_string(++count) + "\n";
    nodes += std::to_string(100 * x / cells) + " " + std::to_string(100 * y / cells) + " 0\n";
  };
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i) add(i, j);
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) add(i + 0.5, j + 0.5);
  const auto corner = [&](int i, int j) { return j * (cells + 1) + i + 1; };
  std::string of_lines;
  for (; lines < cells; ++lines)
    of_lines +=
        std::to_string(++tag) + " " + std::to_string(lines + 1) + " " + std::to_string(lines + 2) + "\n";
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      const int round[] = {corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)};
      const int middle = (cells + 1) * (cells + 1) + j * cells + i + 1;
      for (int k = 0; k < 4; ++k)
        elements += std::to_string(++tag) + " " + std::to_string(round[k]) + " " +
                    std::to_string(round[(k + 1) % 4]) + " " + std::to_string(middle) + "\n";
    }
  const std::string all = std::to_string(count), triangles = std::to_string(4 * cells * cells);
  return "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 1 0\n1 0 0 0 1 1 0 0 "
         "0\n$EndEntities\n$Nodes\n1 " +
         all + " 1 " + all + "\n2 1 0 " + all + "\n" + tags + nodes + "$EndNodes\n$Elements\n2 " +
         std::to_string(tag) + " 1 " + std::to_string(tag) + "\n1 1 1 " + std::to_string(lines) + "\n" +
         of_lines + "2 1 2 " + triangles + "\n" + elements + "$EndElements\n";
}

/// A mesh of these nodes and elements (number of them, type and lines).
std::string small(const std::string& nodes, int node_count, const std::string& elements, int count,
                  const std::string& type = "2", const std::string& format = "4.1 0 8") {
  std::string tags;
  for (int i = 1; i <= node_count; ++i) tags += std::to_string(i) + "\n";
  return "$MeshFormat\n" + format + "\n$EndMeshFormat\n$Nodes\n1 " + std::to_string(node_count) + " 1 " +
         std::to_string(node_count) + "\n2 1 0 " + std::to_string(node_count) + "\n" + tags + nodes +
         "$EndNodes\n$Elements\n1 " + std::to_string(count) + " 1 " + std::to_string(count) + "\n2 1 " +
         type + " " + std::to_string(count) + "\n" + elements + "$EndElements\n";
}

/// A cube of this form falls flat on the floor.
std::string cube_of(const std::string& form) {
  return R"(flyrock: 1
dimension: 3
method: nscd
gravity: 0 m/s2
terrain: { type: plane, material: floor }
materials: { floor: { friction: { type: coulomb, mu: 0 } } }
bodies:
  - name: block
    shape: { type: deformable, )" +
         form + R"(, young: 50 GPa, poisson: 0.25 }
    density: 2700 kg/m3
    position: [0, 0, 0.5]
    velocity: [0, 0, -1]
    material: floor
solver: { time_step: 0.00005809475 s }
stop: { time: 0.002 s, speed: 0 }
output: { series: { every: 0.1 ms } }
)";
}

/// The cube that `form: box` makes of bricks, moved, in cm, with the triangles of its surface.
std::string bricked_cube(int bricks) {
  const flyrock::ElasticMesh<3> mesh = flyrock::bricked_box(flyrock::Vec3::Ones(), {bricks, bricks, bricks});
  std::string tags, nodes, elements;
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    tags += std::to_string(i + 1) + "\n";
    const flyrock::Vec3 at = 100 * mesh.nodes[i] + flyrock::Vec3(30, 40, 50);
    nodes += std::to_string(at.x()) + " " + std::to_string(at.y()) + " " + std::to_string(at.z()) + "\n";
  }
  int tag = 0;
  const auto add = [&](const auto& corners) {
    elements += std::to_string(++tag);
    for (const int node : corners) elements += " " + std::to_string(node + 1);
    elements += "\n";
  };
  elements = "2 1 2 " + std::to_string(mesh.sides.size()) + "\n";
  for (const auto& side : mesh.sides) add(side);
  elements += "3 1 4 " + std::to_string(mesh.cells.size()) + "\n";
  for (const auto& cell : mesh.cells) add(cell);
  const std::string count = std::to_string(mesh.nodes.size()), all = std::to_string(tag);
  return "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 " + count + " 1 " + count + "\n3 1 0 " + count +
         "\n" + tags + nodes + "$EndNodes\n$Elements\n2 " + all + " 1 " + all + "\n" + elements +
         "$EndElements\n";
}

const std::string square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

/// Runs a block of block.msh, which ends with a velocity ("vy, equals: 1"), and looks for a note of `check`.
void rebounds(const std::string& mesh, const std::string& scenario, const std::string& final_velocity,
              const std::string& note) {
  const Folder folder;
  folder.write("block.msh", mesh);
  folder.write("s.yaml", scenario);
  const Output run =
      call(folder, "run s.yaml -o r --set 'expect=[{ measure: body.block.final." + final_velocity +
                       ", tolerance: 1e-5 }, { measure: body.block.tension_1pct.max, above: 1 }]'");
  INFO(run.out << run.err);
  CHECK(run.code == 0);
  CHECK(call(folder, "check s.yaml").out.find(note) != std::string::npos);
}

}  // namespace

TEST_CASE("a block of a mesh of Gmsh rebounds as the same mesh that flyrock makes") {
  rebounds(crossed_square(10), block, "vy, equals: 0.825063",
           "10 elements of the mesh of `block` are no triangles of 3 nodes, and are ignored");
}

TEST_CASE("a block of tetrahedra of Gmsh rebounds as the same mesh that flyrock makes") {
  rebounds(bricked_cube(4), cube_of("form: mesh, mesh: block.msh, scale: 0.01"), "vz, equals: 0.743727",
           "192 elements of the mesh of `block` are no tetrahedra of 4 nodes, and are ignored");
}

TEST_CASE("a bad mesh of tetrahedra is one line with file, line and what was expected") {
  struct Bad {
    std::string mesh, says;
  };
  const std::string corners = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n", two = corners + "1 1 1\n";
  const std::vector<Bad> all{
      {small(two, 5, "1 1 2 3 4\n2 2 4 3 5\n", 2, "4"),
       "block.msh:22: tetrahedron 2 is inverted or has no volume, expected its first 3 nodes "
       "counter-clockwise as "
       "seen from the fourth"},
      {small(two, 5, "1 1 2 3 4\n2 2 3 4 9\n", 2, "4"),
       "block.msh:22: tetrahedron 2 has the node 9, which `$Nodes` has not"},
      {small(two, 5, "1 1 2 3 4\n", 1, "4"), "block.msh:16: node 5 belongs to no tetrahedron"},
      {small(two, 5, "1 1 2 3 4\n2 1 2 3 5\n", 2, "4"),
       "block.msh:22: tetrahedron 2 overlaps another one: both have the same side"},
      {small(corners + "0.2 0.2 0\n0.3 0.2 0\n0.2 0.3 0\n0.2 0.2 -1\n", 8, "1 1 2 3 4\n2 5 7 6 8\n", 2, "4"),
       "block.msh:19: node 5 hangs on a side of tetrahedron 1, expected tetrahedra that share whole sides"},
      {small(corners + "5 0 0\n6 0 0\n5 1 0\n5 0 1\n", 8, "1 1 2 3 4\n2 5 6 7 8\n", 2, "4"),
       "block.msh:28: tetrahedron 2 shares no side with the others: the mesh has several pieces, expected "
       "one"},
      {small(square, 4, "1 1 2 3\n2 1 3 4\n", 2),
       "has no tetrahedra of 4 nodes, and 2 other elements, expected a mesh of tetrahedra in 3D"},
      {"$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 2501 1 2501\n",
       "block.msh:5: the mesh has 2501 nodes, expected at most 2500"},
  };
  const Folder folder;
  folder.write("s.yaml", cube_of("form: mesh, mesh: block.msh"));
  for (const Bad& bad : all) {
    folder.write("block.msh", bad.mesh);
    const Output check = call(folder, "check s.yaml");
    INFO(bad.says << "\n" << check.err);
    CHECK(check.code == 2);
    CHECK(check.err.find("s.yaml:9:5: error: bodies.0.shape") != std::string::npos);
    CHECK(check.err.find(bad.says) != std::string::npos);
  }
}

TEST_CASE("a bad mesh is one line with file, line and what was expected") {
  struct Bad {
    std::string mesh, says;
  };
  const std::vector<Bad> all{
      {"", "block.msh:1: is no file of Gmsh, expected `$MeshFormat` in its first line"},
      {small(square, 4, "1 1 2 3\n2 1 3 4\n", 2, "2", "4.1 1 8"),
       "block.msh:2: is binary, expected ASCII: gmsh FILE -save -format msh41 -bin 0"},
      {small(square, 4, "1 1 2 3\n2 1 3 4\n", 2, "2", "2.2 0 8"),
       "block.msh:2: has version 2.2 of the format, expected 4.1: gmsh FILE -save -format msh41"},
      {small(square, 4, "1 1 2 3\n2 1 4 3\n", 2),
       "block.msh:20: triangle 2 is inverted or has no area, expected its nodes counter-clockwise"},
      {small(square, 4, "1 1 2 3\n2 1 3 9\n", 2),
       "block.msh:20: triangle 2 has the node 9, which `$Nodes` has not"},
      {small(square + "5 5 0\n", 5, "1 1 2 3\n2 1 3 4\n", 2), "block.msh:16: node 5 belongs to no triangle"},
      {small("0 0 0\n2 0 0\n1 1 0\n1 0 0\n0 -1 0\n", 5, "1 1 2 3\n2 1 5 4\n", 2),
       "block.msh:15: node 4 hangs on a side of triangle 1, expected triangles that share whole sides"},
      {small(square + "5 5 0\n6 5 0\n5 6 0\n", 7, "1 1 2 3\n2 1 3 4\n3 5 6 7\n", 3),
       "block.msh:27: triangle 3 is at another outline: the mesh has several pieces or a hole, expected one "
       "piece "
       "without holes"},
      {small(square, 4, "1 1 2 3 4\n", 1, "4"),
       "has no triangles of 3 nodes, and 1 other elements, expected a mesh of triangles in 2D"},
      {small("0 0 0\n1 0 0\n1 1 0\n0 1 0.5\n", 4, "1 1 2 3\n2 1 3 4\n", 2),
       "block.msh:14: node 4 has z = 0.5, expected 0 as the others: a mesh in the plane"},
      {small("0 0 0\n1 0 x\n1 1 0\n0 1 0\n", 4, "1 1 2 3\n2 1 3 4\n", 2),
       "block.msh:12: `1 0 x` is no list of numbers, expected the place of a node: x y z"},
      {"$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 20000 1 20000\n",
       "block.msh:5: the mesh has 20000 nodes, expected at most 10000"},
  };
  const Folder folder;
  folder.write("s.yaml", block);
  for (const Bad& bad : all) {
    folder.write("block.msh", bad.mesh);
    const Output check = call(folder, "check s.yaml");
    INFO(bad.says << "\n" << check.err);
    CHECK(check.code == 2);
    CHECK(check.err.find("s.yaml:9:5: error: bodies.0.shape") != std::string::npos);
    CHECK(check.err.find(bad.says) != std::string::npos);
  }
  fs::remove(folder.path() / "block.msh");
  CHECK(call(folder, "check s.yaml").code == 2);
}

}  // namespace gmsh_cli_test
