// The design of a blast: what follows from what is given, against numbers by hand.

#include "blast/design.h"

#include <catch2/catch.hpp>

#include "math/space.h"

using namespace flyrock;
using enum flyrock::BlastField;

namespace design_test {

namespace {

/// Ninh Dan's holes in a bench of 8 m: 6.946 kg/m of ANFO.
Blast ninh_dan() {
  Blast blast;
  blast[explosive_density] = 850;
  blast[hole_diameter] = 0.102;
  blast[hole_length] = 8.8;
  blast[hole_stemming] = 2.6;
  blast[hole_subdrilling] = 0.8;
  blast[burden] = 2.7;
  blast[spacing] = 2.9;
  blast[rock_density] = 2700;
  blast[breakout_angle] = pi / 2;
  complete(blast);
  return blast;
}

}  // namespace

TEST_CASE("two lengths of a hole give the third") {
  CHECK(ninh_dan()[hole_charge_length] == Approx(6.2));
  Blast blast;
  blast[hole_stemming] = 2;
  blast[hole_charge_length] = 5;
  complete(blast);
  CHECK(blast[hole_length] == 7);
  Blast other;
  other[hole_length] = 7;
  other[hole_charge_length] = 5;
  complete(other);
  CHECK(other[hole_stemming] == 2);
  Blast one;
  one[hole_length] = 7;
  complete(one);
  CHECK(std::isnan(one[hole_charge_length]));
  other[hole_stemming] = std::numeric_limits<double>::quiet_NaN();
  other[hole_charge_length] = 8;
  CHECK_THROWS_WITH(complete(other), "blast.hole: a length of 7 m leaves -1 m of stemming and 8 m of charge");
}

TEST_CASE("the least burden of a hole between crest and toe") {
  Blast blast = ninh_dan();
  const auto least = [&](double crest, double toe, double deviation) {
    Blast b = blast;
    b[burden] = std::numeric_limits<double>::quiet_NaN();
    b[burden_crest] = crest;
    b[burden_toe] = toe;
    b[hole_deviation] = deviation;
    complete(b);
    return b[burden];
  };
  CHECK(least(2.7, 2.7, 0) == Approx(2.7));
  CHECK(least(2.5, 3.3, 0) == Approx(2.5 + 0.8 * 2.6 / 8));  // at the top of the charge, not at the crest
  CHECK(least(3.3, 2.5, 0) == Approx(2.5));
  CHECK(least(2.7, 2.7, 0.05) == Approx(2.7 - 0.05 * 8));  // at the floor
  CHECK(least(2.7, 2.7, -0.05) == Approx(2.7 + 0.05 * 2.6));
  CHECK_THROWS_WITH(least(2.7, 2.7, 0.4),
                    "blast.hole.deviation: the hole deviates by 3.2 m at the floor and leaves the rock");
}

TEST_CASE("charges and powder factors of Ninh Dan's pattern") {
  const BlastDesign design = design_of(ninh_dan(), {.rows = 3, .holes_per_row = 8, .row_distance = 3.2});
  CHECK(design.linear_charge == Approx(6.946).epsilon(1e-4));
  CHECK(design.charge_per_hole == Approx(43.06).epsilon(1e-3));
  CHECK(design.explosive == Approx(24 * 43.06).epsilon(1e-3));
  CHECK(design.rock == Approx(8 * 2.9 * 8 * (2.7 + 2 * 3.2)));
  CHECK(design.powder_factor_shallow == Approx(0.476).epsilon(2e-3));
  CHECK(design.powder_factor_deep == Approx(0.762).epsilon(2e-3));
  // The paper states 0.37 to 0.40; a hole of the back rows has 43 kg / (2.9 x 3.2 x 8) = 0.58.
  CHECK(43.06 / (2.9 * 3.2 * 8) == Approx(0.58).epsilon(1e-2));
  CHECK(design.powder_factor == Approx(design.explosive / design.rock));
  Blast stated = ninh_dan();
  CHECK(disagreement(stated, design).empty());
  stated[powder_factor] = 0.385;
  CHECK(disagreement(stated, design) ==
        "the powder factor is given as 0.385 kg/m3; charge, burden, spacing and bench height make it 0.612");
  stated = ninh_dan();
  stated[spacing] = 1.5;
  CHECK(disagreement(stated, design_of(stated, {})) ==
        "the pattern has 1.33 kg/m3; the prism that a hole breaks out makes it 0.476 (shallow) to 0.762 "
        "(deep)");
}

TEST_CASE("a design says nothing of what it does not know") {
  Blast blast;
  blast[burden] = 3;
  const BlastDesign design = design_of(blast, {});
  CHECK(std::isnan(design.explosive));
  CHECK(std::isnan(design.powder_factor));
  CHECK(std::isnan(design.depth_of_burial));
  CHECK(disagreement(blast, design).empty());
}

TEST_CASE("holes go off along the rows") {
  const Pattern pattern{.rows = 3,
                        .holes_per_row = 8,
                        .row_distance = 3.2,
                        .delay_row = 0.042,
                        .delay_hole = 0.017,
                        .delay_in_hole = 0.4};
  CHECK(pattern.holes() == 24);
  CHECK(pattern.time(0) == Approx(0.4));
  CHECK(pattern.time(7) == Approx(0.4 + 7 * 0.017));
  CHECK(pattern.time(8) == Approx(0.4 + 0.042));
  CHECK(pattern.row(23) == 2);
  CHECK(pattern.time(23) == Approx(0.4 + 2 * 0.042 + 7 * 0.017));
}

TEST_CASE("an emulsion takes D/3") {
  const auto found = std::find_if(explosives().begin(), explosives().end(),
                                  [](const Explosive& explosive) { return explosive.name == "emulsion"; });
  REQUIRE(found != explosives().end());
  CHECK(found->gurney_constant == Approx(found->detonation_velocity / 3));
  CHECK_FALSE(found->is_anfo);
}

}  // namespace design_test
