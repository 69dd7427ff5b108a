// The battery for plugins finds what is wrong with plugins that are made to be wrong.

#include "plugin/conformance.h"

#include <catch2/catch.hpp>
#include <limits>

#include "geometry/contactor.h"
#include "geometry/terrain_shape.h"
#include "plugin/contact_law.h"
#include "plugin/dimension_error.h"
#include "plugin/models.h"
#include "plugin/sampled_params.h"

using namespace flyrock;

namespace {

/// A rolling law with one parameter, wrong in a way of its own.
struct Wrong {
  bool reads = true, uses = true, constant = true, follows_state = false, negative = false;
};

class RollingUnderTest : public RollingLaw {
 public:
  RollingUnderTest(const Wrong& wrong, Params& params)
      : wrong_(wrong), slot_(wrong.reads ? params.slot("mu_r") : -1) {}
  bool constant() const override { return wrong_.constant; }
  std::string origin() const override { return "under_test"; }
  Rolling rolling(Values values, const ContactState& contact) const override {
    if (wrong_.negative) return {-1, 0};
    const double mu_r = wrong_.uses ? values[slot_] : 0.1;
    return {wrong_.follows_state ? mu_r * contact.radius : mu_r, 0};
  }

 private:
  Wrong wrong_;
  int slot_;
};

Plugin rolling(const Wrong& wrong) {
  Plugin plugin;
  plugin.spec.kind = PluginKind::rolling;
  plugin.spec.name = "under_test";
  ParamSpec mu_r;
  mu_r.name = "mu_r";
  mu_r.min = 0;
  plugin.spec.params = {mu_r};
  plugin.make = FactoryOf<RollingLaw>(
      [wrong](Params& params) { return std::make_unique<RollingUnderTest>(wrong, params); });
  return plugin;
}

class ShapeUnderTest : public ShapeModel {
 public:
  explicit ShapeUnderTest(std::vector<Vec2> vertices) : vertices_(std::move(vertices)) {}
  std::vector<Contactor2> build(Values, RandomStream&) const override {
    return {Contactor2::polygon(vertices_)};
  }

 private:
  std::vector<Vec2> vertices_;
};

class TerrainUnderTest : public TerrainModel {
 public:
  explicit TerrainUnderTest(TerrainShape3 shape) : shape_(std::move(shape)) {}
  TerrainShape3 build_3d(Values, RandomStream&) const override { return shape_; }

 private:
  TerrainShape3 shape_;
};

Plugin terrain(TerrainShape3 shape) {
  Plugin plugin;
  plugin.spec.kind = PluginKind::terrain;
  plugin.spec.name = "under_test";
  plugin.make = FactoryOf<TerrainModel>([shape](Params& params) {
    params.require_dimension(3);
    return std::make_unique<TerrainUnderTest>(shape);
  });
  return plugin;
}

Plugin shape(std::vector<Vec2> vertices) {
  Plugin plugin;
  plugin.spec.kind = PluginKind::shape;
  plugin.make = FactoryOf<ShapeModel>([vertices](Params& params) {
    params.require_dimension(2);
    return std::make_unique<ShapeUnderTest>(vertices);
  });
  return plugin;
}

/// A friction law whose answer is its two parameters.
class FrictionUnderTest : public FrictionLaw {
 public:
  explicit FrictionUnderTest(Params& params) : mu_s_(params.slot("mu_s")), mu_d_(params.slot("mu_d")) {}
  bool constant() const override { return true; }
  std::string origin() const override { return "under_test"; }
  Friction friction(Values values, const ContactState&) const override {
    return {values[mu_s_], values[mu_d_]};
  }

 private:
  int mu_s_, mu_d_;
};

ParamSpec number(std::string name, std::vector<ParamBound> bounds = {}) {
  ParamSpec spec;
  spec.name = std::move(name);
  spec.min = 0;
  spec.bounds = std::move(bounds);
  return spec;
}

Plugin friction(std::vector<ParamBound> bounds_of_mu_d) {
  Plugin plugin;
  plugin.spec.kind = PluginKind::friction;
  plugin.spec.name = "under_test";
  plugin.spec.params = {number("mu_d", std::move(bounds_of_mu_d)), number("mu_s")};
  plugin.make =
      FactoryOf<FrictionLaw>([](Params& params) { return std::make_unique<FrictionUnderTest>(params); });
  return plugin;
}

using Faults = std::vector<std::string>;

std::string only(const Faults& faults) {
  REQUIRE(faults.size() == 1);
  return faults.front();
}

}  // namespace

