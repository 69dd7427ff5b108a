// Each pair has its own surface: what one pair meets does not change the draws and the memory of another.
#include <catch2/catch.hpp>

#include "batch/trial.h"
#include "load.h"
#include "trial/build_trial.h"
#include "unit/lua_fixture.h"

using namespace flyrock;

namespace {

/// The surface of the contacts of `lower` with the ground (other = -1) or with `upper` (other = 1).
const PairLaws* surface_of(const World<2>& world, int other) {
  for (const auto& contact : world.contacts())
    if (contact.candidate == 0 && contact.antagonist == other) return contact.laws;
  return nullptr;
}

struct Glued {
  LoadedScenario scenario = loaded("tests/unit/trial/glued.yaml");
  TrialBuilder<2> builder{scenario.plan.points.front()};
  Trial<2> trial = builder.build(0);
  World<2>& world = trial.worlds.front();

  void step(int steps) {
    for (int k = 0; k < steps; ++k) world.step(1e-3, false);
  }
};

bool torn(const PairLaws& surface) { return surface.unilateral.history.at(1) == 1; }

/// Each trial of a run by one runner, in which the trials share what they can, beside the same trial alone.
void check_trials_alone(const Scenario& scenario, std::uint64_t trials, std::size_t rocks) {
  TrialRunner runner(scenario);
  for (std::uint64_t number = 0; number < trials; ++number) {
    TrialRecords shared, alone;
    runner.run(number, shared);
    TrialRunner(scenario).run(number, alone);
    REQUIRE(shared.rocks.size() == rocks);
    REQUIRE(alone.rocks.size() == rocks);
    for (std::size_t i = 0; i < rocks; ++i) {
      const RockRecord &a = shared.rocks[i], &b = alone.rocks[i];
      CHECK(a.trial == number);
      CHECK(a.fault == b.fault);
      CHECK(a.mass == b.mass);
      CHECK(a.stop_x == b.stop_x);
      CHECK(a.time == b.time);
      CHECK(a.impacts == b.impacts);
      CHECK(a.travel.distance == b.travel.distance);
    }
    REQUIRE(shared.inputs.size() == alone.inputs.size());
    for (std::size_t i = 0; i < shared.inputs.size(); ++i) {
      CHECK(shared.inputs[i].input == alone.inputs[i].input);
      CHECK(shared.inputs[i].value == alone.inputs[i].value);
    }
    CHECK(shared.totals.quality.flights == alone.totals.quality.flights);
    CHECK(shared.totals.materials[0].restitution == alone.totals.materials[0].restitution);
    CHECK(shared.totals.materials[0].friction == alone.totals.materials[0].friction);
  }
}

}  // namespace

TEST_CASE("a bond that tears leaves the others of its material whole, and their draws as they are") {
  Glued glued;
  glued.step(100);
  const PairLaws* ground = surface_of(glued.world, -1);
  const PairLaws* joint = surface_of(glued.world, 1);
  REQUIRE(ground);
  REQUIRE(joint);
  const double mu_of_ground = ground->friction.values.at(0), mu_of_joint = joint->friction.values.at(0);
  glued.world.bodies[1].v.y() = 1;  // flies for 0.2 s
  glued.step(300);
  CHECK(surface_of(glued.world, -1) == ground);
  CHECK(surface_of(glued.world, 1) == joint);
  CHECK(torn(*joint));
  CHECK_FALSE(torn(*ground));
  CHECK(joint->friction.values.at(0) != mu_of_joint);  // of its impact
  CHECK(ground->friction.values.at(0) == mu_of_ground);
}

TEST_CASE("bodies that first meet in a step that is done again meet with an empty memory") {
  Glued glued;
  glued.world.bodies[1].x.y() += 5e-3;
  glued.world.bodies[1].v.y() = -1;
  const auto outcome = glued.world.step(10e-3, true);
  CHECK(outcome.new_touch);
  CHECK(outcome.duration == Approx(5e-3).epsilon(0.03));
  glued.world.impact();
  REQUIRE(surface_of(glued.world, 1));
  CHECK(surface_of(glued.world, 1)->unilateral.history == std::vector<double>{0, 0});
}

