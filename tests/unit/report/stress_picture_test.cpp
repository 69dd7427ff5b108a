// The picture of a deformable body that is stressed most.

#include "report/pictures/stress_picture.h"

#include <catch2/catch.hpp>

using namespace flyrock;

namespace stress_picture_test {

namespace {

/// A square of 1 m of two triangles, stretched along x by 9e-5.
StressedBlock stretched_square() {
  StressedBlock block;
  block.at.tension_1pct = 5e6;
  for (const Vec3& place : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)})
    block.nodes.push_back({.body = "block",
                           .place = place + Vec3(9e-5 * place.x(), 0, 0),
                           .displacement = Vec3(9e-5 * place.x(), 0, 0)});
  block.cells = {{.body = "block", .a = 0, .b = 1, .c = 2, .tension = 5e6},
                 {.body = "block", .a = 0, .b = 2, .c = 3, .tension = -1e6}};
  return block;
}

}  // namespace

TEST_CASE("displacements are drawn by a round factor, so that the greatest is about 5 % of the body") {
  StressedBlock block = stretched_square();
  CHECK(drawn_displacement(block) == Approx(500));
  for (SeriesNode& node : block.nodes) {
    node.place -= node.displacement;
    node.displacement.setZero();
  }
  CHECK(drawn_displacement(block) == 1);
}

TEST_CASE("a picture has each cell in the colour of its tension, and the factor of its displacements") {
  const std::string svg = stress_svg(stretched_square());
  CHECK(svg.find("#a6192e") != std::string::npos);  // the tension of 1 %
  CHECK(svg.find("#fafafa") != std::string::npos);  // compression
  CHECK(svg.find("0 to 5 MPa in tension") != std::string::npos);
  CHECK(svg.find("displacements 500 times") != std::string::npos);
  CHECK(stress_svg({}).empty());
  StressedBlock solid = stretched_square();
  solid.cells.front().d = 3;  // a tetrahedron: no picture in 3D
  CHECK(stress_svg(solid).empty());
}

TEST_CASE("of the rows of a trial the picture takes the instant when a body is stressed most") {
  TrialRecords chunk;
  for (const auto& [time, share, tension] : {std::tuple(1.0, 0.1, 9e6), {2.0, 0.3, 5e6}, {3.0, 0.2, 8e6}})
    chunk.series_stress.push_back(
        {4, {.time = time, .body = "block", .tension_1pct = tension, .above_strength = share}});
  chunk.series_stress.push_back({5, {.time = 9, .body = "block", .above_strength = 0.9}});
  chunk.series_nodes = {{4, {.time = 1, .body = "block"}}, {4, {.time = 2, .body = "block", .node = 7}}};
  chunk.series_cells = {{4, {.time = 2, .body = "block", .cell = 8}}, {4, {.time = 2, .body = "other"}}};
  const std::vector<StressedBlock> blocks = most_stressed(chunk);
  REQUIRE(blocks.size() == 1);
  CHECK(blocks[0].at.time == 2);
  REQUIRE(blocks[0].nodes.size() == 1);
  CHECK(blocks[0].nodes[0].node == 7);
  REQUIRE(blocks[0].cells.size() == 1);
  CHECK(blocks[0].cells[0].cell == 8);
}

}  // namespace stress_picture_test
