#include "batch/inputs.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "load.h"
#include "trial/build_trial.h"

using namespace flyrock;

namespace {

/// The inputs of one rock of the first trial: path -> values by impact; 0 for the rock.
std::map<std::string, std::map<int, double>> inputs_of_rock(const TrialRecords& records,
                                                            const Scenario& scenario, int rock) {
  const std::vector<Input> list = inputs_of(scenario);
  std::map<std::string, std::map<int, double>> inputs;
  for (const InputRecord& row : records.inputs)
    if (row.rock == rock) inputs[list.at(static_cast<std::size_t>(row.input)).path][row.impact] = row.value;
  return inputs;
}

}  // namespace

TEST_CASE("each impact has its own draws among the inputs, and is computed with them") {
  const LoadedScenario scenario = loaded("tests/unit/batch/drawn_2d.yaml");
  const TrialRecords records = first_trial(scenario);
  const auto inputs = inputs_of_rock(records, scenario.plan.points.front(), 0);
  const auto& e_n = inputs.at("materials.ground.restitution.en");
  const auto& mu = inputs.at("materials.ground.friction.mu");
  CHECK_FALSE(e_n.contains(0));
  int compared = 0;
  for (const ImpactRecord& row : records.impacts) {
    if (row.rock != 0) continue;
    REQUIRE(e_n.contains(row.impact.number));
    CHECK(mu.contains(row.impact.number));
    CHECK(-row.impact.vn_after / row.impact.vn_before == Approx(e_n.at(row.impact.number)).epsilon(1e-6));
    ++compared;
  }
  CHECK(compared >= 3);
  CHECK(e_n.size() == static_cast<std::size_t>(compared));
}

TEST_CASE("a rock has the draws of its own group, and of what plugins draw the outcome") {
  const LoadedScenario scenario = loaded("tests/unit/batch/drawn_2d.yaml");
  const Scenario& point = scenario.plan.points.front();
  const TrialRecords records = first_trial(scenario);
  const auto ball = inputs_of_rock(records, point, 0), other = inputs_of_rock(records, point, 1);
  CHECK(ball.contains("rocks.balls.density"));
  CHECK_FALSE(ball.contains("rocks.others.density"));
  CHECK(other.contains("rocks.others.density"));
  CHECK_FALSE(other.contains("rocks.balls.density"));
  CHECK(ball.at("release.x").at(0) == records.rocks[0].start_x);
  CHECK(ball.at("release.y").at(0) == 5);
  CHECK(ball.at("rock.orientation").at(0) > 0);
  // All disks are alike, and the other group has neither a random place nor a random orientation.
  for (const char* path : {"rock.volume", "rock.elongation"}) CHECK_FALSE(ball.contains(path));
  for (const char* path : {"release.x", "release.y", "release.z", "rock.orientation"})
    CHECK_FALSE(other.contains(path));
}

TEST_CASE("the tilt of rough ground at each impact of a lumped mass is among the inputs") {
  const LoadedScenario scenario =
      loaded("tests/unit/batch/drawn_2d.yaml",
             {.set = {"method=lumped_mass",
                      "materials.ground.roughness={ angle: { normal: { mean: 0 deg, sd: 10 deg } } }"}});
  const TrialRecords records = first_trial(scenario);
  const auto tilts =
      inputs_of_rock(records, scenario.plan.points.front(), 0).at("materials.ground.roughness.angle");
  CHECK_FALSE(tilts.contains(0));
  int impacts = 0;
  for (const ImpactRecord& row : records.impacts) {
    if (row.rock != 0) continue;
    REQUIRE(tilts.contains(row.impact.number));
    if (++impacts > 1) continue;
    // It falls straight down on level ground: the angle of its velocity is the tilt.
    CHECK(std::atan2(row.impact.vt_before, -row.impact.vn_before) == Approx(tilts.at(1)));
    CHECK(tilts.at(1) != 0);
  }
  CHECK(impacts >= 3);
  CHECK(tilts.size() == static_cast<std::size_t>(impacts));
}

