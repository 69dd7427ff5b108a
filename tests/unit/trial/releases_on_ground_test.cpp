// Releases on benches: where rocks start, and that the origin changes nothing.

#include <catch2/catch.hpp>

#include "load.h"
#include "trial/build_trial.h"
#include "trial/start_checks.h"
#include "unit/lua_fixture.h"

using namespace flyrock;

namespace {

constexpr double face_angle = 70 * pi / 180, face_run = 4.367642811;  // 12 m / tan(70 deg)

/// The least distance of a rock from a plane through `point` with the unit normal `normal`.
double gap(const Body<3>& rock, const Vec3& point, const Vec3& normal) {
  double least = 1e300;
  for (const Contactor3& contactor : rock.contactors)
    for (const Vec3& local : contactor.points)
      least = std::min(least, normal.dot(rock.pose() * local - point) - contactor.radius);
  return least;
}

}  // namespace

TEST_CASE("rocks start on faces, at collars, on bench tops, in zones and on the ground of benches in 3D") {
  const LoadedScenario scenario = loaded("tests/unit/trial/benches_3d.yaml");
  TrialBuilder<3> builder(scenario.plan.points.front());
  double least_y = 1e300, greatest_y = -1e300, least_z = 1e300, greatest_z = -1e300;
  for (int k = 0; k < 300; ++k) {
    auto trial = builder.build(k);
    REQUIRE(trial.rocks.size() == 10);
    for (const TrialRock& rock : trial.rocks) REQUIRE(rock.fault == "");
    for (auto& world : trial.worlds) REQUIRE_FALSE(start_fault(world));
    const auto body = [&](int i) -> const Body<3>& { return trial.worlds[i].bodies[0]; };
    // Bench 2 runs from (face_run + 8, 12 m) to (2 face_run + 8, 0).
    const Vec3 out(std::sin(face_angle), 0, std::cos(face_angle)), toe(2 * face_run + 8, 0, 0);
    CHECK(gap(body(0), toe, out) == Approx(0).margin(1e-8));
    CHECK(gap(body(0), {0, 30, 0}, {0, -1, 0}) > -1e-9);
    CHECK(gap(body(0), {0, -30, 0}, {0, 1, 0}) > -1e-9);
    least_y = std::min(least_y, body(0).x.y());
    greatest_y = std::max(greatest_y, body(0).x.y());
    least_z = std::min(least_z, body(0).x.z());
    greatest_z = std::max(greatest_z, body(0).x.z());
    CHECK(body(0).v.normalized().z() == Approx(std::sin(20 * pi / 180)));
    CHECK(body(0).v.y() == Approx(0).margin(1e-12));
    for (int i = 1; i < 4; ++i)  // rock i of the trial belongs to hole i mod 3
      CHECK((body(i).x - Vec3(-3, 4 * (i % 3 - 1), 24.3)).norm() < 1e-8);
    if (body(4).x.x() < face_run + 7.6)  // nearer to the crest a corner may hang over it
      CHECK(gap(body(4), {0, 0, 12}, Vec3::UnitZ()) == Approx(0).margin(1e-8));
    CHECK((body(4).x.x() <= face_run + 8 && body(4).x.x() >= face_run + 5));
    CHECK(gap(body(5), Vec3::Zero(), Vec3::UnitZ()) == Approx(0).margin(1e-8));
    CHECK((body(5).x.x() >= 40 && body(5).x.x() <= 50 && std::abs(body(5).x.y()) <= 10));
    CHECK((body(6).x - Vec3(0, 2, 24.3)).norm() < 1e-8);
    CHECK(body(7).x.z() == Approx(1));
    CHECK(body(7).x.x() - 40 == Approx(body(7).x.y()).margin(1e-9));
    CHECK(body(8).x.z() == Approx(0.3));
    CHECK((body(9).x.z() == Approx(2) && body(9).x.x() >= 40 && body(9).x.x() <= 50));
  }
  CHECK((least_y < -28 && greatest_y > 28 && least_z < 1 && greatest_z > 11));
}

TEST_CASE("the origin of a terrain changes no result") {
  LoadedScenario scenario = loaded("tests/unit/trial/benches_3d.yaml");
  const TrialRecords near = first_trial(scenario);
  TerrainPlan& terrain = scenario.plan.points.front().terrain;
  terrain.origin = {100, 200, 10};
  terrain.text += " from another origin";  // which is another ground
  const TrialRecords far = first_trial(scenario);
  REQUIRE(near.rocks.size() == far.rocks.size());
  for (std::size_t i = 0; i < near.rocks.size(); ++i) {
    INFO(near.rocks[i].fault << far.rocks[i].fault);
    CHECK(far.rocks[i].start_x == Approx(near.rocks[i].start_x).margin(1e-9));
    CHECK(far.rocks[i].stop_x == Approx(near.rocks[i].stop_x).margin(1e-6));
    CHECK(far.rocks[i].stop_y == Approx(near.rocks[i].stop_y).margin(1e-6));
    CHECK(far.rocks[i].stop_z == Approx(near.rocks[i].stop_z).margin(1e-6));
  }
}

TEST_CASE("rocks stand on a bench in 2D that is not level, at collars and anywhere on its top") {
  const LuaFixture folder;
  folder.write("bench.yaml", R"(flyrock: 1
dimension: 2
method: nscd
terrain:
  type: profile
  points: [[-30, 15], [-5, 12.5], [-4, 12.8], [0, 12], [4, 0], [60, 0]]
  faces: [{ name: main, from: 0, to: 4 }]
  material: rock
materials: { rock: { friction: { type: coulomb, mu: 0.5 }, rolling: { type: rolling_resistance, mu_r: 0.1 m } } }
blast: { burden: 3 m, spacing: 4 m, rows: { count: 3, distance: 3 m, holes: 2 } }
rocks:
  - { name: round, per_trial: 6, density: 2700, shape: { type: disk, radius: 0.4 }, release: { from: collar, face: main } }
  - { name: square, per_trial: 6, density: 2700, shape: { type: polygon, sides: 4, diameter: 0.8 }, release: { from: bench_top, face: main } }
stop: { time: 1 s }
)");
  Diagnostics diagnostics;
  const auto scenario = load_scenario((folder.folder / "bench.yaml").string(), {}, diagnostics);
  INFO(diagnostics.to_text());
  REQUIRE(scenario);
  TrialBuilder<2> builder(scenario->plan.points.front());
  for (int k = 0; k < 50; ++k) {
    auto trial = builder.build(k);
    REQUIRE(trial.rocks.size() == 12);
    for (const TrialRock& rock : trial.rocks) CHECK(rock.fault == "");
    for (auto& world : trial.worlds) {
      CHECK_FALSE(start_fault(world));
      Body<2> lower = world.bodies[0];
      lower.x.y() -= 1e-6;
      World<2> below(world.terrain(), world.gravity(), world.settings());
      below.add(std::move(lower));
      if (world.bodies[0].x.x() < -0.5)  // nearer to the crest a corner may hang over it
        CHECK(below.deepest_overlap().depth > 1e-7);
    }
  }
}
