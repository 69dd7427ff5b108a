// Shapes, terrains, populations and velocities written in Lua.

#include <catch2/catch.hpp>

#include "blast/blast.h"
#include "conformance/plugin_use.h"
#include "geometry/contactor.h"
#include "geometry/contactor3.h"
#include "geometry/own_mass.h"
#include "geometry/profile.h"
#include "geometry/terrain_shape.h"
#include "plugin/models.h"
#include "plugin/terrain_view.h"
#include "unit/lua_fixture.h"

using namespace flyrock;

namespace {

RandomStream stream() { return RandomStream(1, "test", {}); }

std::vector<Contactor2> shape(const std::string& answer) {
  OnePlugin lua("shape", "build = function(p, rng) return " + answer + " end");
  auto rng = stream();
  return make<ShapeModel>(lua.session, PluginKind::shape, "m", {}).model->shape({}, rng).contactors;
}

Profile terrain(const std::string& answer) {
  OnePlugin lua("terrain", "build = function(p, rng) return " + answer + " end");
  auto rng = stream();
  return make<TerrainModel>(lua.session, PluginKind::terrain, "m", {}).model->build({}, rng);
}

}  // namespace

TEST_CASE("a shape in Lua is a disk, a polygon or several contactors") {
  CHECK(shape("{ radius = 0.5 }").front().radius == 0.5);
  const auto square =
      shape("{ vertices = { {0, 0}, {0, 1}, {1, 1}, {1, 0} } }");  // clockwise is turned round
  CHECK(area_properties(square).area == Approx(1));
  CHECK(shape("{ { radius = 1, centre = { -2, 0 } }, { radius = 1, centre = { 2, 0 } } }").size() == 2);
  const auto wall = shape("{ vertices = { {-1, 0}, {1, 0} }, radius = 0.5 }");
  CHECK((wall.front().points.size() == 2 && wall.front().radius == 0.5));
  const auto rounded = shape("{ vertices = { {0, 0}, {0, 1}, {1, 1}, {1, 0} }, radius = 0.5 }");
  CHECK((rounded.front().points.size() == 4 && rounded.front().radius == 0.5));
  CHECK(area_properties(rounded).area == Approx(1 + 4 * 0.5 + pi * 0.25));
  CHECK_THROWS_WITH(
      shape("{ vertices = { {0, 0} }, radius = 0.5 }"),
      "plugin m, m.lua:3: build() returned vertices = a list, expected two different points, or "
      "more, with a radius");
  CHECK_THROWS_WITH(shape("{ vertices = { {0, 0}, {1, 0} , {2, 0} }, radius = 0.5 }"),
                    Catch::StartsWith("plugin m, m.lua:3: build() returned vertices: "));
  CHECK_THROWS_WITH(shape("{ radius = -1 }"),
                    "plugin m, m.lua:3: build() returned radius = -1, expected a number above 0");
  CHECK_THROWS_WITH(shape("{ vertices = { {0, 0}, {1} , {1, 1} } }"),
                    "plugin m, m.lua:3: build() returned vertices[1] = a list, expected { x, y }");
  CHECK_THROWS_WITH(shape("{ radious = 1 }"),
                    "plugin m, m.lua:3: build() returned the unknown field radious, did you mean `radius`?");
  CHECK_THROWS_WITH(shape("nil"), Catch::Contains("build() returned"));
  CHECK_THROWS_WITH(shape("{ vertices = { {0, 0}, {1, 0} , {2, 0} } }"),
                    Catch::StartsWith("plugin m, m.lua:3: build() returned vertices: "));
}

