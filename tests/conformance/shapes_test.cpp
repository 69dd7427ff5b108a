// The native shapes: what their parameters promise.

#include <catch2/catch.hpp>

#include "conformance/plugin_use.h"
#include "geometry/contactor.h"
#include "plugin/models.h"

using namespace flyrock;

namespace shapes_test {

namespace {

const LuaSession& session() {
  static const LuaSession one(FLYROCK_SHARE_DIR);
  return one;
}

Made<ShapeModel> polygon(const std::map<std::string, Given>& given) {
  return make<ShapeModel>(session(), PluginKind::shape, "polygon", given);
}

std::vector<Vec2> drawn(const Made<ShapeModel>& shape, std::uint64_t rock) {
  RandomStream rng(7, "shape", {.rock = rock});
  return shape.model->build(shape.values, rng).front().points;
}

double angle_between(const Vec2& a, const Vec2& b) { return std::atan2(cross(a, b), a.dot(b)); }

}  // namespace

TEST_CASE("a drawn polygon has its sides, its area, and corners at least 20 degrees apart") {
  for (int sides : {3, 5, 9, 17, 18, 40, 100})
    for (double irregularity : {0.0, 0.3, 1.0}) {
      const double diameter = 0.6;
      const auto shape =
          polygon({{"sides", double(sides)}, {"diameter", diameter}, {"irregularity", irregularity}});
      for (std::uint64_t rock = 0; rock < 50; ++rock) {
        const auto vertices = drawn(shape, rock);
        REQUIRE(vertices.size() == static_cast<std::size_t>(sides));
        const auto area = area_properties({Contactor2::polygon(vertices)});
        CHECK(area.area == Approx(pi / 4 * diameter * diameter).epsilon(1e-12));
        const double least = sides < 18 ? 20 * pi / 180 : pi / sides;
        for (std::size_t i = 0; i < vertices.size(); ++i) {
          double gap = angle_between(vertices[i], vertices[(i + 1) % vertices.size()]);
          if (gap < 0) gap += 2 * pi;
          CHECK(gap >= least * (1 - 1e-9));
          if (irregularity == 0) CHECK(gap == Approx(2 * pi / sides));
        }
        const Vec2 base = vertices.front() - vertices.back();
        CHECK(std::abs(base.y()) < 1e-12);
      }
    }
}

TEST_CASE("irregularity is 0.3 where it is left out, and rocks differ") {
  const auto plain = polygon({{"sides", 6.0}, {"diameter", 1.0}});
  const auto said = polygon({{"sides", 6.0}, {"diameter", 1.0}, {"irregularity", 0.3}});
  CHECK(drawn(plain, 1) == drawn(said, 1));
  CHECK(drawn(plain, 1) != drawn(plain, 2));
}

TEST_CASE("a polygon takes vertices, or sides and diameter") {
  const std::vector<std::vector<double>> clockwise{{0, 0}, {0, 1}, {1, 1}};
  CHECK(drawn(polygon({{"vertices", clockwise}}), 0) == std::vector<Vec2>{{1, 1}, {0, 1}, {0, 0}});
  const std::string either = "plugin polygon: expected either `vertices`, or `sides` and `diameter`";
  CHECK_THROWS_WITH(polygon({}), either);
  CHECK_THROWS_WITH(polygon({{"sides", 5.0}}), either);
  CHECK_THROWS_WITH(polygon({{"vertices", clockwise}, {"sides", 5.0}}), either);
  CHECK_THROWS_WITH(
      polygon({{"vertices", clockwise}, {"irregularity", 0.5}}),
      "plugin polygon: `irregularity` is of a drawn polygon and says nothing beside `vertices`");
  const std::vector<std::vector<double>> two{{0, 0}, {1, 0}};
  CHECK_THROWS_WITH(polygon({{"vertices", two}}),
                    "plugin polygon: a polygon has 2 vertices, at least 3 are needed");
}

TEST_CASE("rounding a polygon keeps its sides, and is refused where a side has no straight part left") {
  const std::vector<std::vector<double>> triangle{
      {0, 0}, {4, 0}, {0, 3}};  // its inscribed circle has radius 1
  const auto sharp = polygon({{"vertices", triangle}});
  const auto built = [](const Made<ShapeModel>& shape) {
    RandomStream rng(7, "shape", {});
    return shape.model->build(shape.values, rng).front();
  };
  const Contactor2 core = built(sharp),
                   rounded = built(polygon({{"vertices", triangle}, {"rounding", 0.25}}));
  CHECK(rounded.radius == 0.25);
  REQUIRE(rounded.points.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK((rounded.normals[i] - core.normals[i]).norm() < 1e-14);
    CHECK(core.normals[i].dot(rounded.points[i] - core.points[i]) == Approx(-0.25).epsilon(1e-12));
  }
  CHECK(built(polygon({{"vertices", triangle}, {"rounding", 0.0}})).points == core.points);
  CHECK_NOTHROW(built(polygon({{"vertices", triangle}, {"rounding", 0.999}})));
  CHECK_THROWS_WITH(
      built(polygon({{"vertices", triangle}, {"rounding", 1.5}})),
      "plugin polygon: rounding is 1.5 m, must be below 1 m, where the first side of this polygon "
      "has no straight part");
  const auto drawn_round =
      polygon({{"sides", 4.0}, {"diameter", 1.0}, {"irregularity", 0.0}, {"rounding", 0.1}});
  CHECK(area_properties({built(drawn_round)}).area == Approx(pi / 4 - (4 - pi) * 0.01).epsilon(1e-12));
}

TEST_CASE("a disk is a disk") {
  const auto disk = make<ShapeModel>(session(), PluginKind::shape, "disk", {{"radius", 0.25}});
  RandomStream rng(1, "shape", {});
  const auto contactors = disk.model->build(disk.values, rng);
  REQUIRE(contactors.size() == 1);
  CHECK(contactors[0].points.size() == 1);
  CHECK(contactors[0].radius == 0.25);
}

}  // namespace shapes_test
