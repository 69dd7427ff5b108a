#include "scenario/decode.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "dice.h"
#include "document/yaml_reader.h"
#include "unit/test_registry.h"

using namespace flyrock;

namespace {

const Registry& registry() {
  static const Registry registry = test::make_registry();
  return registry;
}

/// What stands before and after the part that a test is about.
const std::string head = R"(flyrock: 1
dimension: 2
method: nscd
)";
const std::string ground = R"(terrain: { type: plane, material: rock }
materials: { rock: { restitution: { type: newton, en: 0.5 }, friction: { type: coulomb, mu: 0.3 } } }
stop: { time: 2 s }
)";
const std::string ball =
    "bodies: [{ name: ball, shape: { type: disk, radius: 10 cm }, mass: 1, position: [0, 1] }]\n";
const std::string benches =
    R"(terrain: { type: benches, height: 12 m, face_angle: 70 deg, materials: { face: rock, berm: rock, floor: rock } }
materials: { rock: { restitution: { type: newton, en: 0.5 } } }
stop: { time: 60 s }
)";
const std::string blocks = R"(rocks:
  - name: blocks
    density: 2.7 g/cm3
    shape: { type: disk, radius: { uniform: [10 cm, 0.5 m] } }
    release: { from: face }
    launch: { type: fixed, speed: 3, elevation: { normal: { mean: 20 deg, sd: 5 deg } } }
)";

std::optional<Plan> try_decode(const std::string& text, Diagnostics& diagnostics,
                               const Overrides& overrides = {}) {
  auto root = read_yaml(text, "s.yaml", diagnostics);
  if (!root) return std::nullopt;
  apply_overrides(*root, overrides, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  return decode(*root, registry(), ".", diagnostics);
}

Plan decode_text(const std::string& text, const Overrides& overrides = {}) {
  Diagnostics diagnostics;
  auto plan = try_decode(text, diagnostics, overrides);
  INFO(text << diagnostics.to_text());
  REQUIRE(plan);
  return *plan;
}

/// The messages of a text that is refused, without places.
std::string refuse(const std::string& text, const Overrides& overrides = {}) {
  Diagnostics diagnostics;
  const bool decoded = try_decode(text, diagnostics, overrides).has_value();
  CHECK_FALSE(decoded);
  std::string lines;
  for (const Diagnostic& d : diagnostics.all()) lines += d.path + ": " + d.text + "\n";
  return lines;
}

}  // namespace

TEST_CASE("a scenario of bodies: units, defaults and names") {
  const Plan plan = decode_text(head + ground + ball);
  REQUIRE(plan.points.size() == 1);
  const Scenario& s = plan.points[0];
  CHECK(s.streams.seed == 1);
  CHECK(s.trials == 1);
  CHECK(s.gravity.constant == 9.81);
  CHECK(s.stop.time == 2);
  CHECK(s.stop.speed == 0.05);
  CHECK_FALSE(s.solver.time_step);
  CHECK(s.solver.step_tolerance == 1e-3);
  CHECK(s.solver.max_iterations == 1000);
  CHECK(s.solver.flight == FlightMode::exact);
  CHECK(s.output.trajectories_first == 100);
  REQUIRE(s.bodies.size() == 1);
  CHECK(s.bodies[0].shape.values[0].numbers[0].constant == Approx(0.1));
  CHECK(s.bodies[0].shape.path == "bodies.0.shape");
  CHECK(s.bodies[0].mass->constant == 1);
  CHECK_FALSE(s.bodies[0].density);
  CHECK(s.bodies[0].position[1].constant == 1);
  CHECK(s.bodies[0].velocity.size() == 2);
  REQUIRE(s.materials.size() == 1);
  CHECK(s.materials[0].restitution->slots[0].constant == 0.5);
  CHECK(s.terrain.material_of_part.at("") == 0);
}

