#include "record/maps.h"

#include <cmath>
#include <map>
#include <set>

#include "load.h"
#include "record/columns.h"

using namespace flyrock;

namespace {

const PlanGrid map_grid{{0, 0}, 1, 20, 10};

Maps of_rocks(int from, int to) {
  Maps maps(map_grid);
  for (int i = from; i <= to; ++i) {
    const auto index = static_cast<std::uint32_t>(i % 7);
    maps.add({{.index = index, .height = 0.1 * i, .speed = 1.0 * i, .energy = 1000.0 * i}, {.index = 150}},
             index);
  }
  return maps;
}

TrialRecords all_trials(const LoadedScenario& scenario) {
  TrialRunner runner(scenario.plan.points.front());
  TrialRecords records;
  for (std::uint64_t trial = 0; trial < scenario.plan.points.front().trials; ++trial)
    runner.run(trial, records);
  return records;
}

const MapRasters::Cell* cell_at(const MapRasters& maps, const Vec2& place) {
  const auto index = maps.grid.index(place);
  for (const MapRasters::Cell& cell : maps.cells)
    if (index && cell.index == *index) return &cell;
  return nullptr;
}

}  // namespace

TEST_CASE("a cell of a map counts its rocks and knows their values") {
  const MapRasters rasters = rasters_of(of_rocks(1, 70));
  REQUIRE(rasters.cells.size() == 8);
  const auto& values = rasters.cells[0].values;  // of rocks 7, 14, ... 70
  CHECK(values[0] == 10);
  CHECK(values[1] == Approx(100 * 10 / 70.0));
  CHECK(values[2] == Approx(38.5));
  CHECK(values[3] == Approx(70).epsilon(0.05));
  CHECK(values[4] == 70);
  CHECK(values[5] == Approx(3.85));
  CHECK(values[6] == Approx(7).epsilon(0.05));
  CHECK(values[7] == Approx(7));
  CHECK(values[8] == 70);
  CHECK(values[9] == 10);
  CHECK(rasters.cells[7].index == 150);
  CHECK(rasters.cells[7].values[0] == 70);
  CHECK(rasters.cells[7].values[9] == 0);
}

TEST_CASE("maps of parts add up, and read back as they were written") {
  Maps sum;
  sum.add(of_rocks(1, 30));
  sum.add(of_rocks(31, 70));
  CHECK(sum.bytes() == of_rocks(1, 70).bytes());
  CHECK(Maps::read(sum.bytes()).bytes() == sum.bytes());
  CHECK(Maps::read("").grid().empty());
  const std::string bytes = sum.bytes();
  for (std::size_t size = 1; size < bytes.size(); ++size)
    CHECK_THROWS_AS(Maps::read(bytes.substr(0, size)), ColumnError);
  CHECK_THROWS_AS(Maps::read(bytes + '\0'), ColumnError);
}

TEST_CASE("one parabola over flat ground: the cells that it passes, and its height over each") {
  const LoadedScenario scenario = loaded("tests/unit/batch/one_parabola.yaml");
  const TrialRecords records = first_trial(scenario);
  const MapRasters rasters = rasters_of(records.totals.maps);
  // From (0.3, 0.2, 2) with (12, 5, 9) m/s: every cell under the segment to the landing.
  constexpr double g = 9.81, mass = 500;
  const Vec3 start(0.3, 0.2, 2), velocity(12, 5, 9);
  const double end = (velocity.z() + std::sqrt(velocity.z() * velocity.z() + 2 * g * start.z())) / g;
  std::map<std::uint32_t, std::pair<double, double>> times;  // of entry and exit
  std::set<double> cuts = {0, end};
  for (int k = 1; k < 60; ++k) {
    cuts.insert(std::min(end, (k - start.x()) / velocity.x()));
    cuts.insert(std::min(end, (k - start.y()) / velocity.y()));
  }
  for (auto cut = cuts.begin(); std::next(cut) != cuts.end(); ++cut) {
    const double middle = 0.5 * (*cut + *std::next(cut));
    times[*rasters.grid.index((start + middle * velocity).head<2>())] = {*cut, *std::next(cut)};
  }
  REQUIRE(rasters.cells.size() == times.size());
  CHECK(times.size() > 30);
  for (const MapRasters::Cell& cell : rasters.cells) {
    INFO(cell.index);
    REQUIRE(times.contains(cell.index));
    const auto [t0, t1] = times[cell.index];
    const auto height = [&](double t) { return start.z() + velocity.z() * t - 0.5 * g * t * t; };
    const auto squared = [&](double t) { return 12.0 * 12 + 5.0 * 5 + std::pow(velocity.z() - g * t, 2); };
    const double apex = std::clamp(velocity.z() / g, t0, t1), fastest = std::max(squared(t0), squared(t1));
    CHECK(cell.values[0] == 1);
    CHECK(cell.values[1] == 100);
    CHECK(cell.values[4] == Approx(0.5 * mass * fastest / 1000).epsilon(1e-9));
    CHECK(cell.values[7] == Approx(height(apex)).epsilon(1e-9).margin(1e-9));
    CHECK(cell.values[8] == Approx(std::sqrt(fastest)).epsilon(1e-9));
  }
  const MapRasters::Cell* landing = cell_at(rasters, (start + end * velocity).head<2>());
  REQUIRE(landing);
  CHECK(landing->values[9] == 1);
}

