// The fit of numbers to what was measured, on models that are known.

#include "results/compare/calibration.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "random/stream.h"
#include "results/compare/misfit.h"
#include "results/compare/varied_number.h"

namespace flyrock::calibration_test {

namespace {

/// 41 rocks whose distances are normal, with a mean and a deviation that are both fitted. All points have the
/// same random numbers.
class TwoNumberModel {
 public:
  static constexpr std::size_t rows = 41;

  static double mean_at(int place) { return 30 + 40.0 * place / lattice; }
  static double deviation_at(int place) { return 2 + 16.0 * place / lattice; }

  const MisfitPool& pool(const LatticePoint& at) { return model(at).pool; }
  double noise_p90(const LatticePoint& at) { return model(at).noise_p90; }

  /// The model that is fitted to these values; `of`: the numbers of the model at a point.
  CalibratedModel fitted_to(
      std::vector<Vec2> values,
      std::function<LatticePoint(const LatticePoint&)> of = [](const auto& at) { return at; }) {
    return {.evaluate =
                [this, values, of](const LatticePoint& point) {
                  const Model& here = model(of(point));
                  Evaluation evaluation;
                  evaluation.energy = evaluation.misfit = here.pool.energy_of(values);
                  evaluation.noise_p90 = here.noise_p90;
                  evaluation.table = here.table;
                  return evaluation;
                },
            .draws = [this, of](const LatticePoint& point) { return model(of(point)).draws; }};
  }

  std::vector<Vec2> measured(const LatticePoint& truth, std::uint64_t repeat) const {
    std::vector<Vec2> values;
    for (std::size_t r = 0; r < rows; ++r) values.emplace_back(value(truth, "measured", r, repeat), 0);
    return values;
  }

 private:
  struct Model {
    MisfitPool pool;
    double noise_p90;
    DistanceTable table;
    std::vector<std::vector<Vec2>> draws;
  };

  static double value(const LatticePoint& at, const char* stream, std::size_t row, std::uint64_t trial) {
    DrawKey key;
    key.trial = trial;
    key.rock = row;
    RandomStream rng(3, stream, key);
    return mean_at(at[0]) + deviation_at(at.size() > 1 ? at[1] : lattice / 2) * rng.normal();
  }

  Model& model(const LatticePoint& at) {
    if (const auto known = models_.find(at); known != models_.end()) return known->second;
    constexpr std::uint64_t trials = 40;
    std::vector<SimulatedRow> simulated(rows);
    std::vector<const SimulatedRow*> list;
    for (std::size_t r = 0; r < rows; ++r) {
      for (std::uint64_t t = 0; t < trials; ++t)
        simulated[r].values.push_back({t, {value(at, "model", r, t), 0}, false});
      list.push_back(&simulated[r]);
    }
    MisfitPool pool(list, false, Censored::at_their_end);
    const double p90 = SortedSample(pool.energies_of_draws(rows, 1)).quantile(0.9);
    const DistanceTable table = pool.table();
    auto draws = pool.drawn(rows, 1);
    return models_.emplace(at, Model{std::move(pool), p90, table, std::move(draws)}).first->second;
  }

  std::map<LatticePoint, Model> models_;
};

/// Calibrates to one more trial of the model at `truth`.
Calibration fit(TwoNumberModel& model, const LatticePoint& truth, std::uint64_t repeat,
                int evaluations = 80) {
  return calibrate(truth.size(), model.fitted_to(model.measured(truth, repeat)), evaluations);
}

/// A model with a misfit that is given, and one value in all trials.
CalibratedModel with_misfit(std::function<double(const LatticePoint&)> misfit) {
  return {.evaluate =
              [misfit](const LatticePoint& at) {
                Evaluation evaluation;
                evaluation.energy = evaluation.misfit = misfit(at);
                evaluation.noise_p90 = 0.5;
                evaluation.table = DistanceTable(SortedSample({1.0}));
                return evaluation;
              },
          .draws = [](const LatticePoint&) { return std::vector<std::vector<Vec2>>{{Vec2(1, 0)}}; }};
}

/// Fits `repeats` times 41 deposits: in how many of them the region has the true point.
int covered_by_regions(int repeats) {
  TwoNumberModel model;
  const LatticePoint truth = {400};
  int covered = 0;
  double sum = 0, squares = 0;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const Calibration found = fit(model, truth, static_cast<std::uint64_t>(repeat));
    const double share = truth[0] / static_cast<double>(lattice);
    const double error = found.best.at[0] / static_cast<double>(lattice) - share;
    sum += error;
    squares += error * error;
    covered += found.region.front().low <= share && share <= found.region.front().high;
  }
  // The best point is that of the mean: 10 m / sqrt(41), of a way of 40 m.
  CHECK(std::abs(sum / repeats) < 0.01);
  CHECK(std::sqrt(squares / repeats) == Approx(10 / std::sqrt(41.0) / 40).epsilon(0.2));
  return covered;
}

}  // namespace