TEST_CASE("bodies of one named shape have it as if it stood there") {
  const std::string bodies =
      "bodies:\n"
      "  - { name: a, shape: round, mass: 1, position: [0, 1], force: [2 kN, 0], hold: 20 ms }\n"
      "  - { name: b, shape: round, mass: 1, position: [3, 1] }\n"
      "pairs: [{ between: [a, b], material: rock }]\n";
  const Plan plan = decode_text(head + ground + bodies +
                                "shapes: { round: { type: disk, radius: { uniform: [10 cm, 20 cm] } } }\n"
                                "settle: { until: 1 cm/s, at_most: 3 s }\n");
  const Scenario& s = plan.points.at(0);
  REQUIRE(s.draws.size() == 2);
  CHECK(s.draws[0].stream != s.draws[1].stream);
  CHECK(s.bodies[1].shape.path == "bodies.1.shape");
  CHECK(s.bodies[0].force.at(0).constant == 2000);
  CHECK(s.bodies[0].hold->constant == 0.02);
  CHECK_FALSE(s.bodies[1].hold);
  CHECK(s.settle->until == 0.01);
  CHECK(s.settle->at_most == 3);
  const std::string once = to_yaml(plan.resolved);
  CHECK(once.find("shapes") == std::string::npos);
  CHECK(to_yaml(decode_text(once).resolved) == once);
}

TEST_CASE("distributions: scopes by section, streams by name") {
  const Plan plan = decode_text(head + benches + blocks +
                                "gravity: { uniform: [9.8, 9.82] }\n"
                                "blast: { burden: { uniform: [2, 3] }, spacing: { uniform: [2, 3] } }\n");
  const std::vector<Draw>& draws = plan.points[0].draws;
  auto find = [&](const std::string& path) {
    for (const Draw& draw : draws)
      if (draw.path == path) return draw;
    FAIL(path);
    return Draw{};
  };
  CHECK(find("gravity").scope == Scope::trial);
  CHECK(find("blast.burden").scope == Scope::hole);
  CHECK(find("blast.spacing").scope == Scope::trial);
  CHECK(find("rocks.0.shape.radius").scope == Scope::rock);
  CHECK(find("rocks.0.shape.radius").stream == "rocks.blocks.shape.radius");
  CHECK(find("rocks.0.shape.radius").stream_hash == hash_name("rocks.blocks.shape.radius"));
  CHECK(find("rocks.0.shape.radius").distribution.a == Approx(0.1));
  CHECK(find("rocks.0.launch.elevation").distribution.b == Approx(5 * 3.14159265358979 / 180));
  CHECK(plan.not_used == std::vector<std::string>{"blast.burden (fixed does not read it)",
                                                  "blast.spacing (fixed does not read it)"});
}

TEST_CASE("`per` overrides the scope where that is possible") {
  const std::string material =
      "terrain: { type: plane, material: rock }\nstop: { time: 2 }\n"
      "materials: { rock: { restitution: { type: newton, en: { uniform: [0.3, 0.6], per: impact } } } }\n";
  CHECK(decode_text(head + material + ball).points[0].draws[0].scope == Scope::impact);
  CHECK(refuse(head + ground + ball + "gravity: { uniform: [9, 10], per: rock }\n") ==
        "gravity.per: expected `run` or `trial`, found `rock`\n");
}

TEST_CASE("all distributions are read, and written as they are read") {
  for (const char* written :
       {"{ uniform: [1, 2], per: rock }", "{ normal: { mean: 3, sd: 1 }, min: 0.5, per: rock }",
        "{ lognormal: { median: 0.6, log_sd: 0.35 }, per: rock }", "{ triangular: [1, 2, 3], per: rock }",
        "{ weibull: { scale: 1, shape: 2 }, max: 4, per: rock }",
        "{ beta: { alpha: 2, beta: 3, low: 1, high: 2 }, per: rock }",
        "{ exponential: { mean: 2 }, min: 0.1, per: rock }", "{ discrete: [1, 2], per: rock }",
        "{ discrete: { values: [1, 2], weights: [3, 1] }, per: rock }", "{ integer: [1, 3], per: trial }",
        "{ rosin_rammler: { median: 0.2, uniformity: 1.1 }, min: 0.05, by: mass, per: rock }",
        "{ power_law: { low: 0.1, high: 2, exponent: 2.5 }, per: rock }",
        "{ sieve: { size: [0.1, 0.5, 1], passing: [0, 0.4, 1] }, by: mass, per: rock }"}) {
    std::string text = head + benches + blocks;
    const std::string old = "{ uniform: [10 cm, 0.5 m] }";
    text.replace(text.find(old), old.size(), written);
    const Plan plan = decode_text(text);
    INFO(written);
    CHECK(to_yaml(plan.resolved).find(std::string("radius: ") + written) != std::string::npos);
  }
}