namespace {

/// A scenario written by the test, and its first trial.
struct Written {
  LuaFixture files;
  std::optional<LoadedScenario> loaded;
  std::optional<TrialBuilder<2>> builder;
  Trial<2> trial;

  explicit Written(const std::string& text, const std::map<std::string, std::string>& plugins = {}) {
    for (const auto& [name, content] : plugins) files.write(name, content);
    files.write("scenario.yaml",
                "flyrock: 1\ntitle: of a test\ndimension: 2\nmethod: nscd\nstop: { time: 1 s }\n" + text);
    Diagnostics diagnostics;
    loaded = load_scenario((files.folder / "scenario.yaml").string(), {}, diagnostics);
    INFO(diagnostics.to_text());
    REQUIRE(loaded);
    builder.emplace(loaded->plan.points.front());
    trial = builder->build(0);
  }
};

}  // namespace

TEST_CASE(
    "a bond holds while a block lands on one corner and then on the other, and tears where it is lifted "
    "off") {
  Written written(R"(
terrain: { type: profile, points: [[-20, 0], [20, 0]], material: mortar }
materials:
  mortar: { friction: { type: mohr_coulomb, mu: 0.6, cohesion: 1 MPa, tension: 1 kPa }, unilateral: { type: cohesive, pull: 600 N } }
bodies:
  - name: block  # its lower left corner on the ground, the other comes down within 0.2 s
    shape: { type: polygon, vertices: [[-0.5, -0.15], [0.5, -0.15], [0.5, 0.15], [-0.5, 0.15]] }
    mass: 100 kg
    position: [0, 0.193008]
    orientation: 5 deg
)");
  World<2>& world = written.trial.worlds.front();
  std::size_t most = 0;
  for (int k = 0; k < 500; ++k) {
    world.step(1e-3, false);
    if (k < 20) CHECK(world.contacts().size() < 2);
    most = std::max(most, world.contacts().size());
  }
  REQUIRE(most == 2);
  REQUIRE(world.contacts().size() == 2);
  const PairLaws& ground = *world.contacts().front().laws;
  CHECK(ground.unilateral.history.at(0) > 0.4);  // s of the pair, not of its younger contact
  CHECK_FALSE(torn(ground));
  CHECK(ground.friction.history.at(1) == 0);
  world.bodies[0].v.y() = 1;
  for (int k = 0; k < 500; ++k) world.step(1e-3, false);
  CHECK(torn(ground));
  CHECK(ground.friction.history.at(1) == 1);
}

TEST_CASE("a rock that strikes two faces of one material at once makes two impacts with draws of their own") {
  Written written(R"(
terrain: { type: profile, points: [[-10, 10], [0, 0], [10, 10]], material: face }
materials:
  face: { restitution: { type: newton, en: { uniform: [0.3, 0.6], per: impact } }, friction: { type: coulomb, mu: 0 } }
bodies:
  - name: ball
    shape: { type: disk, radius: 0.5 m }
    mass: 100 kg
    position: [0, 0.7071067811865476]
    velocity: [0, -5]
)");
  World<2>& world = written.trial.worlds.front();
  world.impact();
  REQUIRE(world.contacts().size() == 2);
  REQUIRE(world.impacts().size() == 2);
  CHECK(world.impacts()[0].number == 1);
  CHECK(world.impacts()[1].number == 2);
  CHECK(world.contacts()[0].law.e_n != world.contacts()[1].law.e_n);
}