TEST_CASE(
    "a shape in Lua is a sphere, a hull or several contactors in 3D, and one of the other dimension says "
    "so") {
  OnePlugin lua(
      "shape",
      R"(params = { kind = fr.choice { choices = { "ball", "cube", "both", "flat", "pill", "dot" } } },
  build = function(p, rng, dimension)
    if p.kind == "flat" then return { vertices = { {0, 0}, {1, 0}, {0, 1} } } end
    if p.kind == "ball" then return { radius = 0.5 } end
    if p.kind == "pill" then return { points = { {0, 0, -1}, {0, 0, 1} }, radius = 0.5 } end
    if p.kind == "dot" then return { points = { {0, 0, 1}, {0, 0, 1} }, radius = 0.5 } end
    local cube = {}
    for i = 0, 7 do cube[i + 1] = { i & 1, i >> 1 & 1, i >> 2 } end
    if p.kind == "cube" then return { points = cube } end
    return { { points = cube }, { radius = 0.25, centre = { 2, 0, 0 } } }
  end)");
  const auto contactors = [&](const char* kind, int dimension) {
    const auto made = make<ShapeModel>(lua.session, PluginKind::shape, "m", {{"kind", kind}}, dimension);
    auto rng = stream();
    return made.model->shape_3d({}, rng).contactors;
  };
  CHECK(contactors("ball", 3).at(0).radius == 0.5);
  CHECK(contactors("cube", 3).at(0).faces.size() == 6);
  CHECK(contactors("both", 3).at(1).points[0] == Vec3(2, 0, 0));
  const Contactor3 pill = contactors("pill", 3).at(0);
  CHECK((pill.points.size() == 2 && pill.edges.size() == 1 && pill.radius == 0.5));
  CHECK_THROWS_WITH(contactors("dot", 3),
                    Catch::EndsWith("returned points = a list, expected two different points with a radius"));
  CHECK_THROWS_WITH(
      contactors("flat", 3),
      Catch::Contains("returned vertices as in 2D, expected `points` in 3D: a plugin that serves "
                      "one dimension says so, `dimension = 2` in its manifest"));
}

TEST_CASE("a shape in Lua may answer with its own mass, centre and inertia, which are checked") {
  const auto own = [](const std::string& fields) {
    OnePlugin lua("shape", "build = function() return { contactors = { radius = 1 }, " + fields + " } end");
    auto rng = stream();
    const auto made = make<ShapeModel>(lua.session, PluginKind::shape, "m", {}, 3);
    return made.model->shape_3d({}, rng).own;
  };
  const auto wrong = [&](const std::string& fields) -> std::string {
    try {
      own(fields);
    } catch (const PluginError& error) {
      const std::string text = error.what(), prefix = "plugin m, m.lua:3: build() returned ";
      return text.starts_with(prefix) ? text.substr(prefix.size()) : text;
    }
    return "";
  };
  CHECK_FALSE(own("").given());
  const OwnMass<3> all =
      own("mass = 5, centre = { 0.1, 0, 0 }, inertia = { { 2, 0.1, 0 }, { 0.1, 3, 0 }, { 0, 0, 4 } }");
  CHECK(*all.mass == 5);
  CHECK(*all.centre == Vec3(0.1, 0, 0));
  CHECK((*all.inertia)(0, 1) == 0.1);
  CHECK(wrong("mass = -1") == "mass = -1, expected a number above 0");
  CHECK(wrong("mass = 1, centre = { 0, 0, 1 }") ==
        "a centre without an inertia: expected both, because the inertia is about the centre");
  CHECK(wrong("inertia = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }") ==
        "an inertia without a mass, expected both");
  CHECK(wrong("mass = 1, inertia = 3") ==
        "inertia = 3, expected { { xx, xy, xz }, { yx, yy, yz }, { zx, zy, zz } }");
  CHECK(wrong("mass = 1, inertia = { { 1, 0.5, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }") ==
        "an inertia that is not symmetric");
  CHECK(wrong("mass = 1, inertia = { { -1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }") ==
        "an inertia with the principal moment -1, expected moments above 0");
  CHECK(wrong("mass = 1, inertia = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 3 } }")
            .starts_with("an inertia with the principal moments 1, 1 and 3, which no body has"));
}

TEST_CASE("a shape draws from the stream that it is passed") {
  OnePlugin lua("shape",
                "build = function(p, rng) return { radius = rng:uniform(1, 2) + rng:integer(1, 3) + "
                "rng:normal() * 0 } end");
  const auto made = make<ShapeModel>(lua.session, PluginKind::shape, "m", {});
  auto rng = stream(), same = stream();
  const double expected = same.uniform(1, 2) + static_cast<double>(same.integer(1, 3)) + same.normal() * 0;
  CHECK(made.model->shape({}, rng).contactors.front().radius == expected);
}

TEST_CASE("a terrain in Lua has points, parts and faces") {
  const Profile profile = terrain(
      "{ points = { {0, 5}, {1, 0}, {9, 0} }, parts = { 'face', 'floor' }, "
      "faces = { { toe = {1, 0}, crest = {0, 5} } } }");
  CHECK(profile.parts == std::vector<std::string>{"face", "floor"});
  CHECK(profile.part == std::vector<int>{0, 1});
  CHECK(profile.faces.at(0).crest.y() == 5);
  CHECK(terrain("{ points = { {0, 0}, {1, 0} } }").parts == std::vector<std::string>{""});
  CHECK_THROWS_WITH(
      terrain("{ points = { {0, 0}, {1, 0} }, parts = {} }"),
      "plugin m, m.lua:3: build() returned 0 parts, expected 1: one for each segment between two points");
  CHECK_THROWS_WITH(terrain("{ points = { {0, 0}, {-1, 0} } }"),
                    Catch::StartsWith("plugin m, m.lua:3: build() returned points: "));
}