TEST_CASE("a sound law has no faults") {
  CHECK(conformance(rolling({})).faults.empty());
  CHECK(conformance(rolling({.constant = false, .follows_state = true})).faults.empty());
}

TEST_CASE("the battery finds laws that break their word") {
  CHECK_THAT(
      only(conformance(rolling({.follows_state = true})).faults),
      Catch::StartsWith(
          "says that it is constant and answers two states differently\n  asked with: approach_speed = "));
  CHECK(conformance(rolling({.uses = false})).faults == Faults{"the parameter `mu_r` changes nothing"});
  CHECK_THAT(only(conformance(rolling({.negative = true})).faults),
             Catch::StartsWith(
                 "plugin under_test: rolling() returned mu_r = -1, must be at least 0\n  asked with: ") &&
                 Catch::Contains(" (SI units)\n  parameters: mu_r = 0."));
  CHECK_THAT(only(conformance(rolling({.reads = false, .uses = false})).faults),
             Catch::StartsWith(
                 "it cannot be made with parameters within their limits: plugin under_test: declares the "
                 "parameter `mu_r` and does not read it\n  parameters: mu_r = "));
}

TEST_CASE("the battery finds shapes that are no convex polygons") {
  CHECK(conformance(shape({{0, 0}, {1, 0}, {0, 1}})).faults.empty());
  const std::string sample = "\n  asked with: the random numbers of sample 0\n  parameters: none";
  CHECK(conformance(shape({{0, 0}, {0, 1}, {1, 0}})).faults ==
        Faults{"the vertices of a polygon run clockwise" + sample});
  CHECK(conformance(shape({{0, 0}, {4, 0}, {1, 1}, {0, 4}})).faults ==
        Faults{"the polygon is not convex at the vertex (1, 1)" + sample});
}

TEST_CASE("the battery finds meshes and grids that do not fit together") {
  const std::string sample = "\n  asked with: the random numbers of sample 0\n  parameters: none";
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  mesh.part = {0};
  mesh.parts = {""};
  CHECK(conformance(terrain(mesh)).faults.empty());
  mesh.triangles[0][2] = 3;
  CHECK(conformance(terrain(mesh)).faults ==
        Faults{"in 3D triangle 0 of a mesh names the vertex 3 of 3 vertices (from 0)" + sample});
  HeightGrid grid;
  grid.columns = grid.rows = 2;
  grid.heights = {0, 1, 2, 3};
  CHECK(conformance(terrain(grid)).faults.empty());
  grid.heights[3] = std::numeric_limits<double>::quiet_NaN();
  CHECK(conformance(terrain(grid)).faults ==
        Faults{"in 3D a grid has no ground: nowhere have four neighbouring cells a height" + sample});
  grid.heights.pop_back();
  CHECK(conformance(terrain(grid)).faults == Faults{"in 3D a grid of 2 x 2 cells has 3 heights" + sample});
}

TEST_CASE("parameters that bound each other are sampled within their bounds") {
  CHECK(conformance(friction({{BoundRelation::at_most, "mu_s"}})).faults.empty());
  CHECK_THAT(only(conformance(friction({})).faults),
             Catch::Contains("must be at most mu_s\n  asked with: ") &&
                 Catch::Contains("\n  parameters: mu_d = 0.") && Catch::Contains(", mu_s = 0."));

  PluginSpec chain;  // a < b, c >= b, c <= d, an optional one below all, and two whole numbers
  chain.params = {number("a", {{BoundRelation::below, "b"}}),
                  number("b"),
                  number("c", {{BoundRelation::at_least, "b"}, {BoundRelation::at_most, "d"}}),
                  number("d"),
                  number("least", {{BoundRelation::at_most, "a"}}),
                  number("n", {{BoundRelation::above, "m"}}),
                  number("m")};
  chain.params[3].default_number = 0.1;
  chain.params[4].optional = true;
  chain.params[5].type = chain.params[6].type = ParamType::integer;
  RandomStream rng(1, "chain", {});
  for (int i = 0; i < 200; ++i) {
    const auto variants = sample_variants(chain, 2, rng);
    REQUIRE(variants.size() == 2);
    for (const auto& values : variants) CHECK(keeps_bounds(chain, values));
  }
  chain.params[1].max = 1;
  chain.params[0].min = 2;  // no a is below b
  CHECK(sample_variants(chain, 2, rng).empty());
}

