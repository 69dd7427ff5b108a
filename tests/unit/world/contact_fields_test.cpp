// The fields of a contact that are there only for laws that read them: force, slip, points, shape, partner.
#include <catch2/catch.hpp>

#include "analytic/lab.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace contact_fields_test {

namespace {

/// Coulomb friction that keeps what it is asked with.
struct Witness : FrictionLaw {
  double mu = 0;
  mutable std::vector<ContactState> asked;
  bool constant() const override { return false; }
  std::string origin() const override { return "witness"; }
  Friction friction(Values, const ContactState& contact) const override {
    asked.push_back(contact);
    return {mu, mu};
  }
};

constexpr ContactReads everything{true, true, true, true, true};

/// A box on level ground, or on what is added before it, with a witness that reads `reads`.
struct Watched {
  flyrock::lab::Material material{0.5, 0};
  Witness witness;
  Bench bench;

  explicit Watched(const ContactReads& reads = everything, double mu = 0.5)
      : bench((bind(reads, mu), flyrock::lab::ground(50)), material) {}
  void bind(const ContactReads& reads, double mu) {
    witness.mu = mu;
    material.surface.friction.law = &witness;
    material.surface.friction.reads = reads;
  }
  void step(int count) {
    for (int i = 0; i < count; ++i) bench.world.step(1e-3, true);
  }
};

}  // namespace

TEST_CASE("a law sees the normal force of the last step, and none at first touch") {
  Watched watched;
  watched.bench.add(box(1, 0.2, 10, {0, 0.1}));
  watched.step(3);
  const auto& asked = watched.witness.asked;
  REQUIRE(asked.size() == 6);
  for (std::size_t i = 0; i < 6; ++i) {
    INFO(i);
    CHECK(asked[i].points == 2);
    if (i < 2)
      CHECK(std::isnan(asked[i].normal_force));
    else
      CHECK(asked[i].normal_force == Approx(10 * 9.81 / 2));
  }
}

TEST_CASE("a law sees no normal force at an impact") {
  Watched watched;
  watched.bench.add(disk(0.5, 10, {0, 0.5}, {0, -1}));
  watched.bench.world.impact();
  REQUIRE(watched.witness.asked.size() == 1);
  CHECK(std::isnan(watched.witness.asked[0].normal_force));
}

TEST_CASE("the slip length is the way that a contact has slipped since it closed") {
  Watched watched(everything, 0.5);
  Body<2> sliding = box(1, 0.02, 10, {0, 0.01});
  sliding.v = {2, 0};
  watched.bench.add(sliding);
  const double start = watched.bench.world.bodies[0].x.x();
  watched.step(50);
  const double before_last = watched.bench.world.bodies[0].x.x();
  watched.witness.asked.clear();
  watched.step(1);
  REQUIRE(watched.witness.asked.size() == 2);
  for (const ContactState& state : watched.witness.asked)
    CHECK(state.slip_length == Approx(before_last - start).epsilon(1e-9));
  // The other face closes anew
  Body<2>& body = watched.bench.world.bodies[0];
  body.move_to({body.x.x(), 0.01}, pi);
  body.v.setZero();
  watched.witness.asked.clear();
  watched.step(1);
  for (const ContactState& state : watched.witness.asked) CHECK(state.slip_length == 0);
}

TEST_CASE("a law sees the shape of the rock and whether its partner moves") {
  Watched watched;
  Body<2> plate = box(4, 0.2, 50, {0, 0.1});
  plate.kind = BodyKind::fixed;
  Body<2> rock = box(1, 0.5, 10, {0, 0.45});
  rock.shape_type = "polygon";
  watched.bench.add(plate);
  watched.bench.add(rock);
  watched.step(1);
  REQUIRE(!watched.witness.asked.empty());
  for (const ContactState& state : watched.witness.asked) {
    CHECK(state.shape_type == "polygon");
    CHECK(state.shape_corners == 4);
    CHECK(state.shape_elongation == Approx(0.5));  // of a rectangle, its sides
    CHECK(std::isnan(state.shape_flatness));
    CHECK_FALSE(state.partner_moves);
    CHECK(std::isnan(state.partner_mass));
    CHECK(state.partner_radius == plate.radius);
  }
  Watched pair;
  pair.bench.add(box(1, 0.5, 30, {0, 0.25}));
  pair.bench.add(box(1, 0.5, 10, {0, 0.75}));
  pair.step(1);
  int between = 0;
  for (const ContactState& state : pair.witness.asked) {
    if (!state.partner_moves) continue;
    ++between;
    CHECK(state.mass == 10);
    CHECK(state.partner_mass == 30);
  }
  CHECK(between == 2);
}

TEST_CASE("what a law does not read stays that of a ball that touches the terrain for the first time") {
  Watched watched(ContactReads{});
  watched.bench.add(box(1, 0.2, 10, {0, 0.1}));
  watched.step(2);
  for (const ContactState& state : watched.witness.asked) {
    CHECK(std::isnan(state.normal_force));
    CHECK(state.points == 1);
    CHECK(state.shape_corners == 0);
    CHECK(state.slip_length == 0);
  }
  CHECK_FALSE(watched.bench.world.bodies[0].proportions);
}

}  // namespace contact_fields_test
