// What populations, launches and laws in Lua see of the ground, and what populations answer in 3D.

#include <catch2/catch.hpp>

#include "blast/blast.h"
#include "conformance/plugin_use.h"
#include "geometry/ground.h"
#include "geometry/profile.h"
#include "plugin/conformance.h"
#include "plugin/models.h"
#include "plugin/terrain_view.h"
#include "unit/lua_fixture.h"

using namespace flyrock;

namespace {

/// z = x + 2 y for x and y from 0 to 2, with a hole in the corner at (2, 2); from an origin.
struct Slope {
  Vec3 origin;
  std::unique_ptr<const Ground3> ground;
  std::vector<Mesh::Face> faces{{"main", {{0, 0, 0}, {0, 2, 4}}, {{1, 0, 1}, {1, 2, 5}}}};

  explicit Slope(const Vec3& at = Vec3::Zero()) : origin(at) {
    HeightGrid grid;
    grid.columns = grid.rows = 3;
    grid.heights = {0, 1, 2, 2, 3, 4, 4, 5, std::nan("")};
    ground = make_ground(grid);
  }
  TerrainView view() const { return {*ground, faces, origin}; }
};

std::vector<RockPlan<3>> rocks_of(const std::string& body, const TerrainView& terrain) {
  OnePlugin lua("population", "rocks = function(p, terrain, blast, rng) " + body + " end");
  RandomStream rng(1, "test", {});
  return make<Population>(lua.session, PluginKind::population, "m", {}, 3)
      .model->rocks_3d({}, terrain, Blast(), rng);
}

/// The message about one wrong rock, after "plugin m, m.lua:3: rocks() returned ".
std::string wrong(const std::string& rock) {
  const std::string before = "plugin m, m.lua:3: rocks() returned ";
  try {
    rocks_of("return { " + rock + " }", Slope().view());
  } catch (const PluginError& error) {
    const std::string text = error.what();
    return text.starts_with(before) ? text.substr(before.size()) : text;
  }
  return "";
}

}  // namespace

TEST_CASE("a population in 3D asks the terrain for heights, normals, ends and faces") {
  const Slope slope({1000, 2000, 300});
  const auto rocks = rocks_of(R"(
    assert(terrain.dimension == 3 and terrain.x_min == 1000 and terrain.y_max == 2002)
    assert(terrain:height(1000.5, 2001) == 302.5)
    local n = terrain:normal(1000.5, 2000.25)
    assert(#n == 3 and math.abs(n[1] + 1 / math.sqrt(6)) < 1e-12 and math.abs(n[2] + 2 / math.sqrt(6)) < 1e-12)
    assert(terrain:height(1001.9, 2001.9) == nil and terrain:normal(990, 2000) == nil)
    local face = terrain.faces[1]
    assert(face.name == "main" and face.toe[2][3] == 304 and face.crest[1][1] == 1001)
    return { {}, { radius = 2, position = { 1001, 2001, 310 } } })",
                              slope.view());
  REQUIRE(rocks.size() == 2);
  CHECK((rocks[0].shape.contactors.empty() && !rocks[0].position && !rocks[0].orientation));
  CHECK(rocks[1].shape.contactors.at(0).radius == 2);
  CHECK(*rocks[1].position == Vec3(1001, 2001, 310));
}

