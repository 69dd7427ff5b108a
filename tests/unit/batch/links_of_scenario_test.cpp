// Links of a scenario: what is refused, and what a run records of them.

#include "document/yaml_reader.h"
#include "load.h"
#include "scenario/decode.h"
#include "temporary_file.h"
#include "unit/test_registry.h"

namespace links_of_scenario_test {

using namespace flyrock;

/// The messages of a scenario with these links.
std::string refuse(const std::string& links, int dimension = 2) {
  static const Registry registry = test::make_registry();
  const std::string up = dimension == 2 ? "[0, 1]" : "[0, 0, 1]";
  const std::string shape = dimension == 2 ? "disk" : "sphere";
  const std::string body =
      ", shape: { type: " + shape + ", radius: 0.1 }, mass: 1, material: rock, position: ";
  const std::string text = "flyrock: 1\ndimension: " + std::to_string(dimension) +
                           "\nmethod: nscd\nterrain: { type: plane, material: rock }\n"
                           "materials: { rock: { friction: { type: coulomb, mu: 0.3 } } }\nbodies:\n"
                           "  - { name: ball" +
                           body + up + " }\n" + "  - { name: post, fixed: true" + body +
                           (dimension == 2 ? "[3, 1]" : "[3, 0, 1]") + " }\nstop: { time: 1 s }\nlinks: [" +
                           links + "]\n";
  Diagnostics diagnostics;
  const auto root = read_yaml(text, "s.yaml", diagnostics);
  REQUIRE(root);
  CHECK_FALSE(decode(*root, registry, ".", diagnostics));
  std::string lines;
  for (const Diagnostic& d : diagnostics.all()) lines += d.path + ": " + d.text + "\n";
  return lines;
}

bool has(const std::string& text, const std::string& part) {
  UNSCOPED_INFO(text);
  return text.find(part) != std::string::npos;
}

TEST_CASE("links that cannot be are refused with what was expected") {
  const std::string ends = "ends: [[0, 1], [0, 3]]";
  CHECK(has(refuse("{ name: l, type: rod, between: [bal, terrain], " + ends + " }"),
            "links.0.between.0: `bal` is neither a body nor `terrain`, did you mean `ball`?"));
  CHECK(has(refuse("{ name: l, type: rod, between: [ball, ball], " + ends + " }"),
            "links.0.between: links a body to itself, expected two"));
  CHECK(has(refuse("{ name: l, type: rod, between: [terrain, post], " + ends + " }"),
            "links.0.between: neither of the two can move"));
  CHECK(has(refuse("{ name: l, type: rod, between: [ball], " + ends + " }"),
            "expected `between` with the names of two bodies, or of a body and `terrain`"));
  CHECK(has(refuse("{ name: l, type: rope, between: [ball, terrain], " + ends + ", length: 0 }"),
            "links.0.length: a rope needs a length above 0 m"));
  CHECK(has(refuse("{ name: l, type: rope, between: [ball, terrain], " + ends + ", length: -1 }"),
            "links.0.length"));
  CHECK(has(refuse("{ name: l, type: rope, between: [ball, terrain], " + ends + ", length: 1 m }"),
            "links.0.length: is 1 m, but its ends are 2 m apart: a rope is at least as long"));
  CHECK(has(refuse("{ name: l, type: rod, between: [ball, terrain], " + ends + ", length: 2.1 }"),
            "links.0.length: is 2.1 m, but its ends are 2 m apart"));
  CHECK(has(refuse("{ name: l, type: rod, between: [ball, terrain], ends: [[0, 1], [0, 1]] }"),
            "links.0.ends: a rod needs a length above 0 m"));
  CHECK(has(refuse("{ name: l, type: spring, between: [ball, terrain], " + ends + ", stiffness: -5 N/m }"),
            "links.0.stiffness"));
  CHECK(has(refuse("{ name: l, type: spring, between: [ball, terrain], " + ends + " }"),
            "links.0: a spring needs `stiffness`, or `damping`, above 0"));
  CHECK(has(refuse("{ name: l, type: rod, between: [ball, terrain], " + ends + ", damping: 1 }"),
            "links.0.damping: is of a spring only"));
  CHECK(has(refuse("{ name: l, type: rod, between: [ball, terrain] }"),
            "links.0: `ends` is missing, which a rod needs"));
  CHECK(has(refuse("{ name: l, type: hinge, between: [ball, terrain], at: [0, 1], axis: [1, 0] }"),
            "links.0.axis: is of a hinge in 3D only"));
  CHECK(has(refuse("{ name: l, type: hinge, between: [ball, terrain], " + ends + " }"),
            "links.0: `at` is missing, which a hinge needs"));
  CHECK(has(refuse("{ name: l, type: hinge, between: [ball, terrain], at: [0, 0, 1] }", 3),
            "links.0: `axis` is missing, which a hinge needs"));
  CHECK(has(refuse("{ name: l, type: hinge, between: [ball, terrain], at: [0, 0, 1], axis: [0, 0, 0] }", 3),
            "links.0.axis: has no direction"));
  const std::string rod = "{ name: l, type: rod, between: [ball, terrain], " + ends + " }";
  CHECK(has(refuse(rod + ", " + rod), "links.1.name: the name `l` is taken by an earlier element"));
  CHECK(has(refuse("{ name: l, type: rob, between: [ball, terrain], " + ends + " }"), "rod"));
}

TEST_CASE("a run records its links, and reads back what it resolves to") {
  const LoadedScenario scenario = loaded("tests/unit/batch/links.yaml");
  const TrialRecords records = first_trial(scenario);
  REQUIRE(records.totals.bodies.size() == 3);
  for (const BodyHistory& body : records.totals.bodies) CHECK(body.reason == StopReason::timed_out);
  REQUIRE(records.series_links.size() == 4 * 500);
  double longest = 0, energy = 0;
  for (const auto& [trial, row] : records.series_links) {
    if (row.link == "pivot") CHECK((row.end_a - row.end_b).norm() < 1e-9);
    if (row.link == "cord") CHECK(row.length == Approx(1).epsilon(1e-10));
    if (row.link == "coil") longest = std::max(longest, row.length);
    if (row.link == "coil") energy = std::max(energy, row.energy);
  }
  const double sag = 2 * 9.81 / 500;
  CHECK(longest == Approx(1 + 2 * sag).epsilon(1e-4));
  CHECK(energy == Approx(0.5 * 500 * 4 * sag * sag).epsilon(1e-3));

  const std::string once = to_yaml(scenario.plan.resolved);
  const TemporaryFile copy("links.yaml", once);
  Diagnostics diagnostics;
  const auto again = load_scenario(copy.path, {}, diagnostics);
  INFO(once << diagnostics.to_text());
  REQUIRE(again);
  CHECK(to_yaml(again->plan.resolved) == once);
  CHECK(again->plan.points.front().links.at(2).a == 2);
}

}  // namespace links_of_scenario_test
