// The battery for plugins finds what is wrong with plugins that are made to be wrong.

#include "plugin/conformance.h"

#include <catch2/catch.hpp>

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

Plugin shape(std::vector<Vec2> vertices) {
  Plugin plugin;
  plugin.spec.kind = PluginKind::shape;
  plugin.make =
      FactoryOf<ShapeModel>([vertices](Params& params) {
    params.require_dimension(2);
    return std::make_unique<ShapeUnderTest>(vertices);
  });
  return plugin;
}

using Faults = std::vector<std::string>;

}  // namespace

TEST_CASE("a sound law has no faults") {
  CHECK(conformance_faults(rolling({})).empty());
  CHECK(conformance_faults(rolling({.constant = false, .follows_state = true})).empty());
}

TEST_CASE("the battery finds laws that break their word") {
  CHECK(conformance_faults(rolling({.follows_state = true})) ==
        Faults{"says that it is constant and answers two states differently"});
  CHECK(conformance_faults(rolling({.uses = false})) == Faults{"the parameter `mu_r` changes nothing"});
  CHECK(conformance_faults(rolling({.negative = true})) ==
        Faults{"plugin under_test: rolling() returned mu_r = -1, must be at least 0"});
  CHECK(
      conformance_faults(rolling({.reads = false, .uses = false})) ==
      Faults{
          "it cannot be made with parameters within their limits: plugin under_test: declares the parameter "
          "`mu_r` and does not read it"});
}

TEST_CASE("the battery finds shapes that are no convex polygons") {
  CHECK(conformance_faults(shape({{0, 0}, {1, 0}, {0, 1}})).empty());
  CHECK(conformance_faults(shape({{0, 0}, {0, 1}, {1, 0}})) ==
        Faults{"the vertices of a polygon run clockwise"});
  CHECK(conformance_faults(shape({{0, 0}, {4, 0}, {1, 1}, {0, 4}})) ==
        Faults{"the polygon is not convex at the vertex (1, 1)"});
}
