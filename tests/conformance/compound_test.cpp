// Rocks of several parts.

#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "batch/runners.h"
#include "load.h"
#include "temporary_file.h"
#include "trial/build_trial.h"

using namespace flyrock;

namespace {

LoadedScenario from_text(const std::string& text) {
  setenv("FLYROCK_DATA", FLYROCK_SHARE_DIR, 1);
  const TemporaryFile file("compound.yaml", text);
  Diagnostics diagnostics;
  std::optional<LoadedScenario> scenario = load_scenario(file.path, {}, diagnostics);
  INFO(diagnostics.to_text());
  REQUIRE(scenario);
  return std::move(*scenario);
}

const char* const flat_2d = R"(flyrock: 1
dimension: 2
method: nscd
terrain: { type: profile, points: [[-50, 0], [50, 0]], material: rock }
materials: { rock: { restitution: { type: newton, en: 0.6 }, friction: { type: coulomb, mu: 0.4 } } }
stop: { time: 20 s }
bodies:
)";
const char* const flat_3d = R"(flyrock: 1
dimension: 3
method: nscd
terrain: { type: plane, material: rock }
materials: { rock: { restitution: { type: newton, en: 0.6 }, friction: { type: coulomb, mu: 0.4 } } }
stop: { time: 20 s }
bodies:
)";

/// The first body of a scenario, as it starts.
template <int D>
Body<D> first_body(const std::string& text) {
  const LoadedScenario scenario = from_text(text);
  return TrialBuilder<D>(scenario.plan.points.front()).build(0).worlds.front().bodies.front();
}

std::vector<Impact> impacts(const std::string& text) {
  std::vector<Impact> list;
  for (const ImpactRecord& record : first_trial(from_text(text)).impacts) list.push_back(record.impact);
  return list;
}

void same_first_impacts(const std::string& before, const std::string& shape, const std::string& twin,
                        const std::string& after) {
  const std::vector<Impact> one = impacts(before + shape + after), two = impacts(before + twin + after);
  REQUIRE((one.size() >= 10 && two.size() >= 10));
  for (std::size_t i = 0; i < 10; ++i) {
    INFO("impact " << i + 1 << " at " << one[i].time << " s");
    CHECK(two[i].time == Approx(one[i].time).epsilon(1e-9));
    CHECK((two[i].place - one[i].place).norm() < 1e-9);
    CHECK(two[i].pn == Approx(one[i].pn).epsilon(1e-9));
    CHECK(two[i].pt == Approx(one[i].pt).epsilon(1e-9).margin(1e-9 * one[i].pn));
    CHECK(two[i].vn_after == Approx(one[i].vn_after).epsilon(1e-9).margin(1e-12));
  }
}

}  // namespace