TEST_CASE("maps of points and of bodies agree with their stored trajectories and stops") {
  const std::string method = GENERATE("ballistic", "lumped_mass", "nscd");
  INFO(method);
  const LoadedScenario scenario = loaded("tests/unit/batch/mapped.yaml", {.set = {"method=" + method}});
  const TrialRecords records = all_trials(scenario);
  const MapRasters rasters = rasters_of(records.totals.maps);
  double stopped = 0, expected = 0, deepest = 0;
  for (const MapRasters::Cell& cell : rasters.cells) stopped += cell.values[9];
  for (const RockRecord& rock : records.rocks) {
    REQUIRE_FALSE(is_fault(rock.reason));
    expected += rock.reason == StopReason::stopped && rasters.grid.index({rock.stop_x, rock.stop_y});
    deepest = std::max(deepest, rock.max_speed);
  }
  CHECK(stopped == expected);
  CHECK(expected > 0);
  // Each stored point lies within what its cell knows.
  std::map<std::uint32_t, std::set<std::uint64_t>> passed;
  for (const TrajectoryRecord& row : records.trajectories) {
    const auto index = rasters.grid.index(row.point.state.position.head<2>());
    if (index) passed[*index].insert(row.trial);
    const MapRasters::Cell* cell = cell_at(rasters, row.point.state.position.head<2>());
    if (!index) continue;
    REQUIRE(cell);
    CHECK(row.point.state.velocity.norm() <= cell->values[8] * (1 + 1e-6) + 1e-9);
    CHECK(row.point.state.kinetic_energy <= cell->values[4] * 1000 * (1 + 1e-6) + 1e-9);
  }
  // All but cells that a path grazes are passed by as many rocks as have a stored point there.
  std::size_t grazed = 0, passages = 0;
  for (const MapRasters::Cell& cell : rasters.cells) {
    const auto seen = static_cast<std::size_t>(cell.values[0]);
    CHECK(seen >= passed[cell.index].size());
    passages += seen;
    grazed += seen - passed[cell.index].size();
  }
  CHECK(grazed * 20 < passages);
}

TEST_CASE("the cells of maps come from the scenario or the ground, at most 250,000") {
  const Scenario scenario = loaded("tests/unit/batch/mapped.yaml").plan.points.front();
  CHECK(scenario.output.maps.cell == 1);
  const LoadedScenario free = loaded("tests/unit/batch/mapped.yaml", {.set = {"output.maps=true"}});
  CHECK(first_trial(free).totals.maps.grid().empty());  // a plane has no ends
  const LoadedScenario none = loaded("tests/unit/batch/mapped.yaml", {.set = {"output.maps=false"}});
  CHECK(first_trial(none).totals.maps.grid().empty());
  const LoadedScenario fine = loaded("tests/unit/batch/mapped.yaml", {.set = {"output.maps.cell=1 cm"}});
  CHECK_THROWS_WITH(TrialRunner(fine.plan.points.front()), Catch::Contains("more than 250000 cells"));
}