TEST_CASE("in 3D rough ground tilts along the motion and across it, both among the inputs") {
  const LoadedScenario scenario =
      loaded("tests/unit/batch/mapped.yaml",
             {.set = {"materials.ground.roughness={ angle: { normal: { mean: 0 deg, sd: 5 deg } } }"}});
  const Scenario& point = scenario.plan.points.front();
  const TrialRecords records = first_trial(scenario);
  std::vector<double> tilts;  // of the first impact
  for (const InputRecord& row : records.inputs)
    if (row.impact == 1) tilts.push_back(row.value);
  REQUIRE(tilts.size() == 2);
  CHECK(tilts[0] != tilts[1]);
  const Draw& draw = point.draws.at(static_cast<std::size_t>(point.materials.front().roughness->draw));
  CHECK(tilts[0] == draw.value(point.streams.seed, {.trial = 0, .hole = 1, .rock = 1, .impact = 1}));
}

TEST_CASE("constant roughness, and draws of another scope, are not inputs of impacts") {
  for (const char* angle : {"4 deg", "{ normal: { mean: 0 deg, sd: 5 deg }, per: trial }"}) {
    const LoadedScenario scenario =
        loaded("tests/unit/batch/mapped.yaml",
               {.set = {"materials.ground.roughness={ angle: " + std::string(angle) + " }"}});
    for (const InputRecord& row : first_trial(scenario).inputs) CHECK(row.impact == 0);
  }
}

TEST_CASE("without impacts among the results there are no draws of impacts") {
  const LoadedScenario scenario =
      loaded("tests/unit/batch/drawn_2d.yaml", {.set = {"output={impacts: false}"}});
  const TrialRecords records = first_trial(scenario);
  CHECK(records.impacts.empty());
  for (const InputRecord& row : records.inputs) CHECK(row.impact == 0);
}

TEST_CASE("the outcomes of a random shape in 3D are those of its rock") {
  const LoadedScenario scenario = loaded("tests/unit/batch/drawn_3d.yaml");
  const Scenario& point = scenario.plan.points.front();
  const TrialRecords records = first_trial(scenario);
  const auto inputs = inputs_of_rock(records, point, 0);
  CHECK(inputs.at("rock.volume").at(0) == records.rocks[0].volume);
  CHECK(inputs.at("rock.elongation").at(0) == Approx(0.6).margin(0.25));
  CHECK(inputs.at("rock.flatness").at(0) == Approx(0.5).margin(0.25));
  CHECK(inputs.at("rock.orientation").at(0) <= pi);
  const auto trial = TrialBuilder<3>(point).build(0);
  const Vec3 start = trial.worlds[0].bodies[0].x;
  CHECK(inputs.at("release.x").at(0) == start.x());
  CHECK(inputs.at("release.y").at(0) == start.y());
  CHECK(inputs.at("release.z").at(0) == start.z());
}

TEST_CASE("elongation and flatness are those of a box, and of a rectangle in 2D however it lies") {
  Outcomes outcomes;
  outcomes.set_shape(make_body({Contactor3::box({4, 2, 1})}, 1, 0));
  CHECK(outcomes[Outcome::volume] == Approx(8));
  CHECK(outcomes[Outcome::elongation] == Approx(0.5));
  CHECK(outcomes[Outcome::flatness] == Approx(0.5));
  for (const double angle : {0.0, 0.3, 1.2}) {
    const Rotation2 turn = Rotation2::from_angle(angle);
    std::vector<Vec2> corners;
    for (const Vec2& corner : {Vec2(0, 0), Vec2(4, 0), Vec2(4, 1), Vec2(0, 1)})
      corners.push_back(turn * (corner + Vec2(7, 3)));
    outcomes.set_shape(make_body({Contactor2::polygon(corners)}, 1, 0, 1));
    CHECK(outcomes[Outcome::elongation] == Approx(0.25));
  }
  outcomes.set_shape(make_body({Contactor2::disk(0.3)}, 1, 0, 1));
  CHECK(outcomes[Outcome::elongation] == Approx(1));
}
