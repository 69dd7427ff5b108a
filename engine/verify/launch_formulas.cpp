// The launch formulas of blasts against worked numbers: the blast of Ninh Dan, a workbook of Richards and
// Moore's model, and hand calculations.

#include <cmath>

#include "blast/bench_fit.h"
#include "blast/blast.h"
#include "blast/gurney.h"
#include "blast/mckenzie.h"
#include "blast/richards_moore.h"
#include "math/space.h"
#include "verify/check.h"

namespace flyrock {

namespace {

constexpr double g = 9.81;

/// Holes of 102 mm with ANFO in limestone: the common case of Ninh Dan.
Blast ninh_dan(double burden) {
  Blast blast;
  const Explosive& anfo = explosives().front();
  blast[BlastField::explosive_density] = anfo.density;
  blast[BlastField::gurney_constant] = anfo.gurney_constant;
  blast[BlastField::hole_diameter] = 0.102;
  blast[BlastField::burden] = burden;
  blast[BlastField::rock_density] = 2700;
  blast[BlastField::breakout_angle] = pi / 2;
  return blast;
}

/// Holes of 229 mm of the workbook.
Blast workbook() {
  Blast blast;
  blast[BlastField::explosive_density] = 1150;
  blast[BlastField::hole_diameter] = 0.229;
  blast[BlastField::burden] = 4.5;
  blast[BlastField::hole_stemming] = 3.8;
  blast[BlastField::hole_charge_length] = 9.7;
  return blast;
}

/// Adds the number with the greatest relative error.
void add_formula(Checks& checks, const std::string& name, std::vector<Compared> numbers) {
  for (Compared& number : numbers) number = {number.name, number.computed / number.expected, 1};
  add_worst(checks, name + ", computed / expected", "formula", 1e-3, numbers);
}

}  // namespace

void check_launch_formulas(Checks& checks) {
  const auto roth = [](double burden) {
    const Blast blast = ninh_dan(burden);
    return blast[BlastField::gurney_constant] * gurney_factor(GurneyGeometry::roth, charge_to_mass(blast));
  };
  add_formula(checks, "Roth, Ninh Dan",
              {{"speed, burden 2.7 m", roth(2.7), 35.32},
               {"range, burden 2.7 m", roth(2.7) * roth(2.7) / g, 127.1},
               {"speed, burden 2.5 m", roth(2.5), 38.14},
               {"range, burden 2.5 m", roth(2.5) * roth(2.5) / g, 148.3}});

  const double ratio = charge_to_mass(ninh_dan(2.7));
  const BenchFit limestone = bench_fit(BenchRock::limestone, true);
  const double printed = squared_speed(limestone, BenchFitForm::as_printed, ratio);
  add_formula(checks, "fit of bench blasts, limestone",
              {{"speed, linear", std::sqrt(squared_speed(limestone, BenchFitForm::linear, ratio)), 29.3},
               {"speed, as printed", std::sqrt(printed), 237.0},
               {"range, as printed", printed / g, 5724}});

  const auto reach = [](RichardsMooreMode mode, double elevation) {
    const double v = richards_moore_speed(mode, 28, workbook());
    return v * v / g * std::sin(2 * elevation);
  };
  add_formula(
      checks, "Richards and Moore, workbook",
      {{"face burst", reach(RichardsMooreMode::face_burst, pi / 4), 241.21},
       {"cratering", reach(RichardsMooreMode::cratering, pi / 4), 374.37},
       {"stemming ejection at 80 deg", reach(RichardsMooreMode::stemming_ejection, 80 * pi / 180), 128.04}});

  const double depth = scaled_depth_of_burial(workbook());
  Blast small = ninh_dan(2.7);
  small[BlastField::hole_stemming] = 2.3;
  small[BlastField::hole_charge_length] = 5;
  const double small_depth = scaled_depth_of_burial(small);
  add_formula(checks, "McKenzie",
              {{"scaled depth, 229 mm", depth, 1.0369},
               {"range, 229 mm", mckenzie_range(depth, 0.229), 337.0},
               {"scaled depth, Ninh Dan", small_depth, 1.463},
               {"range, Ninh Dan", mckenzie_range(small_depth, 0.102), 93.2},
               {"fragment, Ninh Dan", mckenzie_fragment(small_depth, 0.102, 2600), 0.0287}});
}

}  // namespace flyrock
