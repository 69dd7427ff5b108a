// Rows over time: they hold what moved the bodies, and measures are taken from them.
#include <cmath>

#include "load.h"
#include "results/measured/contact_measure.h"

using namespace flyrock;

namespace series_test {

namespace {

std::vector<SeriesContact> contacts_of(const TrialRecords& records) {
  std::vector<SeriesContact> rows;
  for (const auto& [trial, row] : records.series_contacts) rows.push_back(row);
  return rows;
}

/// The vertical impulse that a body had in steps and impacts [N s].
double vertical_impulse(const TrialRecords& records, const std::string& body) {
  double sum = 0;
  for (const SeriesContact& row : contacts_of(records))
    if (row.a == body || row.b == body)
      sum += (row.a == body ? 1 : -1) * (row.pn * row.normal.y() - row.pt * row.normal.x());
  return sum;
}

}  // namespace

TEST_CASE("forces over time, impacts and weight change the momentum of each body") {
  const LoadedScenario scenario = loaded("tests/unit/batch/over_time.yaml");
  const TrialRecords records = first_trial(scenario);
  const auto& bodies = scenario.plan.points.front().bodies;
  constexpr double g = 9.81;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    INFO(bodies[i].name);
    const BodyHistory& history = records.totals.bodies[i];
    const double mass = bodies[i].mass->constant, time = history.last.time;
    const double change = mass * (history.last.velocity.y() - history.first.velocity.y());
    const double scale = mass * g * time;
    CHECK(vertical_impulse(records, bodies[i].name) == Approx(change + scale).margin(1e-9 * scale));
  }
}

TEST_CASE("energies over time are those of the bodies, and only impacts and friction take from them") {
  const TrialRecords records = first_trial(loaded("tests/unit/batch/over_time.yaml"));
  double before = 1e300;
  int rows = 0;
  for (const auto& [trial, row] : records.series_bodies) {
    if (row.body != "disk") continue;
    CHECK(row.potential_energy == Approx(2 * 9.81 * row.state.position.y()).margin(1e-12));
    const double energy = row.state.kinetic_energy + row.potential_energy;
    CHECK(energy <= before + 1e-6);
    before = energy;
    ++rows;
  }
  CHECK(rows > 10);
}

TEST_CASE("rows at multiples of a time lie within flights too") {
  const TrialRecords records =
      first_trial(loaded("scenarios/course/bouncing_ball.yaml", {.set = {"output.series={ every: 50 ms }"}}));
  REQUIRE(records.series_bodies.size() > 6);
  const double height = records.series_bodies[0].row.state.position.y();
  for (int i = 1; i < 6; ++i) {
    const double time = 0.05 * i;
    const BodyState& state = records.series_bodies[static_cast<std::size_t>(i)].row.state;
    CHECK(state.time == Approx(time));
    CHECK(state.position.y() == Approx(height - 0.5 * 9.81 * time * time).epsilon(1e-12));
  }
}

TEST_CASE("only the bodies that are named have rows, and their contacts") {
  const TrialRecords records =
      first_trial(loaded("tests/unit/batch/over_time.yaml", {.set = {"output.series={ bodies: [disk] }"}}));
  for (const auto& [trial, row] : records.series_bodies) CHECK(row.body == "disk");
  for (const SeriesContact& row : contacts_of(records)) CHECK((row.a == "disk" || row.b == "disk"));
  CHECK_FALSE(records.series_contacts.empty());
  const TrialRecords upper = first_trial(
      loaded("scenarios/course/gauss_seidel.yaml", {.set = {"output.series={ bodies: [box_4] }"}}));
  for (const SeriesContact& row : contacts_of(upper)) {
    CHECK(row.a == "box_3");  // named, though it has no rows of its own
    CHECK(row.b == "box_4");
  }
  CHECK_FALSE(upper.series_contacts.empty());
}

TEST_CASE("measures of a contact over time") {
  const std::vector<SeriesContact> rows = contacts_of(first_trial(loaded("tests/unit/batch/over_time.yaml")));
  const auto value = [&](const std::string& a, const std::string& b, const std::string& quantity,
                         const std::string& of_time, double time = 0) {
    return ContactMeasure{a, b, quantity, {of_time, time, false}}.value(rows);
  };
  for (const char* of_time : {"mean", "max", "min", "final"})
    CHECK(value("lower", "terrain", "rn", of_time).value == Approx(2 * 9.81).epsilon(1e-9));
  CHECK(value("upper", "lower", "rn", "at", 0.5).value == Approx(9.81).epsilon(1e-9));
  CHECK(value("lower", "upper", "gap", "min").value > -1e-9);
  CHECK(value("lower", "box", "rn", "mean").fault == "lower and box have no contact in a step");
  CHECK(value("disk", "terrain", "rn", "at", 0.1).fault == "disk and terrain have no contact at 0.1 s");
}

}  // namespace series_test
