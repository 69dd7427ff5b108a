// Whose quantities a law reads: those of the body that moves, of two of the lighter one, in any order of the
// bodies.
#include <catch2/catch.hpp>

#include "analytic/lab_3d.h"

using namespace flyrock;
using namespace flyrock::lab;

namespace rock_of_test {

using flyrock::lab::Material;

namespace {

/// Keeps what it is asked with.
struct Probe : FrictionLaw {
  mutable std::vector<ContactState> asked;
  bool constant() const override { return false; }
  std::string origin() const override { return "probe"; }
  Friction friction(Values, const ContactState& contact) const override {
    asked.push_back(contact);
    return {0.4, 0.4};
  }
};

/// The state of the only contact of two bodies at their impact, and its row among the impacts.
template <int D, class Bench>
std::pair<ContactState, Impact> met(Bench& bench, Material& material, Probe& probe, Body<D> first,
                                    Body<D> second) {
  material.surface.friction.law = &probe;
  bench.add(std::move(first));
  bench.add(std::move(second));
  bench.world.impact();
  REQUIRE(probe.asked.size() == 1);
  REQUIRE(bench.world.impacts().size() == 1);
  return {probe.asked[0], bench.world.impacts()[0]};
}

Body<2> named(const char* name, Body<2> body) {
  body.group = name;
  return body;
}

Body<2> fixed(Body<2> body) {
  body.kind = BodyKind::fixed;
  return body;
}

/// Checks that of two bodies in the plane the laws read `rock`, whichever of them is the first.
void check_rock(const Body<2>& rock, const Body<2>& other) {
  for (const bool rock_first : {true, false}) {
    INFO(rock.group << (rock_first ? " first" : " second"));
    Material material(0.5, 0);
    Probe probe;
    Bench bench(flyrock::lab::ground(50), material, {}, {0, 0});
    const auto [state, impact] =
        met<2>(bench, material, probe, rock_first ? rock : other, rock_first ? other : rock);
    CHECK(state.group_a == rock.group);
    CHECK(state.group_b == other.group);
    CHECK(state.mass == rock.mass);
    CHECK(state.radius == rock.radius);
    CHECK(state.spin == spin_speed(rock.w));
    CHECK(state.kinetic_energy == Approx(rock.kinetic_energy()));
    CHECK(state.impact_number == 1);
    CHECK(state.normal.dot(Vec3(rock.x.x() - other.x.x(), rock.x.y() - other.x.y(), 0)) > 0);
    const Vec2 n = state.normal.head<2>();
    const Vec2 v = rock.velocity_at(state.place.head<2>()) - other.velocity_at(state.place.head<2>());
    CHECK((state.slip.head<2>() - (v - v.dot(n) * n)).norm() < 1e-12);
    CHECK(impact.body == (rock_first ? 0 : 1));
    CHECK(impact.other == (rock_first ? 1 : 0));
  }
}

}  // namespace

TEST_CASE("a law reads the body that moves, not the plate on which it falls") {
  check_rock(named("ball", disk(0.1, 10, {0, 5.6}, {2, -1}, -20)),
             named("plate", fixed(box(4, 1, 1, {0, 5}))));
}

TEST_CASE(
    "of two bodies that move, a law reads the lighter, then the smaller, then the slower, then by name") {
  const auto left = [](double radius, double mass, double speed, double spin) {
    return disk(radius, mass, {-radius, 5}, {speed, 0.5}, spin);
  };
  const auto right = [](double radius, double mass, double speed, double spin) {
    return disk(radius, mass, {radius, 5}, {-speed, 0}, spin);
  };
  check_rock(named("light", left(0.5, 1, 2, 3)), named("heavy", right(0.1, 2, 1, 5)));
  check_rock(named("small", left(0.1, 2, 2, 3)), named("large", right(0.5, 2, 1, 5)));
  check_rock(named("slow", left(0.5, 2, 1, 0)), named("fast", right(0.5, 2, 3, 0)));
  // Their energies differ by rounding.
  check_rock(named("a", disk(0.5, 2, {-0.5, 5}, {1, 0})),
             named("b", disk(0.5, 2, {0.5, 5}, {-1 - 1e-15, 0})));
}

TEST_CASE("in 3D the smaller of two spheres bears rolling resistance by its own radius in either order") {
  for (const bool small_first : {true, false}) {
    Material material(0.5, 0);
    Probe probe;
    Bench3 bench(plane(), material, {}, {0, 0, 0});
    Body<3> small = sphere(0.05, 1, {0.55, 0, 5}, {-1, 0, 0}, {0, -7, 1}),
            big = sphere(0.5, 10, {0, 0, 5}, {1, 0, 0}, {0, 3, 0});
    const auto [state, impact] =
        met<3>(bench, material, probe, small_first ? small : big, small_first ? big : small);
    CHECK(state.radius == 0.05);
    CHECK(state.spin == Approx(std::sqrt(50.0)));
    CHECK(state.normal.x() == Approx(1));
    CHECK(state.slip.z() == Approx(0.05 * -7 + 0.5 * 3));
    CHECK(impact.body == (small_first ? 0 : 1));
  }
}

}  // namespace rock_of_test