TEST_CASE("the work of the battery grows with the number of parameters, not with their combinations") {
  Plugin plugin;
  plugin.spec.kind = PluginKind::rolling;
  plugin.spec.name = "many";
  for (int i = 0; i < 80; ++i) {
    plugin.spec.params.push_back(number("p" + std::to_string(i)));
    plugin.spec.params.back().optional = i % 2 == 0;
  }
  class Sum : public RollingLaw {
   public:
    bool constant() const override { return true; }
    std::string origin() const override { return "many"; }
    Rolling rolling(Values values, const ContactState&) const override {
      double sum = 0;
      for (const double value : values) sum += value;
      return {sum, 0};
    }
  };
  int made = 0;
  plugin.make = FactoryOf<RollingLaw>([&](Params& params) {
    ++made;
    for (const ParamSpec& param : plugin.spec.params) params.slot(param.name);
    return std::make_unique<Sum>();
  });
  CHECK(conformance(plugin).faults.empty());
  CHECK(made <
        1500);  // 64 choices of optional parameters, 4 samples of each in 2D and in 3D, each made twice
}

TEST_CASE("a plugin without parameters that cannot be made is at fault") {
  Plugin plugin = rolling({});
  plugin.spec.params.clear();
  plugin.make = FactoryOf<RollingLaw>(
      [](Params&) -> std::unique_ptr<RollingLaw> { throw PluginError("it remembers its calls"); });
  const Conformance found = conformance(plugin);
  CHECK(found.faults == Faults{"it cannot be made: it remembers its calls\n  parameters: none"});
  CHECK(found.not_called.empty());
}

TEST_CASE("the battery says what it could not call") {
  Plugin plugin = friction({{BoundRelation::at_most, "mu_s"}});
  CHECK(conformance(plugin).not_called.empty());

  // An optional file: everything else is called.
  ParamSpec table = number("table");
  table.type = ParamType::file;
  table.optional = true;
  plugin.spec.params.push_back(table);
  plugin.make = FactoryOf<FrictionLaw>([](Params& params) {
    params.text("table");
    return std::make_unique<FrictionUnderTest>(params);
  });
  CHECK(conformance(plugin).faults.empty());
  CHECK(conformance(plugin).not_called ==
        Faults{"it was not called with `table`, for which no value can be made up (type file)"});

  // A required one: nothing is.
  plugin.spec.params.back().optional = false;
  CHECK(conformance(plugin).faults.empty());
  CHECK(conformance(plugin).not_called ==
        Faults{"it was never called, because no value can be made up for `table` (type file): check a "
               "scenario that uses it"});
}

TEST_CASE("the battery names a dimension and a parameter with which every call is refused") {
  Plugin plugin = friction({{BoundRelation::at_most, "mu_s"}});
  ParamSpec wet = number("wet");
  wet.optional = true;
  plugin.spec.params.push_back(wet);
  plugin.make = FactoryOf<FrictionLaw>([](Params& params) {
    if (params.given("wet")) throw PluginError("wet is not written yet");
    params.slot("wet");
    return std::make_unique<FrictionUnderTest>(params);
  });
  CHECK(conformance(plugin).not_called == Faults{"it refused every call with `wet`"});

  plugin = friction({{BoundRelation::at_most, "mu_s"}});
  const auto refusing_3d = [](auto refusal) {
    return FactoryOf<FrictionLaw>([refusal](Params& params) {
      if (params.dimension() == 3) throw refusal;
      return std::make_unique<FrictionUnderTest>(params);
    });
  };
  plugin.make = refusing_3d(PluginError("no cross product"));
  CHECK(conformance(plugin).not_called ==
        Faults{"it was not called in 3D, because it refused: no cross product"});
  plugin.make = refusing_3d(DimensionError("it serves 2D"));
  CHECK(conformance(plugin).not_called.empty());
}