TEST_CASE("a draw must not leave the limits of its parameter") {
  auto with_radius = [](const std::string& radius) {
    std::string text = head + benches + blocks;
    const std::string old = "{ uniform: [10 cm, 0.5 m] }";
    return text.replace(text.find(old), old.size(), radius);
  };
  CHECK(refuse(with_radius("{ normal: { mean: 1, sd: 1 } }")) ==
        "rocks.0.shape.radius: draws from -inf m to inf m, must be above 0 m: give it a `min` or `max`\n");
  CHECK(refuse(with_radius("{ uniform: [-1, 2] }")) ==
        "rocks.0.shape.radius: draws from -1 m to 2 m, must be above 0 m: give it a `min` or `max`\n");
  CHECK(refuse(with_radius("{ uniform: [2, 1] }")) ==
        "rocks.0.shape.radius: the uniform distribution cannot be drawn: its low end must be below its high "
        "end\n");
  CHECK(refuse(with_radius("{ unifrom: [1, 2] }")) ==
        "rocks.0.shape.radius.unifrom: unknown key, did you mean `uniform`?\n"
        "rocks.0.shape.radius: expected a number in m or a distribution: `uniform`, `normal`, `lognormal`, "
        "`triangular`, `weibull`, `beta`, `exponential`, `discrete`, `integer`, "
        "`rosin_rammler`, `power_law` or `sieve`\n");
  CHECK(refuse(with_radius("{ rosin_rammler: { median: 20 cm, uniformity: 1 }, by: mass }")) ==
        "rocks.0.shape.radius: the rosin_rammler distribution cannot be drawn: pieces without a least size "
        "have no number: give it a `min`\n");
  CHECK(refuse(with_radius("{ sieve: { size: [5 cm, 1 m], passing: [10 %, 100 %] } }")) ==
        "rocks.0.shape.radius: the sieve distribution cannot be drawn: nothing must pass its first size: its "
        "first share must be 0\n");
  CHECK(refuse(with_radius("{ uniform: [1, 2], by: weight }")) ==
        "rocks.0.shape.radius.by: expected `count` or `mass`, found `weight`\n");
  CHECK(refuse(with_radius("{ uniform: [1 s, 2] }")) ==
        "rocks.0.shape.radius.uniform.0: the unit `s` does not fit, expected a unit like m\n");
}

TEST_CASE("sweeps become a grid, sorted by path, the last axis fastest") {
  const Plan plan =
      decode_text(head +
                  "gravity: { sweep: { from: 1 m/s2, to: 2 m/s2, count: 3 } }\nstop: { time: 2 }\n"
                  "terrain: { type: plane, material: rock }\n"
                  "materials: { rock: { restitution: { type: newton, en: { sweep: [0.3, 0.4] } } } }\n" +
                  ball + "expect: [{ measure: body.ball.final.y, above: 0, at: { gravity: 150 cm/s2 } }]\n");
  REQUIRE(plan.axes.size() == 2);
  CHECK(plan.axes[0].path == "gravity");
  CHECK(plan.axes[0].values == std::vector<double>{1, 1.5, 2});
  CHECK(plan.axes[1].path == "materials.rock.restitution.en");
  REQUIRE(plan.points.size() == 6);
  CHECK(plan.at[1] == std::vector<double>{1, 0.4});
  CHECK(plan.at[2] == std::vector<double>{1.5, 0.3});
  CHECK(plan.points[5].gravity.constant == 2);
  CHECK(plan.points[5].expect[0].at[0].second == 1.5);
  CHECK(to_yaml(plan.resolved).find("gravity: { sweep: [1, 1.5, 2] }") != std::string::npos);
}

TEST_CASE("a sweep inside a distribution keeps the stream") {
  std::string text = head + benches + blocks;
  const std::string old = "[10 cm, 0.5 m]";
  text.replace(text.find(old), old.size(), "[10 cm, { sweep: [0.5 m, 0.6 m] }]");
  const Plan plan = decode_text(text);
  REQUIRE(plan.points.size() == 2);
  CHECK(plan.points[0].draws[0].stream == plan.points[1].draws[0].stream);
  CHECK(plan.points[1].draws[0].distribution.b == 0.6);
  CHECK(plan.axes[0].path == "rocks.0.shape.radius.uniform.1");
}