TEST_CASE(
    "where two rocks meet, the draws of the impact are those of the lighter one, in any order of the list") {
  const std::string head = R"(
gravity: 0
terrain: { type: profile, points: [[-50, -20], [50, -20]], material: rock }
materials: { rock: { restitution: { type: newton, en: { uniform: [0.1, 0.9], per: impact } } } }
bodies:
)";
  const std::string big =
      "  - { name: big, shape: { type: disk, radius: 0.5 }, mass: 10, position: [0, 0], velocity: [1, 0], "
      "material: rock }\n";
  const std::string small =
      "  - { name: small, shape: { type: disk, radius: 0.1 }, mass: 1, position: [0.7, 0], velocity: [-1, "
      "0], material: rock }\n";
  for (const bool big_first : {true, false}) {
    const Written written(head + (big_first ? big + small : small + big));
    const TrialRecords records = first_trial(*written.loaded);
    REQUIRE(records.inputs.size() == 1);
    REQUIRE(records.impacts.size() == 2);  // in the history of both
    CHECK(records.inputs[0].rock == (big_first ? 1 : 0));
    const Impact& impact = records.impacts[0].impact;
    CHECK(records.inputs[0].value == Approx(-impact.vn_after / impact.vn_before));
  }
}

TEST_CASE("laws know the terrain by the name of the part that is met") {
  Written written(R"(
plugins: [by_part.lua]
terrain: { type: benches, count: 1, height: 10 m, face_angle: 70 deg, berm: 5 m, floor: 50 m, materials: { face: rock, berm: rock, floor: rock } }
materials: { rock: { friction: { type: by_part } } }
bodies:
  - { name: ball, shape: { type: disk, radius: 0.5 m }, mass: 100 kg, position: [20, 0.5] }
)",
                  {{"by_part.lua", R"(
return require("flyrock").plugin { kind = "friction", name = "by_part", doc = "d", reads = { "contact.group_b" },
  friction = function(p, contact) return contact.group_b == "terrain.floor" and 0.25 or 0.75 end }
)"}});
  World<2>& world = written.trial.worlds.front();
  world.step(1e-3, false);
  REQUIRE(world.contacts().size() == 1);
  CHECK(world.contacts().front().law.mu_s == 0.25);
}

TEST_CASE("a rock that cannot be built at another place takes no other rock with it") {
  // The launch fails on one side, so that rocks fail at their first place, and others at a later one.
  const Written written(R"(
rock_contacts: on
plugins: [one_side.lua]
terrain: { type: profile, points: [[-10, 0], [10, 0]], material: rock }
materials: { rock: { friction: { type: coulomb, mu: 0.5 } } }
rocks:
  - name: disks
    per_trial: 20
    density: 2700 kg/m3
    material: rock
    shape: { type: disk, radius: 0.3 m }
    release: { inside: [[-2, 1], [0.5, 1], [0.5, 3], [-2, 3]] }
    launch: { type: one_side }
)",
                        {{"one_side.lua", R"(
return require("flyrock").plugin { kind = "velocity", name = "one_side", doc = "d", reads = {},
  launch = function(p, rock)
    if rock.position[1] > 0 then error("on the other side") end
    return { velocity = { 0, 0 } }
  end }
)"}});
  REQUIRE(written.trial.worlds.size() == 1);
  int built = 0;
  for (const TrialRock& rock : written.trial.rocks) {
    CHECK(rock.fault.empty() == (rock.world == 0));
    if (rock.world == 0) CHECK(rock.body == built++);
  }
  CHECK((built > 0 && built < 20));
  CHECK(static_cast<int>(written.trial.worlds.front().bodies.size()) == built);
}

TEST_CASE("a body that starts inside another is named, whichever comes last") {
  const auto fault = [](double height_of_b, double height_of_c) {
    try {
      const Written written(fmt::format(R"(
terrain: {{ type: profile, points: [[-20, 0], [20, 0]], material: rock }}
materials: {{ rock: {{ friction: {{ type: coulomb, mu: 0.5 }} }} }}
bodies:
  - {{ name: a, shape: {{ type: disk, radius: 0.5 m }}, mass: 1 kg, material: rock, position: [0, 0.5] }}
  - {{ name: b, shape: {{ type: disk, radius: 0.5 m }}, mass: 1 kg, material: rock, position: [0, {}] }}
  - {{ name: c, shape: {{ type: disk, radius: 0.5 m }}, mass: 1 kg, material: rock, position: [5, {}] }}
)",
                                        height_of_b, height_of_c));
    } catch (const TrialError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(fault(1.5, 0.5) == "");
  CHECK(fault(1.25, 0.5) == "`b` starts 0.25 m inside `a`");
  CHECK(fault(0.25, 3).find("`b` starts") == 0);
  CHECK(fault(1.5, 0.25) ==
        "`c` starts at (5, 0.25) m, 0.25 m inside the terrain: it reaches 0.5 m from its centre of mass, a "
        "radius of at "
        "most 0.25 m fits there");
}

TEST_CASE("a trial does not depend on the trials before it, whose bodies, surfaces and memory it uses") {
  // The restitution falls with each impact of a pair, by its memory; other numbers are drawn for each rock.
  const std::string law = R"(
return require("flyrock").plugin { kind = "restitution", name = "tired", form = "newton", doc = "d", reads = {}, history = { "impacts" },
  params = { en = require("flyrock").number { doc = "d" } },
  impact = function(p, contact)
    contact.history.impacts = contact.history.impacts + 1
    return p.en / contact.history.impacts, 0
  end }
)";
  for (const char* method : {"lumped_mass", "ballistic", "nscd"}) {
    const Written written(R"(
plugins: [tired.lua]
terrain: { type: profile, points: [[-50, 20], [0, 0], [50, 0]], material: rock }
materials:
  rock: { restitution: { type: tired, en: { uniform: [0.3, 0.9], per: rock } }, friction: { type: coulomb, mu: { uniform: [0.3, 0.8], per: rock } }, rolling: { type: rolling_resistance, mu_r: 0.1 m } }
rocks:
  - { name: alike, per_trial: 2, density: 2700, shape: { type: disk, radius: 0.5 m }, release: { along: [[-40, 25], [-10, 25]] }, launch: { type: fixed, velocity: [2, 0] } }
  - { name: others, density: 2700, shape: { type: disk, radius: { uniform: [0.2 m, 0.6 m] } }, release: { position: [-20, 25] }, launch: { type: at_rest } }
)",
                          {{"tired.lua", law}});
    Scenario scenario = written.loaded->plan.points.front();
    scenario.method = *method == 'l'   ? Method::lumped_mass
                      : *method == 'b' ? Method::ballistic
                                       : Method::nscd;
    INFO(method);
    check_trials_alone(scenario, 4, 3);
  }
}

namespace {

constexpr const char* points = R"(flyrock: 1
title: of a test
method: lumped_mass
trials: 20
stop: { time: 20 s }
materials:
  rock:
    restitution: { type: newton, en: { uniform: [0.25, 0.45], per: impact } }
    friction: { type: coulomb, mu: { uniform: [0.4, 0.6], per: rock } }
    roughness: { angle: { normal: { mean: 0 deg, sd: 5 deg } } }
)";

}  // namespace