// 90 %, within twice the scatter of so many repeats.
TEST_CASE("the region of 41 deposits covers the truth in 78 to 99 % of 40 repeats", "[slow]") {
  const int covered = covered_by_regions(40);
  CHECK(covered >= 31);
  CHECK(covered <= 39);
}

TEST_CASE("the region of 41 deposits covers the truth in 85 to 95 % of 200 repeats", "[heavy]") {
  const int covered = covered_by_regions(200);
  CHECK(covered >= 170);
  CHECK(covered <= 190);
}

TEST_CASE("two numbers are found together, and a true point is in the region about as often as it should",
          "[slow]") {
  TwoNumberModel model;
  const LatticePoint truth = {420, 480};
  int covered = 0;
  constexpr int repeats = 60;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const std::vector<Vec2> measured = model.measured(truth, static_cast<std::uint64_t>(repeat));
    covered += model.pool(truth).energy_of(measured) <= model.noise_p90(truth);
  }
  CHECK(covered >= 47);
  CHECK(covered <= 59);
  const Calibration found = fit(model, truth, 1, 120);
  CHECK(TwoNumberModel::mean_at(found.best.at[0]) ==
        Approx(TwoNumberModel::mean_at(truth[0])).margin(3 * 10 / std::sqrt(41.0)));
  CHECK(TwoNumberModel::deviation_at(found.best.at[1]) == Approx(10).margin(4));
  CHECK(found.agrees);
  CHECK(found.region[0].is_determined());
  CHECK_FALSE(found.any_on_bound());
  REQUIRE(found.correlation);
  CHECK((*found.correlation)[0][1] == (*found.correlation)[1][0]);
  CHECK(std::abs((*found.correlation)[0][1]) < 0.7);
  std::map<LatticePoint, int> seen;
  for (const Evaluation& evaluation : found.evaluations) ++seen[evaluation.at];
  CHECK(seen.size() == found.evaluations.size());  // no point is asked for twice
}

TEST_CASE("a best point at the end of a way is on the bound, and its region is open there", "[slow]") {
  TwoNumberModel model;
  const Calibration found = calibrate(1, model.fitted_to({{200, 0}, {210, 0}, {220, 0}}), 40);
  CHECK(found.any_on_bound());
  CHECK(found.best.at[0] == lattice);
  CHECK(found.region.front().is_open_above);
  CHECK_FALSE(found.agrees);
}

TEST_CASE("a form that does not describe what was measured does not agree, and its region is not too small",
          "[slow]") {
  // Two groups of 30 and 70 m, where the model has one mean and a deviation of 10 m: the mean of 41 is known
  // to 20 m / sqrt(41), however bad the form is.
  TwoNumberModel model;
  std::vector<Vec2> two_groups;
  for (int i = 0; i < 41; ++i) two_groups.emplace_back(i % 2 == 0 ? 30 : 70, 0);
  const Calibration found = calibrate(1, model.fitted_to(two_groups), 30);
  CHECK_FALSE(found.agrees);
  const RegionRange& range = found.region.front();
  CHECK(range.low * 40 + 30 < 49.5);
  CHECK(range.high * 40 + 30 > 50.5);
  CHECK(range.high - range.low > 0.05);
  for (const Evaluation& evaluation : found.evaluations)
    if (evaluation.at == found.best.at) CHECK(evaluation.is_inside);
}

