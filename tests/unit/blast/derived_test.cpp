// Derived numbers of a blast against formulas that are written out here.

#include "blast/derived.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <map>

#include "batch/inputs.h"
#include "load.h"
#include "scenario/derived_inputs.h"

using namespace flyrock;

namespace derived_test {

namespace {

double of(const DerivedNumbers& numbers, Derived derived) {
  return numbers[static_cast<std::size_t>(derived)];
}

struct HoleData {
  double burden, stemming, charge, subdrilling, time;
};

/// Table 2 of the paper as holes: diameter 102 mm, ANFO of 850 kg/m3, spacing 2.9 m, 2700 kg/m3, 90 degrees.
std::map<Derived, double> expected(const HoleData& hole, double delay) {
  const double d = 0.102, q_l = M_PI / 4 * d * d * 850, q = q_l * hole.charge;
  const double height = hole.charge + hole.stemming - hole.subdrilling, b = hole.burden;
  const double factor = q / (b * 2.9 * height);
  const double tail = std::min(hole.charge, 10 * d);
  std::map<Derived, double> numbers{
      {Derived::powder_factor, factor},
      {Derived::powder_factor_by_mass, factor / 2.7},
      {Derived::charge_ratio, q_l / (b * b * std::tan(M_PI / 4)) / 2700},
      {Derived::charge, q},
      {Derived::scaled_burden, b / std::sqrt(q_l)},
      {Derived::scaled_depth, (hole.stemming + tail / 2) / std::cbrt(tail * q_l)},
      {Derived::burden_to_diameter, b / d},
      {Derived::stemming_to_burden, hole.stemming / b}};
  if (delay > 0) numbers[Derived::delay_per_burden] = 1000 * delay / b;
  return numbers;
}

void check(const DerivedNumbers& found, const std::map<Derived, double>& wanted) {
  for (const auto& [derived, value] : wanted) {
    INFO(derived_infos()[static_cast<std::size_t>(derived)].name);
    CHECK(of(found, derived) == Approx(value).epsilon(1e-12));
  }
}

}  // namespace

TEST_CASE("the derived numbers of 24 holes are those of their formulas") {
  const LoadedScenario scenario = loaded("scenarios/ninh_dan/pattern.yaml");
  const BlastPlan& blast = *scenario.plan.points.front().blast;
  const std::vector<DerivedNumbers> holes = typical_of_holes(blast);
  REQUIRE(holes.size() == 24);
  double explosive = 0, rock = 0;
  for (std::size_t i = 0; i < holes.size(); ++i) {
    const Hole& hole = blast.pattern.measured[i];
    const HoleData data{hole.own[BlastField::burden], hole.own[BlastField::hole_stemming],
                        hole.own[BlastField::hole_charge_length], hole.own[BlastField::hole_subdrilling],
                        hole.time};
    const bool is_first = i % 8 == 0;
    const double delay = is_first ? 0 : hole.time - blast.pattern.measured[i - 1].time;
    INFO(hole.name);
    check(holes[i], expected(data, delay));
    CHECK(std::isnan(of(holes[i], Derived::delay_per_burden)) == is_first);
    const double q = M_PI / 4 * 0.102 * 0.102 * 850 * data.charge;
    explosive += q;
    rock += data.burden * 2.9 * (data.charge + data.stemming - data.subdrilling);
  }
  CHECK(of(typical_derived(blast), Derived::powder_factor) == Approx(explosive / rock).epsilon(1e-12));
  CHECK(of(typical_derived(blast), Derived::charge) == Approx(explosive / 24).epsilon(1e-12));
}

TEST_CASE("a rock has the derived numbers of its hole among its inputs, with what was drawn for it") {
  const LoadedScenario scenario = loaded("scenarios/ninh_dan/pattern.yaml");
  const Scenario& point = scenario.plan.points.front();
  const TrialRecords records = first_trial(scenario);
  std::map<std::string, double> inputs;
  // Regular, and not the first one of its row.
  const auto found = std::find_if(records.rocks.begin(), records.rocks.end(),
                                  [](const RockRecord& rock) { return rock.branch == 0 && rock.hole == 14; });
  REQUIRE(found != records.rocks.end());
  const int rock = found->rock;
  for (const InputRecord& row : records.inputs)
    if (row.rock == rock) inputs[inputs_of(point).at(static_cast<std::size_t>(row.input)).path] = row.value;
  const double burden = 3.2 + inputs.at("blast.scatter.burden"),
               stemming = 2.05 + inputs.at("blast.scatter.stemming");
  CHECK(inputs.at("derived.stemming_to_burden") == Approx(stemming / burden).epsilon(1e-12));
  CHECK(inputs.at("derived.burden_to_diameter") == Approx(burden / 0.102).epsilon(1e-12));
  CHECK(inputs.at("derived.delay_per_burden") == Approx(17 / burden).epsilon(1e-12));
}

TEST_CASE("rows behind the first have the distance of rows in their powder factor") {
  Blast blast;
  blast[BlastField::explosive_density] = 850;
  blast[BlastField::hole_diameter] = 0.1;
  blast[BlastField::hole_length] = 10.5;
  blast[BlastField::hole_stemming] = 2.5;
  blast[BlastField::hole_subdrilling] = 0.5;
  blast[BlastField::burden] = 2;
  blast[BlastField::spacing] = 3;
  complete(blast);
  const Pattern pattern{
      .rows = 2, .holes_per_row = 3, .row_distance = 2.5, .delay_row = 0.04, .delay_hole = 0.01};
  const double q = M_PI / 4 * 0.01 * 850 * 8;
  CHECK(of(derived_numbers(blast, pattern, 0, 0), Derived::powder_factor) ==
        Approx(q / (2 * 3 * 10)).epsilon(1e-12));
  CHECK(of(derived_numbers(blast, pattern, 4, 0), Derived::powder_factor) ==
        Approx(q / (2.5 * 3 * 10)).epsilon(1e-12));
  std::vector<double> times;
  for (int hole = 0; hole < 6; ++hole) times.push_back(pattern.time(hole));
  const std::vector<double> delays = delays_in_rows(pattern, times);
  CHECK(std::isnan(delays[3]));
  CHECK(delays[4] == Approx(0.01));
  // Without a spacing or a density of the rock these numbers are not known.
  blast[BlastField::spacing] = std::numeric_limits<double>::quiet_NaN();
  CHECK(std::isnan(of(derived_numbers(blast, pattern, 0, 0), Derived::powder_factor)));
  CHECK(std::isnan(of(derived_numbers(blast, pattern, 0, 0), Derived::charge_ratio)));
}

TEST_CASE("a derived number says what it is made of, and whether it differs") {
  const LoadedScenario scenario = loaded("scenarios/quarry/sensitivity.yaml");
  const Scenario& point = scenario.plan.points.front();
  const std::vector<std::string> of_factor = paths_made_of(*point.blast, Derived::powder_factor);
  CHECK(of_factor == std::vector<std::string>{"blast.hole.length", "blast.hole.stemming",
                                              "blast.hole.subdrilling", "blast.hole.linear_charge",
                                              "blast.burden", "blast.spacing"});
  CHECK(differs(point, Derived::powder_factor));
  CHECK(differs(point, Derived::burden_to_diameter));
  CHECK_FALSE(differs(point, Derived::delay_per_burden));  // one hole
}

}  // namespace derived_test
