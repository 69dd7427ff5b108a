// The blast's fields and the launch speeds that follow from them, against reference values of field.md.

#include "blast/blast.h"

#include <catch2/catch.hpp>

#include "blast/bench_fit.h"
#include "blast/gurney.h"
#include "blast/mckenzie.h"
#include "math/space.h"
#include "units/units.h"

using namespace flyrock;

namespace {

/// Holes of 102 mm with ANFO in limestone: the common case of Ninh Dan.
Blast ninh_dan(double burden = 2.7) {
  Blast blast;
  const Explosive& anfo = explosives().front();
  blast[BlastField::explosive_density] = anfo.density;
  blast[BlastField::detonation_velocity] = anfo.detonation_velocity;
  blast[BlastField::gurney_constant] = anfo.gurney_constant;
  blast[BlastField::hole_diameter] = 0.102;
  blast[BlastField::burden] = burden;
  blast[BlastField::rock_density] = 2700;
  blast[BlastField::breakout_angle] = pi / 2;
  blast.is_anfo = true;
  return blast;
}

}  // namespace

TEST_CASE("every field of a blast is described, in order") {
  REQUIRE(blast_fields().size() == static_cast<std::size_t>(BlastField::count));
  for (std::size_t i = 0; i < blast_fields().size(); ++i) {
    const BlastFieldInfo& info = blast_fields()[i];
    CHECK(static_cast<std::size_t>(info.field) == i);
    const auto unit = parse_unit(info.unit.empty() ? "1" : info.unit);
    REQUIRE(unit);
    CHECK(unit->factor == 1);
    CHECK(unit->dimension == info.dimension);
  }
}

TEST_CASE("ANFO has the Gurney constant 0.44 D") {
  CHECK(explosives().front().name == "ANFO");
  CHECK(explosives().front().gurney_constant == Approx(1880).epsilon(1e-4));
}

TEST_CASE("the ratio of charge to broken rock") {
  CHECK(charge_to_mass(ninh_dan()) == Approx(3.529e-4).epsilon(2e-4));
  Blast wide = ninh_dan();
  wide[BlastField::breakout_angle] = 2 * pi / 3;
  CHECK(charge_to_mass(wide) == Approx(charge_to_mass(ninh_dan()) / std::sqrt(3.0)).epsilon(1e-14));
}

TEST_CASE("a field that makes no charge is named") {
  Blast blast = ninh_dan(-1);
  CHECK_THROWS_WITH(charge_to_mass(blast), "blast.burden is -1 m, must be above 0");
  blast = ninh_dan();
  blast[BlastField::hole_diameter] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(charge_to_mass(blast), "blast.hole.diameter is nan m, must be above 0");
  blast = ninh_dan();
  blast[BlastField::breakout_angle] = 3.2;
  CHECK_THROWS_WITH(charge_to_mass(blast), "blast.breakout_angle is 3.2 rad, must be below pi");
}

TEST_CASE("the Gurney geometries") {
  CHECK(gurney_factor(GurneyGeometry::roth, 0.25) == Approx(0.5));
  CHECK(gurney_factor(GurneyGeometry::cylinder, 1) == Approx(std::sqrt(2.0 / 3)));
  CHECK(gurney_factor(GurneyGeometry::sphere, 1) == Approx(std::sqrt(5.0 / 8)));
  CHECK(gurney_factor(GurneyGeometry::sandwich, 1) == Approx(std::sqrt(3.0 / 4)));
  for (auto geometry : {GurneyGeometry::cylinder, GurneyGeometry::sphere, GurneyGeometry::sandwich})
    CHECK(gurney_factor(geometry, 1e-4) == Approx(1e-2).epsilon(1e-4));
}

TEST_CASE("the fits say nothing below a charge of their own") {
  struct Threshold {
    BenchRock rock;
    bool anfo;
    double ratio, burden;
  };
  for (const Threshold& t : {Threshold{BenchRock::granite, true, 1.675e-4, 3.92},
                             Threshold{BenchRock::granite, false, 1.415e-4, 4.26},
                             Threshold{BenchRock::limestone, true, 6.667e-5, 6.21},
                             Threshold{BenchRock::limestone, false, 6.667e-5, 6.21}}) {
    const BenchFit fit = bench_fit(t.rock, t.anfo);
    CHECK(fit.offset / fit.slope == Approx(t.ratio).epsilon(5e-4));
    CHECK(squared_speed(fit, BenchFitForm::linear, charge_to_mass(ninh_dan(t.burden - 0.01))) > 0);
    CHECK(squared_speed(fit, BenchFitForm::linear, charge_to_mass(ninh_dan(t.burden + 0.01))) < 0);
  }
}

TEST_CASE("the paper's 2 to 3 m/s need a burden beyond 6 m") {
  const BenchFit limestone = bench_fit(BenchRock::limestone, true);
  CHECK(std::sqrt(squared_speed(limestone, BenchFitForm::linear, charge_to_mass(ninh_dan(6.15)))) ==
        Approx(2).epsilon(0.05));
  CHECK(std::sqrt(squared_speed(limestone, BenchFitForm::linear, charge_to_mass(ninh_dan(6.08)))) ==
        Approx(3).epsilon(0.05));
}

TEST_CASE("McKenzie's charge and fragment") {
  Blast blast;
  blast[BlastField::explosive_density] = 1150;
  blast[BlastField::hole_diameter] = 0.229;
  blast[BlastField::hole_stemming] = 3.8;
  blast[BlastField::hole_charge_length] = 9.7;
  CHECK(linear_charge(blast) == Approx(47.365).epsilon(1e-5));
  blast = ninh_dan();
  blast[BlastField::hole_stemming] = 2.3;
  blast[BlastField::hole_charge_length] = 5;
  const double fragment = mckenzie_fragment(scaled_depth_of_burial(blast), 0.102, 2600);
  CHECK(mckenzie_fragment(scaled_depth_of_burial(blast), 0.102, 2700) == Approx(fragment * 2600 / 2700));
  blast[BlastField::hole_charge_length] =
      1.02;  // ten diameters: more charge below throws no rock at the collar
  const double ten = scaled_depth_of_burial(blast);
  blast[BlastField::hole_charge_length] = 9;
  CHECK(scaled_depth_of_burial(blast) == ten);
}