TEST_CASE("an L of two boxes has the centre and the inertia of the sum, in 2D") {
  const Body<2> body = first_body<2>(flat_2d + std::string(R"(
  - name: l
    density: 1000
    thickness: 0.5
    position: [0, 5]
    shape:
      type: compound
      parts:
        - { type: polygon, vertices: [[0, 0], [1, 0], [1, 0.2], [0, 0.2]] }
        - { type: polygon, vertices: [[0, -0.1], [0.8, -0.1], [0.8, 0.1], [0, 0.1]], at: [0.1, 0.2], turn: 90 deg }
)"));
  // Areas 0.2 and 0.16, centres (0.5, 0.1) and (0.1, 0.6).
  const double area = 0.36, x = (0.2 * 0.5 + 0.16 * 0.1) / area, y = (0.2 * 0.1 + 0.16 * 0.6) / area;
  const double moment = 0.2 * (1.04 / 12 + (0.5 - x) * (0.5 - x) + (0.1 - y) * (0.1 - y)) +
                        0.16 * (0.68 / 12 + (0.1 - x) * (0.1 - x) + (0.6 - y) * (0.6 - y));
  CHECK(body.volume == Approx(area * 0.5).epsilon(1e-14));
  CHECK(body.mass == Approx(1000 * area * 0.5).epsilon(1e-14));
  CHECK(body.inertia == Approx(1000 * 0.5 * moment).epsilon(1e-14));
  REQUIRE(body.contactors.size() == 2);
  CHECK((body.contactors[0].points[0] - Vec2(-x, -y)).norm() < 1e-15);
  CHECK((body.contactors[1].points[0] - Vec2(0.2 - x, 0.2 - y)).norm() < 1e-15);  // turned anticlockwise
  CHECK((body.contactors[1].normals[0] - Vec2(1, 0)).norm() < 1e-15);
}

TEST_CASE("an L of two boxes has the centre and the inertia of the sum, in 3D") {
  const Body<3> body = first_body<3>(flat_3d + std::string(R"(
  - name: l
    density: 1000
    position: [0, 0, 5]
    shape:
      type: compound
      parts:
        - { type: box, size: [1, 0.3, 0.2], at: [0.5, 0, 0.1] }
        - { type: box, size: [0.8, 0.3, 0.2], at: [0.1, 0, 0.6], turn: { axis: [0, 1, 0], angle: -90 deg } }
)"));
  const double volume = 0.06 + 0.048;
  const Vec3 centre = (0.06 * Vec3(0.5, 0, 0.1) + 0.048 * Vec3(0.1, 0, 0.6)) / volume;
  const auto tensor = [&](double mass, const Vec3& size, const Vec3& at) {
    const Vec3 arm = at - centre, square = size.cwiseAbs2();
    const Vec3 own(square.y() + square.z(), square.x() + square.z(), square.x() + square.y());
    return Eigen::Matrix3d(mass / 12 * Eigen::Matrix3d(own.asDiagonal()) +
                           mass * (arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose()));
  };
  const Eigen::Matrix3d expected =
      1000 * (tensor(0.06, {1, 0.3, 0.2}, {0.5, 0, 0.1}) + tensor(0.048, {0.2, 0.3, 0.8}, {0.1, 0, 0.6}));
  const Eigen::Matrix3d axes = body.attitude.rotation.matrix();
  CHECK(body.mass == Approx(1000 * volume).epsilon(1e-14));
  CHECK((axes * body.inertia.asDiagonal() * axes.transpose() - expected).norm() < 1e-12 * expected.norm());
  Vec3 low = body.pose() * body.contactors[0].points[0], high = low;
  for (const auto& contactor : body.contactors)
    for (const Vec3& point : contactor.points) {
      low = low.cwiseMin(body.pose() * point);
      high = high.cwiseMax(body.pose() * point);
    }
  CHECK((low - (Vec3(0, -0.15, 0) - centre + body.x)).norm() < 1e-12);
  CHECK((high - (Vec3(1, 0.15, 1) - centre + body.x)).norm() < 1e-12);
}

TEST_CASE("a quaternion and an axis turn a part alike, and a compound may hold a compound") {
  const std::string before = flat_3d + std::string("  - name: b\n    density: 1\n    position: [0, 0, 9]\n");
  const auto contactor = [&](const std::string& parts) {
    const Body<3> body = first_body<3>(before + "    shape: { type: compound, parts: " + parts + " }\n");
    REQUIRE(body.contactors.size() == 2);
    std::vector<Vec3> places;
    for (const Vec3& point : body.contactors[1].points) places.push_back(body.pose() * point);
    return places;
  };
  const auto plain = contactor(
      "[{ type: sphere, radius: 1 }, { type: box, size: [1, 2, 3], at: [1, 0, 0], turn: { axis: [0, 0, 2], "
      "angle: 60 deg } }]");
  const auto others = {
      contactor("[{ type: sphere, radius: 1 }, { type: box, size: [1, 2, 3], at: [1, 0, 0], turn: "
                "[1.7320508075688772, 0, 0, 1] }]"),
      contactor(
          "[{ type: sphere, radius: 1 }, { type: compound, at: [1, 0, 0], turn: { axis: [0, 0, 1], angle: "
          "20 deg }, parts: [{ type: box, size: [1, 2, 3], turn: { axis: [0, 0, 1], angle: 40 deg } }] }]")};
  for (const auto& other : others)
    for (std::size_t i = 0; i < plain.size(); ++i) CHECK((other[i] - plain[i]).norm() < 1e-12);
}

TEST_CASE("a box of two halves bounces as the box: the same first 10 impacts, in 2D") {
  same_first_impacts(flat_2d, R"(  - name: box
    shape: { type: polygon, vertices: [[-0.5, -0.3], [0.5, -0.3], [0.5, 0.3], [-0.5, 0.3]] }
)",
                     R"(  - name: box
    shape:
      type: compound
      parts:
        - { type: polygon, vertices: [[-0.25, -0.3], [0.25, -0.3], [0.25, 0.3], [-0.25, 0.3]], at: [-0.25, 0] }
        - { type: polygon, vertices: [[-0.25, -0.3], [0.25, -0.3], [0.25, 0.3], [-0.25, 0.3]], at: [0.25, 0] }
)",
                     R"(    density: 2700
    position: [0, 3]
    velocity: [2, 0]
    spin: 3
    orientation: 0.3 rad
)");
}