TEST_CASE("choices, sections with a type, barriers and the solver are swept") {
  const Plan plan =
      decode_text(head + ground + ball +
                  "barriers: [{ name: fence, x: { sweep: [3 m, 4 m] }, height: 1 m, capacity: 1 kJ }]\n"
                  "solver: { time_step: { sweep: [auto, 5 ms] }, flight: { sweep: [exact] } }\n"
                  "gravity: { sweep: [9.81] }\n"
                  "expect: [{ measure: body.ball.final.y, above: 0, at: { barriers.fence.x: 4 m, "
                  "solver.time_step: 5 ms } }]\n");
  REQUIRE(plan.axes.size() == 4);
  CHECK(plan.axes[0].path == "barriers.0.x");
  CHECK(plan.axes[0].values == std::vector<double>{3, 4});
  CHECK(plan.axes[2].labels == std::vector<std::string>{"exact"});
  CHECK(plan.axes[3].labels == std::vector<std::string>{"auto", "0.005 s"});
  REQUIRE(plan.points.size() == 4);
  CHECK(plan.points[3].barriers[0].x == 4);
  CHECK(!plan.points[2].solver.time_step);
  CHECK(plan.points[3].solver.time_step == 0.005);
  CHECK(plan.points[0].expect[0].at[1] == std::pair<std::string, double>("solver.time_step", 1));
  const std::string once = to_yaml(plan.resolved);
  CHECK(to_yaml(decode_text(once).resolved) == once);
}

TEST_CASE("sections with one type have labels of their own") {
  const Plan plan =
      decode_text(head + ball +
                  "stop: { time: 2 }\nterrain: { type: plane, material: rock }\nmaterials: { rock: { "
                  "restitution: { sweep: [{ type: newton, en: 0.3 }, { type: newton, en: 0.4 }] } } }\n");
  CHECK(plan.axes[0].labels == std::vector<std::string>{"newton", "newton 2"});
  CHECK(plan.points[1].materials[0].restitution->values[0].numbers[0].constant == 0.4);
}

TEST_CASE("where nothing may vary") {
  const auto with_stop = [](const std::string& time) {
    return head + "terrain: { type: plane, material: rock }\nmaterials: { rock: {} }\n" + ball +
           "stop: { time: " + time + " }\n";
  };
  CHECK(refuse(with_stop("{ sweep: [1 s, 2 s] }")) == "stop.time: takes no sweep, expected a number in s\n");
  CHECK(refuse(head + ground + ball + "title: { sweep: [one, two] }\n") ==
        "title: takes no sweep, only numbers, choices and sections with a `type` are swept\n");
  CHECK(refuse(head + ground + ball +
               "barriers: [{ name: { sweep: [a, b] }, x: 1, height: 1, capacity: 1 MJ }]\n") ==
        "barriers.0.name: takes no sweep, only numbers, choices and sections with a `type` are swept\n");
  CHECK(refuse(head + ground + ball + "gravity: { sweep: [[1]] }\n") ==
        "gravity.sweep.0: a sweep lists numbers, choices or sections with a `type`, found a list\n");
  CHECK(
      refuse(
          head + ball +
          "stop: { time: 2 }\nterrain: { type: plane, material: rock }\nmaterials: { rock: { restitution: { "
          "sweep: [{ type: newton, en: { sweep: [0.3, 0.4] } }] } } }\n") ==
      "materials.rock.restitution.sweep.0.en.sweep: stands inside another sweep, expected a value\n");
  CHECK(refuse(head + ground + ball + "solver: { theta: { uniform: [0.5, 0.6] } }\n") ==
        "solver.theta: takes no distribution, expected a number\n");
}

TEST_CASE("the resolved scenario decodes to itself") {
  for (const std::string& text :
       {head + ground + ball,
        head + benches + blocks +
            "blast: { explosive: ANFO, hole: { diameter: 102 mm }, burden: { uniform: [2, 3] } }\n",
        head + ground + "gravity: { sweep: [1, 2] }\ntitle: \"010\"\n" + ball +
            "expect: [{ measure: body.ball.max.angle, between: [-1, 1], at: { gravity: 2 } }]\n"}) {
    const Plan plan = decode_text(text);
    const std::string once = to_yaml(plan.resolved);
    CHECK(to_yaml(decode_text(once).resolved) == once);
  }
}