TEST_CASE("points whose trials start alike come to the same ends as each trial alone") {
  LuaFixture files;
  const auto check = [&](const std::string& text) {
    files.write("scenario.yaml", points + text);
    Diagnostics diagnostics;
    const auto loaded = load_scenario((files.folder / "scenario.yaml").string(), {}, diagnostics);
    INFO(diagnostics.to_text());
    REQUIRE(loaded);
    check_trials_alone(loaded->plan.points.front(), 20, 2);
  };
  check(R"(dimension: 2
terrain: { type: profile, points: [[-5, 10], [0, 10], [10, 0], [60, 0]], material: rock }
rocks:
  - name: thrown
    density: 2700
    shape: { type: disk, radius: 0.5 }
    release: { position: [-1, 12] }
    launch: { type: fixed, velocity: [2, -1] }
  - name: laid
    density: 2700
    shape: { type: polygon, vertices: [[-0.3, -0.2], [0.3, -0.2], [0, 0.3]] }
    release: { x: 2, above_ground: 1 }
)");
  check(R"(dimension: 3
terrain: { type: plane, point: [0, 0, 0], normal: [0.3, 0, 1], material: rock }
rocks:
  - name: thrown
    density: 2700
    shape: { type: sphere, radius: 0.5 }
    release: { position: [0, 0, 3] }
    launch: { type: fixed, velocity: [2, 0, 0] }
  - name: drawn
    density: 2700
    shape: { type: sphere, radius: 0.5 }
    release: { x: 0, y: 5, above_ground: 1 }
)");
}
