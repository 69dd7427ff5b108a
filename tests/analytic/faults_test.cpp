// What no body can do ends its run as diverged, and says what it was. A friction law that tampers with the
// body stands for any error of the program.
#include <catch2/catch.hpp>

#include "analytic/lab.h"
#include "analytic/lab_3d.h"
#include "analytic/lab_ground.h"

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