TEST_CASE("the options --set, --seed and --trials") {
  Overrides overrides;
  overrides.set = {"stop.time=5 s", "bodies.ball.mass=2 kg", "bodies.0.position=[1, 2]", "solver.theta=0.6"};
  overrides.seed = 7;
  overrides.trials = 12;
  const Scenario s = decode_text(head + ground + ball, overrides).points[0];
  CHECK(s.stop.time == 5);
  CHECK(s.bodies[0].mass->constant == 2);
  CHECK(s.bodies[0].position[0].constant == 1);
  CHECK(s.solver.theta == 0.6);
  CHECK(s.streams.seed == 7);
  CHECK(s.trials == 12);
  CHECK(refuse(head + ground + ball, {{"stop.tme=5"}, {}, {}}) ==
        "stop.tme: unknown key, did you mean `time`?\n");
  CHECK(refuse(head + ground + ball, {{"bodies.bal.mass=5"}, {}, {}}) ==
        "bodies.bal.mass: bodies has no element `bal`, did you mean `ball`?\n");
  CHECK(refuse(head + ground + ball, {{"seed"}, {}, {}}) ==
        ": expected path=value, as in --set terrain.height=10\n");
  CHECK(refuse(head + ground + ball, {{"stop.time=5 kg"}, {}, {}}) ==
        "stop.time: the unit `kg` does not fit, expected a unit like s\n");
}

TEST_CASE("a blast: D/3 unless the Gurney constant is given, and drawn with D") {
  const Plan plan =
      decode_text(head + benches + blocks +
                  "blast: { explosive: { density: 850, detonation_velocity: { uniform: [3000, 6000] } } }\n");
  const Scenario& s = plan.points[0];
  const Number velocity = s.blast->fields.at(BlastField::detonation_velocity);
  const Number gurney = s.blast->fields.at(BlastField::gurney_constant);
  const DrawKey key{3, 1, 1, 0};
  CHECK(gurney.value(s.draws, 1, key) == Approx(velocity.value(s.draws, 1, key) / 3));
  CHECK_FALSE(s.blast->is_anfo);
}

TEST_CASE("a third of a whole number that is drawn is no list of all that it may be") {
  const Plan plan = decode_text(
      head + benches + blocks +
      "blast: { explosive: { density: 850, detonation_velocity: { integer: [1, 100000000] } } }\n");
  const Scenario& s = plan.points[0];
  const Number gurney = s.blast->fields.at(BlastField::gurney_constant);
  CHECK(s.draws[gurney.draw].distribution.values.empty());
  CHECK(s.draws[gurney.draw].highest() == Approx(1e8 / 3));
  const DrawKey key{3, 1, 1, 0};
  CHECK(3 * gurney.value(s.draws, 1, key) ==
        Approx(s.blast->fields.at(BlastField::detonation_velocity).value(s.draws, 1, key)));
}

TEST_CASE("a draw knows the group that it belongs to") {
  const std::string more = R"(  - name: loose
    density: { uniform: [2600, 2800] }
    shape: { type: disk, radius: 0.3 }
    release: { from: face }
)";
  const Plan plan = decode_text(head + benches + blocks + more + "gravity: { uniform: [9.8, 9.82] }\n");
  std::map<std::string, int> groups;
  for (const Draw& draw : plan.points[0].draws) groups[draw.stream] = draw.group;
  CHECK(groups == std::map<std::string, int>{{"gravity", -1},
                                             {"rocks.blocks.launch.elevation", 0},
                                             {"rocks.blocks.shape.radius", 0},
                                             {"rocks.loose.density", 1}});
}