TEST_CASE("a terrain in 2D has points, heights and normals") {
  Profile profile;
  profile.points = {{0, 4}, {3, 0}, {5, 0}};
  profile.part = {0, 0};
  profile.parts = {""};
  OnePlugin lua("population", R"(rocks = function(p, terrain)
    assert(terrain.dimension == 2 and #terrain.points == 3 and terrain.x_max == 5)
    local n = terrain:normal(1)
    assert(#n == 2 and n[1] == 0.8 and n[2] == 0.6 and terrain:normal(3)[2] == 1 and terrain:normal(5)[2] == 1)
    return { { spin = 3, velocity = { 1, 2 }, mass = 7 } } end)");
  RandomStream rng(1, "test", {});
  const auto rocks = make<Population>(lua.session, PluginKind::population, "m", {})
                         .model->rocks({}, TerrainView(profile), Blast(), rng);
  CHECK((rocks.at(0).spin == 3.0 && *rocks[0].velocity == Vec2(1, 2) && rocks[0].mass == 7.0));
}

TEST_CASE("a wrong rock of a population in 3D is refused with its field") {
  CHECK(wrong("{ radius = 0/0 }") == "[0].radius = nan, expected a finite number");
  CHECK(wrong("{ position = { 1, 2, 1/0 } }") == "[0].position[2] = inf, expected a finite number");
  CHECK(wrong("{ position = { 1, 2, 3, 4 } }") == "rock 0.position = a list, expected { x, y, z }");
  CHECK(wrong("{ position = { 1, 2 } }") ==
        "rock 0.position as in 2D, expected { x, y, z } in 3D: a plugin that serves one dimension says so, "
        "`dimension = 2` in its manifest");
  CHECK(wrong("{ vertices = {} }").starts_with("rock 0.vertices as in 2D, expected `points` in 3D"));
  CHECK(wrong("{ angle = 1 }").starts_with("rock 0.angle as in 2D, expected `orientation` in 3D"));
  CHECK(wrong("{ spin = 1 }").starts_with("rock 0.spin as in 2D, expected { wx, wy, wz } in 3D"));
  CHECK(wrong("{ radius = 1, points = {} }") ==
        "rock 0 = a map, expected one of `radius`, `points` and `shape` in it");
  CHECK(wrong("{ points = { {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0} } }").starts_with("rock 0.points: "));
  CHECK(wrong("{ shape = { { radius = 1 }, { points = 3 } } }") ==
        "rock 0.shape[1].points = 3, expected a list of { x, y, z }");
  CHECK(wrong("{ orientation = { 0, 0, 0, 0 } }") ==
        "rock 0.orientation = a list, expected a quaternion that is not zero");
  CHECK(wrong("{ orientation = { axis = { 0, 0, 0 }, angle = 1 } }") ==
        "rock 0.orientation.axis = a list, expected an axis that is not zero");
  CHECK(wrong("{ orientation = { axis = { 0, 0, 1 } } }")
            .find("expected { axis = { x, y, z }, angle = rad }") != std::string::npos);
  CHECK(wrong("{ density = -1 }") == "rock 0.density = -1, expected a number above 0");
  CHECK(wrong("{ density = 1, mass = 1 }") == "rock 0 = a map, expected one of `density` and `mass` in it");
  CHECK(wrong("{ material = 3 }") == "rock 0.material = 3, expected the name of a material");
  CHECK(wrong("{ velocity = 3 }") == "rock 0.velocity = 3, expected { x, y, z }");
  CHECK(wrong("{ mas = 3 }") == "the unknown field rock 0.mas, did you mean `mass`?");
  CHECK(wrong("3").starts_with("rock 0 = 3, expected a table with"));
}

TEST_CASE("a terrain refuses what it is asked wrongly") {
  const auto asked = [](const std::string& code) -> std::string {
    try {
      rocks_of(code + " return {}", Slope().view());
    } catch (const PluginError& error) {
      return error.what();
    }
    return "";
  };
  CHECK(asked("local a = terrain.points").find("`terrain.points` is there only in 2D") != std::string::npos);
  CHECK(asked("terrain:height(1)").find("in 3D it is terrain:height(x, y)") != std::string::npos);
  CHECK(asked("terrain:normal(0/0, 1)").find("terrain:normal(x, y): expected finite numbers") !=
        std::string::npos);
  CHECK(asked("terrain.height(1, 2)").find("write terrain:method(...)") != std::string::npos);
  CHECK(asked("terrain.x_min = 3").find("`terrain` cannot be changed") != std::string::npos);
  for (const char* write : {"terrain.faces[1] = nil", "terrain.faces[1].name = 'x'",
                            "terrain.faces[1].toe[1][3] = 0", "table.remove(terrain.faces[1].crest)"}) {
    INFO(write);
    CHECK(asked(write).find("`terrain.faces` cannot be changed") != std::string::npos);
  }
  // What a method returns belongs to the caller.
  CHECK(asked("local n = terrain:normal(0.5, 0.25) n[1] = 5 assert(n[1] == 5)").empty());
}

TEST_CASE("the points of a terrain in 2D cannot be changed, and can be read as a list") {
  Profile profile;
  profile.points = {{0, 4}, {3, 0}, {5, 0}};
  profile.part = {0, 0};
  profile.parts = {""};
  const auto asked = [&](const std::string& code) -> std::string {
    OnePlugin lua("population", "rocks = function(p, terrain) " + code + " return {} end");
    RandomStream rng(1, "test", {});
    try {
      make<Population>(lua.session, PluginKind::population, "m", {})
          .model->rocks({}, TerrainView(profile), Blast(), rng);
    } catch (const PluginError& error) {
      return error.what();
    }
    return "";
  };
  for (const char* write : {"terrain.points[1][2] = 5", "terrain.points[4] = { 6, 0 }",
                            "local last = terrain.points[3] last[1] = 9",
                            "table.sort(terrain.points, function(a, b) return a[2] < b[2] end)"}) {
    INFO(write);
    CHECK(asked(write).find("`terrain.points` cannot be changed") != std::string::npos);
  }
  CHECK(
      asked(
          "local sum = 0 for _, point in ipairs(terrain.points) do sum = sum + point[1] end assert(sum == 8)")
          .empty());
  CHECK(asked("local x, y = table.unpack(terrain.points[1]) assert(x == 0 and y == 4)").empty());
}

TEST_CASE("a launch asks the ground of its rock") {
  OnePlugin lua("velocity",
                "launch = function(p, rock, blast, rng, terrain)\n"
                "  local x, y, z = table.unpack(rock.position)\n"
                "  return { velocity = { z - terrain:height(x, y), 0, 0 } } end");
  const Slope slope;
  const TerrainView view = slope.view();
  RockView rock;
  rock.dimension = 3;
  rock.position = {1, 1, 10};
  rock.terrain = &view;
  RandomStream rng(1, "test", {});
  const auto made = make<VelocityModel>(lua.session, PluginKind::velocity, "m", {}, 3);
  CHECK(made.model->launch({}, rock, Blast(), rng).velocity == Vec3(7, 0, 0));
}

TEST_CASE("a plugin of one dimension says so, and is refused in the other") {
  OnePlugin lua("population",
                "dimension = 3, rocks = function(p, terrain) return { { position = { 0, 0, "
                "terrain:height(0, 0) } } } end");
  CHECK_THROWS_WITH(make<Population>(lua.session, PluginKind::population, "m", {}, 2),
                    "plugin m: the population `m` is of dimension 3, the scenario has dimension 2");
  const Plugin* plugin = lua.session.registry().find(PluginKind::population, "m");
  CHECK(conformance(*plugin).faults.empty());
  LuaFixture wrong;
  wrong.write("m.lua",
              "local fr = require 'flyrock'\nreturn fr.plugin { kind = 'population', name = 'm', doc = "
              "'d', dimension = 4, rocks = function(p) return {} end }");
  CHECK(wrong.load("m.lua").find("dimension: 4, expected 2 or 3, or nothing for both") != std::string::npos);
}
