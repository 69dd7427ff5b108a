#include "blast/kuz_ram.h"

#include <catch2/catch.hpp>

using namespace flyrock;

namespace {

/// A hole of 102 mm, 4.4 m of charge above a floor 7 m deep, in a pattern of 2.7 m x 2.9 m.
Blast blast() {
  Blast blast;
  blast[BlastField::hole_diameter] = 0.102;
  blast[BlastField::hole_length] = 7;
  blast[BlastField::hole_subdrilling] = 0;
  blast[BlastField::hole_charge_length] = 4.4;
  blast[BlastField::burden] = 2.7;
  blast[BlastField::spacing] = 2.9;
  blast[BlastField::explosive_density] =
      30 / (4.4 * 0.25 * 3.14159265358979 * 0.102 * 0.102);  // 30 kg a hole
  return blast;
}

}  // namespace

TEST_CASE("Kuz-Ram by hand: 54.81 m3 and 30 kg a hole give 21.8 cm and a uniformity of 1.073") {
  const Blast hole = blast();
  CHECK(volume_of_hole(hole) == Approx(54.81));
  const FragmentSizes sizes = kuz_ram(hole, {7, 1, 0.25});
  CHECK(sizes.median ==
        Approx(0.07 * std::pow(54.81 / 30, 0.8) * std::pow(30, 1.0 / 6) * std::pow(1.15, 19.0 / 30)));
  CHECK(sizes.median == Approx(0.218).margin(5e-4));
  CHECK(sizes.uniformity == Approx(1.073).margin(1e-3));
  // Size that 63.2 % passes, and the share above 1 m
  CHECK(sizes.median / std::pow(std::log(2), 1 / sizes.uniformity) == Approx(0.307).margin(1e-3));
  CHECK(std::pow(2, -std::pow(1 / sizes.median, sizes.uniformity)) == Approx(0.029).margin(1e-3));
}

TEST_CASE("a stronger explosive breaks finer, and a burden too large for the hole has no uniformity") {
  Blast hole = blast();
  CHECK(kuz_ram(hole, {7, 1.2, 0}).median ==
        Approx(kuz_ram(hole, {7, 1, 0}).median * std::pow(1.2, -19.0 / 30)));
  hole[BlastField::burden] = 17;
  CHECK_THROWS_WITH(kuz_ram(hole, {}), Catch::Contains("the burden is 17 m, the hole 102 mm"));
  hole[BlastField::burden] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(kuz_ram(hole, {}), Catch::Contains("blast.burden"));
}