TEST_CASE("a hole against its bench") {
  auto with_hole = [](const std::string& hole) {
    return head + benches + blocks + "blast: { hole: { " + hole + " } }\n";
  };
  CHECK(refuse(with_hole("stemming: 3, charge_length: { uniform: [4, 10] }, subdrilling: 0.6")) ==
        "blast.hole: stemming (3 m) and charge_length (4 to 10 m) are up to 13 m long, longer than bench "
        "height (12 m) + "
        "subdrilling (0.6 m)\n");
  Diagnostics diagnostics;
  CHECK(try_decode(with_hole("stemming: 3, charge_length: 4"), diagnostics));
  CHECK(diagnostics.warnings() ==
        std::vector<std::string>{"blast.hole: the hole (7 m) is shorter than the bench (12 m)"});
}

TEST_CASE("all errors are reported at once") {
  CHECK(refuse(head +
               "trials: 1.5\nstop: {}\nmaterials:\nterrain: { type: plain, material: rock }\nrocks: []\n") ==
        "trials: is `1.5`, must be a whole number\n"
        "terrain.type: unknown terrain `plain`, expected `benches` or `plane`\n"
        "materials: is empty, expected a map\n"
        "rocks: is empty, expected at least one element\n"
        "stop: `time` is missing, expected a number in s\n");
}

TEST_CASE("bodies and groups that meet need a material between them") {
  const std::string two =
      head +
      "terrain: { type: plane, material: a }\nmaterials: { a: {}, b: {} }\nstop: { time: 2 }\n"
      "bodies:\n"
      "  - { name: one, shape: { type: disk, radius: 1 }, mass: 1, position: [0, 1], material: a }\n"
      "  - { name: two, shape: { type: disk, radius: 1 }, mass: 1, position: [3, 1], material: b }\n";
  CHECK(refuse(two) ==
        "bodies.1: `one` and `two` can meet, and nothing says how: expected the same `material`, or an entry "
        "of "
        "`pairs` between them\n");
  const Scenario s = decode_text(two + "pairs: [{ between: [two, one], material: b }]\n").points[0];
  CHECK(s.pairs[0].a == "two");
  CHECK(s.pairs[0].material == 1);
  CHECK(refuse(head + benches + blocks + "rock_contacts: on\n") ==
        "rocks.0: `blocks` and `blocks` can meet, and nothing says how: expected the same `material`, or an "
        "entry of "
        "`pairs` between them\n");
}

TEST_CASE("zones and the rest of the terrain have their materials") {
  const Scenario s = decode_text(head +
                                 "terrain: { type: plane, material: a, zones: [{ name: road, from: 2, to: 5 "
                                 "m }], materials: { road: b } }\n"
                                 "materials: { a: {}, b: {} }\nstop: { time: 2 }\n" +
                                 ball)
                         .points[0];
  CHECK(s.terrain.zones[0].to == 5);
  CHECK(s.terrain.material_of_part.at("") == 0);
  CHECK(s.terrain.material_of_part.at("road") == 1);
}

TEST_CASE("what nothing reads is listed") {
  CHECK(decode_text(head +
                    "terrain: { type: plane, material: a }\nmaterials: { a: {}, b: {} }\nstop: { time: 2 }\n"
                    "rock_contacts: on\n" +
                    ball)
            .not_used == std::vector<std::string>{"materials.b (nothing is made of it)",
                                                  "rock_contacts (the scenario has no rocks)"});
}

TEST_CASE("measures") {
  auto with = [](const std::string& measure) {
    return head + ground + ball + "expect: [{ measure: \"" + measure + "\", below: 5 }]\n";
  };
  for (const char* good : {"body.ball.final.x", "body.ball.max.angle", "body.ball.stop_time",
                           "body.ball.impact[3].pn", "body.ball.apex[1].height", "body.ball.contact_time",
                           "energy.total.relative_change", "solver.max_residual"})
    CHECK(decode_text(with(good)).points[0].expect[0].measure == good);
  CHECK(refuse(with("body.ball.tension_1pct.max")).find("it needs `output.series`") != std::string::npos);
  CHECK(refuse(with("body.ball.tension_1pct.mean")).find("unknown `mean`") != std::string::npos);
  CHECK(refuse(with("body.ball.final.z")).find("unknown `z`") != std::string::npos);
  CHECK(refuse(with("body.ball.final")).find("it ends early") != std::string::npos);
  CHECK(refuse(with("body.ball.stop_time.x")).find("nothing may follow `stop_time`") != std::string::npos);
  CHECK(refuse(with("body.ball.apex[x].height")).find("`x` is not an index") != std::string::npos);
  CHECK(refuse(with("sover.max_residual")).find("did you mean `solver`?") != std::string::npos);
}