TEST_CASE("a velocity in Lua reads the rock and the fields of the blast that it declares") {
  OnePlugin lua(
      "velocity",
      "reads = { 'blast.hole.diameter' }, params = { v = fr.number { default = 36, unit = 'km/h' } },\n"
      "launch = function(p, rock, blast, rng)\n"
      "  return { velocity = rock:direction(p.v, 0), spin = blast.hole_diameter * rock.mass } end");
  const auto made = make<VelocityModel>(lua.session, PluginKind::velocity, "m", {});
  RockView rock;
  rock.mass = 20;
  rock.outward = {-1, 0, 0};
  Blast blast;
  blast[BlastField::hole_diameter] = 0.1;
  auto rng = stream();
  const Launch launch = made.model->launch(made.values, rock, blast, rng);
  CHECK(launch.velocity.x() == Approx(-10));
  CHECK(launch.velocity.y() == Approx(0).margin(1e-12));
  CHECK(launch.spin.z() == 0.1 * 20);

  OnePlugin greedy("velocity",
                   "launch = function(p, rock, blast) return { velocity = { blast.burden, 0 } } end");
  const auto undeclared = make<VelocityModel>(greedy.session, PluginKind::velocity, "m", {});
  CHECK_THROWS_WITH(
      undeclared.model->launch({}, rock, blast, rng),
      "plugin m, m.lua:3: `blast.burden` is not declared: add \"blast.burden\" to `reads` of the manifest");
}

namespace {
TerrainShape3 terrain_3d(const std::string& answer) {
  OnePlugin lua("terrain", "build = function(p, rng, dimension) return " + answer + " end");
  auto rng = stream();
  return make<TerrainModel>(lua.session, PluginKind::terrain, "m", {}, 3).model->build_3d({}, rng);
}
}  // namespace

TEST_CASE("a terrain in Lua answers triangles with parts and faces in 3D") {
  const Mesh mesh =
      std::get<Mesh>(terrain_3d("{ vertices = { {0, 0, 5}, {4, 0, 5}, {4, 4, 1}, {0, 4, 1} }, triangles = { "
                                "{1, 2, 3}, {1, 3, 4} }, part = { 1, 2 },"
                                " parts = { 'top', 'side' }, faces = { { name = 'main', toe = { {4, 4, 1}, "
                                "{0, 4, 1} }, crest = { {4, 0, 5}, "
                                "{0, 0, 5} } } } }"));
  CHECK(mesh.vertices.size() == 4);
  CHECK(mesh.triangles[1] == std::array<int, 3>{0, 2, 3});
  CHECK(mesh.part == std::vector<int>{0, 1});
  CHECK(mesh.parts == std::vector<std::string>{"top", "side"});
  REQUIRE(mesh.faces.size() == 1);
  CHECK(mesh.faces[0].crest[1] == Vec3(0, 0, 5));
}

TEST_CASE("a terrain in Lua answers heights in 3D, rows from the south") {
  const HeightGrid grid = std::get<HeightGrid>(
      terrain_3d("{ heights = { {1, 2, false}, {dimension, 5, 6} }, cell = 2, corner = {10, 20} }"));
  CHECK((grid.columns == 3 && grid.rows == 2 && grid.cell == 2));
  CHECK(grid.corner == Vec2(10, 20));
  CHECK(grid.at(1, 0) == 2);
  CHECK(grid.at(0, 1) == 3);
  CHECK(std::isnan(grid.at(2, 0)));
}

