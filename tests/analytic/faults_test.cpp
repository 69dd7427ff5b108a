// What no body can do ends its run as diverged, and says what it was. A friction law that tampers with the
// body stands for any error of the program.
#include <catch2/catch.hpp>

#include "analytic/lab.h"
#include "analytic/lab_3d.h"
#include "analytic/lab_ground.h"
#include "dice.h"

using namespace flyrock;
using namespace flyrock::lab;
using Catch::Matchers::Contains;

namespace {

struct Tampering : FrictionLaw {
  std::function<void()> tamper;
  bool constant() const override { return false; }
  std::string origin() const override { return "tampering"; }
  Friction friction(Values, const ContactState&) const override {
    tamper();
    return {0.5, 0.5};
  }
};

template <class BenchType, class BodyType>
void tamper(BenchType& bench, Material& material, BodyType body, const std::function<void(BodyType&)>& change,
            const char* fault) {
  Tampering law;
  law.tamper = [&] { change(bench.world.bodies[0]); };
  material.surface.friction.law = &law;
  bench.add(std::move(body));
  const BodyHistory& history = bench.run(5);
  CHECK(history.reason == StopReason::diverged);
  CHECK_THAT(history.fault, Contains(fault));
}

}  // namespace

TEST_CASE("a body below the ground has diverged") {
  Material material(0.5, 0.5);
  Bench bench(ground(10), material);
  tamper<Bench, Body<2>>(
      bench, material, disk(0.1, 1, {0, 1}), [](Body<2>& b) { b.x.y() = -0.5; }, "below the ground");
  Bench3 bench3(plane(0.3), material);
  tamper<Bench3, Body<3>>(
      bench3, material, sphere(0.1, 1, {0, 0, 1}), [](Body<3>& b) { b.x.z() -= 0.5; }, "below the ground");
}

TEST_CASE("a compound that straddles a peak is not below the ground, until all of it is") {
  Material material(0.5, 0.5);
  Profile peak;
  peak.points = {{-9, 0}, {-0.3, 0}, {0, 2}, {0.3, 0}, {9, 0}};
  peak.part = {0, 0, 0, 0};
  peak.parts = {""};
  const Contactor2 right = Contactor2::wall({0.7, 0}, {0.71, 0}, 0.1),
                   left = Contactor2::wall({-0.71, 0}, {-0.7, 0}, 0.1);
  Body<2> dumbbell = make_body({left, right}, 0, 1, 0);
  dumbbell.x = {0, 0.6};
  Bench bench(peak, material);
  bench.add(dumbbell);
  CHECK(bench.run(5).reason == StopReason::stopped);
  Material other(0.5, 0.5);
  Bench below(peak, other);
  tamper<Bench, Body<2>>(
      below, other, dumbbell, [](Body<2>& b) { b.x.y() = -0.5; }, "below the ground");
  // Two coins: they have rims, and no points.
  Contactor3 front = Contactor3::cylinder(0.1, 0.02), back = front;
  front.change_frame({-0.71, 0, 0}, {});
  back.change_frame({0.71, 0, 0}, {});
  Body<3> coins = make_body({front, back}, 0, 1);
  coins.x = {0, 0, 0.6};
  Bench3 ridge(extruded(peak, 10, 2), material);
  ridge.add(coins);
  CHECK(ridge.run(5).reason == StopReason::stopped);
  Bench3 below_ridge(extruded(peak, 10, 2), other);
  tamper<Bench3, Body<3>>(
      below_ridge, other, coins, [](Body<3>& b) { b.x.z() = -0.5; }, "below the ground");
}

TEST_CASE(
    "a body below the ground has diverged also where its path ends at a barrier or leaves the terrain") {
  Material material(0.5, 0.5);
  const auto sink = [](auto& body, double x) {
    constexpr int up = std::decay_t<decltype(body.x)>::RowsAtCompileTime - 1;
    body.x[0] = x;
    body.x[up] -= 0.5;
  };
  for (const double x : {9.99, 4.99}) {
    const std::vector<Barrier> fence{{5, 20, 1e9}};
    Bench bench(ground(10), material);
    bench.run_settings.barriers = fence;
    tamper<Bench, Body<2>>(
        bench, material, disk(0.1, 1, {0, 1}, {5, 0}), [&](Body<2>& b) { sink(b, x); }, "below the ground");
    CHECK(bench.histories[0].barriers.empty());
    Bench3 bench3(extruded(ground(10), 10, 2), material);
    bench3.run_settings.barriers = fence;
    tamper<Bench3, Body<3>>(
        bench3, material, sphere(0.1, 1, {0, 0, 1}, {5, 0, 0}), [&](Body<3>& b) { sink(b, x); },
        "below the ground");
    CHECK(bench3.histories[0].barriers.empty());
  }
}

TEST_CASE("a body with energy from nowhere has diverged") {
  Material material(0.5, 0.5);
  Bench bench(ground(10), material);
  tamper<Bench, Body<2>>(
      bench, material, disk(0.1, 1, {0, 1}), [](Body<2>& b) { b.v.x() += 5; }, "J more than");
  Bench3 bench3(plane(), material);
  tamper<Bench3, Body<3>>(
      bench3, material, sphere(0.1, 1, {0, 0, 1}), [](Body<3>& b) { b.w.x() += 500; }, "J more than");
}