TEST_CASE("a tail of less than 1e-9 beyond a limit is cut off there, a heavier one asks for a bound") {
  const auto disks = [&](const std::string& radius) {
    return head + benches + "rocks: [{ name: b, density: 2700, shape: { type: disk, radius: " + radius +
           " }, release: { from: face } }]\n";
  };
  // A normal distribution with its mean at 6.1 sd above 0 has 5e-10 below it, at 5.9 sd 2e-9.
  const Plan plan = decode_text(disks("{ normal: { mean: 6.1, sd: 1 } }"));
  REQUIRE(plan.points[0].draws.size() == 1);
  CHECK(plan.points[0].draws[0].distribution.min == 0);
  CHECK(refuse(disks("{ normal: { mean: 5.9, sd: 1 } }")) ==
        "rocks.0.shape.radius: draws from -inf m to inf m, must be above 0 m: give it a `min` or `max`\n");
  CHECK(refuse(disks("{ uniform: [-1e-8, 1] }")).find("must be above 0 m") != std::string::npos);
  CHECK(decode_text(disks("{ uniform: [-1e-10, 1] }")).points[0].draws[0].distribution.min == 0);
  CHECK(decode_text(disks("{ normal: { mean: 7, sd: 1 }, min: -3 }")).points[0].draws[0].distribution.min ==
        0);

  // Whatever is accepted never draws a value beyond the limits; what is refused has such a tail.
  Dice dice;
  int accepted = 0;
  for (int i = 0; i < 200; ++i) {
    Distribution tried;
    tried.kind = DistributionKind::normal;
    tried.a = dice(0.1, 1);
    tried.b = tried.a / dice(3, 9);
    const double beyond = tried.cumulative(0);
    const std::string text = disks(fmt::format("{{ normal: {{ mean: {}, sd: {} }} }}", tried.a, tried.b));
    INFO(text);
    Diagnostics diagnostics;
    const std::optional<Plan> decoded = try_decode(text, diagnostics);
    CHECK(decoded.has_value() == (beyond < 1e-9));
    if (!decoded) continue;
    ++accepted;
    const Distribution& drawn = decoded->points[0].draws[0].distribution;
    for (const double u : {1e-17, 1e-12, 1 - 1e-12}) CHECK(drawn.quantile(u) >= 0);
    for (const double u : {0.001, 0.5, 0.999}) CHECK(drawn.quantile(u) == Approx(tried.quantile(u)));
  }
  CHECK((accepted > 50 && accepted < 150));
}

TEST_CASE("whole numbers keep their digits or are refused, from a file and from the command line") {
  const auto seed_of = [&](const std::string& seed) {
    Diagnostics diagnostics;
    const std::optional<Plan> plan = try_decode(head + ground + ball + "seed: " + seed + "\n", diagnostics);
    return plan ? std::to_string(plan->points[0].streams.seed) : std::string();
  };
  Dice dice;
  int refused = 0;
  for (int i = 0; i < 200; ++i) {
    const auto whole = static_cast<std::uint64_t>(std::exp2(dice(40, 60)));
    const std::string text = std::to_string(whole);
    INFO(text);
    const std::string kept = seed_of(text);
    CHECK((kept == text || kept.empty()));
    refused += kept.empty();
    Overrides overrides;
    overrides.seed = whole;
    Diagnostics diagnostics;
    const auto plan = try_decode(head + ground + ball, diagnostics, overrides);
    CHECK(plan.has_value() == !kept.empty());
    if (plan) CHECK(plan->points[0].streams.seed == whole);
    overrides = {.set = {"seed=" + text}};
    Diagnostics again;
    CHECK(try_decode(head + ground + ball, again, overrides).has_value() == !kept.empty());
  }
  CHECK((refused > 30 && refused < 170));
  CHECK(seed_of("9007199254740992") == "9007199254740992");
  CHECK(seed_of("9007199254740993").empty());
  CHECK(seed_of("9007199254740992.5").empty());
  CHECK(seed_of("7.00000000000000000001").empty());
  CHECK(seed_of("7.0000000000000000000") == "7");
}