TEST_CASE("a box of two halves bounces as the box: the same first 10 impacts, in 3D") {
  same_first_impacts(flat_3d, R"(  - name: box
    shape: { type: box, size: [1, 0.6, 0.4] }
)",
                     R"(  - name: box
    shape:
      type: compound
      parts:
        - { type: box, size: [0.5, 0.6, 0.4], at: [-0.25, 0, 0] }
        - { type: box, size: [0.5, 0.6, 0.4], at: [0.25, 0, 0] }
)",
                     R"(    density: 2700
    position: [0, 0, 3]
    velocity: [2, 1, 0]
    spin: [3, -1, 2]
    orientation: { axis: [1, 2, 3], angle: 0.7 rad }
)");
}

TEST_CASE("a ball falls into a bowl of three boxes and stays on its floor") {
  const TrialRecords records = first_trial(from_text(R"(flyrock: 1
dimension: 3
method: nscd
terrain: { type: plane, material: rock }
materials: { rock: { restitution: { type: newton, en: 0.3 }, friction: { type: coulomb, mu: 0.4 } } }
pairs: [{ between: [ball, bowl], material: rock }]
stop: { time: 3 s }
bodies:
  - name: bowl
    fixed: true
    position: [0, 0, 1]
    shape:
      type: compound
      parts:
        - { type: box, size: [1, 1, 0.2] }
        - { type: box, size: [0.2, 1, 1], at: [-0.6, 0, 0.4] }
        - { type: box, size: [0.2, 1, 1], at: [0.6, 0, 0.4] }
  - { name: ball, shape: { type: sphere, radius: 0.3 }, mass: 10, position: [0.05, 0, 2.5] }
)"));
  // Volumes 0.2, 0.2, 0.2: the centre of the bowl, which stands at z = 1, is 0.8/3 above that of its floor.
  CHECK(records.rocks.at(0).stop_z == Approx(1 - 0.8 / 3 + 0.1 + 0.3).margin(1e-5));
}

TEST_CASE("parts that overlap are warned of with their depth, parts that touch are not") {
  const auto warnings = [](double apart) {
    LoadedScenario scenario = from_text(flat_2d + fmt::format(R"(
  - name: pair
    mass: 1
    position: [0, 9]
    shape: {{ type: compound, parts: [{{ type: disk, radius: 0.3 }}, {{ type: disk, radius: 0.3, at: [{}, 0] }}] }}
)",
                                                              apart));
    Diagnostics diagnostics;
    try_runners(scenario, 1, diagnostics);
    std::string texts;
    for (const Diagnostic& one : diagnostics.all()) texts += one.path + ": " + one.text + '\n';
    return texts;
  };
  CHECK(warnings(0.6).empty());
  CHECK(warnings(0.5) ==
        "bodies.0.shape: contactors 0 and 1 of `pair` overlap by 0.1 m: mass, centre and inertia count what "
        "they share twice; expected parts that at most touch, or a shape with an inertia of its own\n");
}