TEST_CASE("a table of mean distances is that of its sample, also beyond it") {
  const SortedSample line({1.0, 2.0, 5.0, 9.0});
  const std::vector<double> places{-3, 0.5, 1, 3.3, 7, 9, 20};
  for (const double x : places) {
    const double energy = 2 * line.mean_distance(x) - line.own_distance();
    CHECK(DistanceTable(line).partial_energy({{x, 0}}) == Approx(energy).margin(1e-2));
  }
  std::vector<Vec2> cloud;
  for (int i = 0; i < 100; ++i) cloud.emplace_back(10 * std::cos(i), 20 * std::sin(1.7 * i));
  const PlaneSample plane(cloud);
  for (const Vec2& x : {Vec2(0, 0), Vec2(-3, 7), Vec2(100, 50)}) {
    const double energy = 2 * plane.mean_distance(x) - plane.own_distance();
    CHECK(DistanceTable(plane).partial_energy({x}) == Approx(energy).epsilon(0.02));
  }
}

TEST_CASE("a least misfit next to an end of a way is at this end") {
  for (const int least : {0, 4, lattice - 6}) {
    INFO(least);
    const Calibration found =
        calibrate(1, with_misfit([&](const LatticePoint& at) { return std::abs(at[0] - least); }), 40);
    CHECK(std::abs(found.best.at[0] - least) <= 2);
    CHECK(end_at(found.best.at[0]) == (least < lattice / 2 ? WayEnd::low : WayEnd::high));
    CHECK(found.any_on_bound());
  }
  CHECK(end_at(30) == WayEnd::none);
  CHECK(end_at(lattice - 30) == WayEnd::none);
}

TEST_CASE("a number that the model does not read is not determined", "[slow]") {
  TwoNumberModel model;
  const auto first = [](const LatticePoint& at) { return LatticePoint{at[0]}; };
  const Calibration found = calibrate(2, model.fitted_to(model.measured({400}, 7), first), 80);
  CHECK(found.region[0].is_determined());
  CHECK_FALSE(found.region[1].is_determined());
  CHECK(found.region[1].is_open_below);
  CHECK(found.region[1].is_open_above);
}

TEST_CASE("an error of a point ends the search as itself") {
  struct Stop {};
  int asked = 0;
  const CalibratedModel model = with_misfit([&](const LatticePoint& at) {
    if (++asked == 40) throw Stop{};  // in the search, inside of the library
    return std::abs(at[0] - 501.5);
  });
  CHECK_THROWS_AS(calibrate(1, model, 40), Stop);
  CHECK(asked == 40);
}

TEST_CASE("a number to vary is read with its unit, and written so that nothing of it is lost") {
  std::string fault;
  const auto angle = read_varied("materials.r.roughness.angle.normal.sd=2 deg:20 deg", fault);
  REQUIRE(angle);
  CHECK(angle->path == "materials.r.roughness.angle.normal.sd");
  CHECK(angle->text_at(0.5) == "11 deg");
  CHECK(angle->si_at(1) == Approx(pi / 9));
  const auto mixed = read_varied("a=10 cm:2 m", fault);
  REQUIRE(mixed);
  CHECK(mixed->text_at(1) == "200 cm");
  CHECK(read_varied("mu=0.3:0.7", fault)->text_at(0.25) == "0.4");
  for (const auto& [text, what] :
       std::vector<std::pair<std::string, std::string>>{{"mu", "PATH=LOW:HIGH"},
                                                        {"=1:2", "PATH=LOW:HIGH"},
                                                        {"mu=0.3", "PATH=LOW:HIGH"},
                                                        {"mu=a:2", "`a` is no number"},
                                                        {"mu=1:", "`` is no number"},
                                                        {"mu=1 m:2 kg", "different kinds"},
                                                        {"mu=2:1", "below the greatest"},
                                                        {"mu=1:1", "below the greatest"}}) {
    INFO(text);
    CHECK_FALSE(read_varied(text, fault));
    CHECK(fault.find(what) != std::string::npos);
  }
}

}  // namespace flyrock::calibration_test