TEST_CASE("what impacts gain by their law is no energy from nowhere") {
  Material material(1.2, 0);
  Bench bench(ground(10), material);
  bench.add(disk(0.1, 1, {0, 1.1}));
  const BodyHistory& ball = bench.run(5);
  CHECK(ball.reason == StopReason::timed_out);
  CHECK(bench.world.quality().energy_gains > 3);
}

TEST_CASE("the work of a driven body is no energy from nowhere") {
  Material material(0.5, 0.5);
  Bench bench(ground(10), material);
  Body<2> ram = disk(0.2, 1, {-1, 0.2}, {3, 0});
  ram.kind = BodyKind::driven;
  bench.add(disk(0.1, 1, {0, 0.1}));
  bench.add(ram);
  const BodyHistory& pushed = bench.run(1);
  CHECK(pushed.max_speed > 3);
  CHECK(pushed.reason == StopReason::timed_out);
}

namespace {

/// Bodies that fly far apart from each other through air, to the end of the ground, a barrier and a tree.
template <int D>
std::vector<Body<D>> apart(Dice& dice) {
  std::vector<Body<D>> bodies;
  for (int i = 0; i < 5; ++i) {
    Vec<D> at = Vec<D>::Zero(), velocity = Vec<D>::Zero();
    at[0] = -30 + 6 * i;
    at[D - 1] = 4 + 8 * i;
    velocity[0] = dice(15, 25);
    velocity[D - 1] = dice(-5, 15);
    Body<D> body;
    if constexpr (D == 2) {
      body = disk(0.5, 100, at, velocity, dice(-3, 3));
    } else {
      at[1] = 3 * i - 6;
      body = sphere(0.5, 100, at, velocity, {dice(-3, 3), 0, dice(-3, 3)});
    }
    body.volume = 0.5;
    body.air.drag = 0.02;
    body.air.wind[0] = dice(-10, 10);
    bodies.push_back(body);
  }
  return bodies;
}

/// What becomes of the bodies in one world.
template <int D, class BenchType, class GroundType>
std::vector<BodyHistory> together(const GroundType& shape, std::span<const Body<D>> bodies,
                                  std::span<const Barrier> barriers, const RunForest& forest) {
  Material material(0.3, 0.6, 0.1);
  WorldSettings settings;
  settings.step_tolerance = 1e-3;
  settings.body_contacts = false;  // they never touch
  BenchType bench(shape, material, settings);
  bench.run_settings.barriers = barriers;
  bench.run_settings.forest = forest;
  for (const Body<D>& body : bodies) bench.add(body);
  bench.run(30);
  return bench.histories;
}

template <int D, class BenchType, class GroundType>
void check_alone_and_together(const GroundType& shape, Dice& dice, std::span<const Barrier> barriers,
                              const RunForest& forest) {
  const std::vector<Body<D>> bodies = apart<D>(dice);
  const auto all = together<D, BenchType>(shape, std::span(bodies), barriers, forest);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    CAPTURE(D, i);
    const BodyHistory one =
        together<D, BenchType>(shape, std::span(bodies).subspan(i, 1), barriers, forest)[0];
    INFO(all[i].fault);
    CHECK(all[i].reason == one.reason);
    CHECK(all[i].barriers.size() == one.barriers.size());
    CHECK(all[i].trees.size() == one.trees.size());
    // A step in contact, of up to 20 ms, ends beyond the end of the ground.
    const double beyond = one.reason == StopReason::left_domain ? 0.02 * one.last.velocity.norm() : 0;
    CHECK((all[i].last.position - one.last.position).norm() < 0.01 + beyond);
  }
}

}  // namespace

TEST_CASE(
    "bodies that never touch end as each alone, also in air, at the end of the ground, a barrier or a tree") {
  const std::vector<Barrier> none, weak{{10, 60, 3000}}, strong{{10, 60, 1e9}};
  std::vector<Stem> stems;
  for (int i = 0; i < 60; ++i) stems.push_back({Vec2(12 + i % 3, 0.5 * i - 15), 0.4, 60});
  const Forest forest(std::move(stems));
  const RunForest no_trees, catching{&forest, {.fixed = true, .energy = 1e9}},
      slowing{&forest, {.fixed = true, .energy = 2000}};
  for (unsigned seed = 1; seed <= 5; ++seed)
    for (const auto& barriers : {none, weak, strong})
      for (const RunForest& trees : {no_trees, catching, slowing}) {
        if (!barriers.empty() && trees.forest) continue;
        CAPTURE(seed, barriers.size(), trees.law.energy);
        Dice in_plane(seed), in_space(seed);
        check_alone_and_together<2, Bench>(ground(40), in_plane, barriers, no_trees);
        check_alone_and_together<3, Bench3>(extruded(ground(40), 30, 2), in_space, barriers, trees);
      }
}