TEST_CASE("a wrong terrain in Lua in 3D is refused with its field") {
  const std::string vertices = "{ vertices = { {0, 0, 0}, {1, 0, 0}, {0, 1, 0} }, ";
  CHECK_THROWS_WITH(terrain_3d(vertices + "triangles = { {1, 2, 4} } }"),
                    Catch::Contains("returned triangles[0][2] = 4, expected a whole number from 1 to 3"));
  CHECK_THROWS_WITH(terrain_3d(vertices + "triangles = { {1, 3, 2} } }"), Catch::Contains("faces down"));
  CHECK_THROWS_WITH(terrain_3d(vertices + "triangles = { {1, 2, 3} }, part = { 1 } }"),
                    Catch::Contains("returned one of `part` and `parts`, expected both or neither"));
  CHECK_THROWS_WITH(terrain_3d("{ heights = { {1, 2}, {1} }, cell = 1 }"),
                    Catch::Contains("returned heights[1] with 1 heights, expected 2 as in the first row"));
  CHECK_THROWS_WITH(terrain_3d("{ heights = { {1, 2}, {1, 2} } }"), Catch::Contains("returned no `cell`"));
  CHECK_THROWS_WITH(
      terrain_3d("{ points = { {1, 2}, {3, 2} } }"),
      Catch::Contains(
          "a terrain of dimension 2; dimension 3 expects `vertices` and `triangles`, or `heights`"));
  CHECK_THROWS_WITH(terrain("{ heights = { {1, 2}, {3, 2} } }"),
                    Catch::Contains("a terrain of dimension 3; dimension 2 expects `points`"));
}

TEST_CASE("a population in Lua places its rocks on the terrain") {
  OnePlugin lua("population",
                "rocks = function(p, terrain, blast, rng)\n"
                "  return { { radius = 0.5, position = { 1, terrain:height(1) + 0.5 } }, { angle = 1 },\n"
                "           { shape = { { radius = 1 }, { radius = 2 } } } } end");
  const auto made = make<Population>(lua.session, PluginKind::population, "m", {});
  Profile profile;
  profile.points = {{0, 2}, {4, 2}};
  profile.part = {0};
  profile.parts = {""};
  auto rng = stream();
  const auto rocks = made.model->rocks({}, TerrainView(profile), Blast(), rng);
  REQUIRE(rocks.size() == 3);
  CHECK(rocks[0].shape.contactors.at(0).radius == 0.5);
  CHECK(rocks[0].position->y() == 2.5);
  CHECK_FALSE(rocks[0].orientation);
  CHECK(rocks[1].shape.contactors.empty());
  CHECK(rocks[2].shape.contactors.size() == 2);
}

TEST_CASE("rocks of a population may take all from their group") {
  OnePlugin lua("population", "rocks = function(p, terrain, blast, rng) return { {}, {} } end");
  auto rng = stream();
  const auto rocks = make<Population>(lua.session, PluginKind::population, "m", {})
                         .model->rocks({}, TerrainView(Profile()), Blast(), rng);
  REQUIRE(rocks.size() == 2);
  for (const auto& rock : rocks)
    CHECK((rock.shape.contactors.empty() && !rock.position && !rock.orientation));
}

TEST_CASE("parameters of every type reach Lua") {
  OnePlugin lua("shape", R"(params = {
    n = fr.integer { default = 3 }, flag = fr.boolean { default = true }, mode = fr.choice { choices = { "a" }, default = "a" },
    at = fr.vector { optional = true }, corners = fr.points { optional = true }, left_out = fr.number { optional = true } },
  build = function(p, rng)
    assert(math.type(p.n) == "integer" and p.n == 3 and p.flag == true and p.mode == "a" and p.left_out == nil)
    assert(#p.at == 2 and p.at[1] == 5 and p.at[2] == 6)
    assert(#p.corners == 3 and p.corners[3][2] == 1)
    local names = {}
    for name in pairs(p) do names[#names + 1] = name end
    assert(table.concat(names, " ") == "at corners flag mode n")
    return { vertices = p.corners }
  end)");
  const std::vector<std::vector<double>> corners{{0, 0}, {1, 0}, {0, 1}};
  const auto made = make<ShapeModel>(lua.session, PluginKind::shape, "m",
                                     {{"at", std::vector<double>{5, 6}}, {"corners", corners}});
  auto rng = stream();
  CHECK(area_properties(made.model->shape(made.values, rng).contactors).area == Approx(0.5));
}

TEST_CASE("points of space reach Lua with all their components") {
  OnePlugin lua("velocity", R"(params = { seen = fr.points { optional = true } },
  launch = function(p, rock) return { velocity = { p.seen[2][1], p.seen[2][2], p.seen[2][#p.seen[2]] } } end)");
  const std::vector<std::vector<double>> seen{{1, 2, 3}, {4, 5, 6}};
  const auto made = make<VelocityModel>(lua.session, PluginKind::velocity, "m", {{"seen", seen}}, 3);
  RockView rock;
  rock.dimension = 3;
  auto rng = stream();
  CHECK(made.model->launch(made.values, rock, Blast(), rng).velocity == Vec3(4, 5, 6));
}
