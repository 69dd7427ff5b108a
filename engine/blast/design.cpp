#include "blast/design.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "blast/gurney.h"
#include "blast/mckenzie.h"
#include "math/space.h"

namespace flyrock {

namespace {

using enum BlastField;

bool given(const Blast& blast, BlastField field) { return !std::isnan(blast[field]); }

double or_zero(const Blast& blast, BlastField field) { return given(blast, field) ? blast[field] : 0; }

void complete_hole(Blast& blast) {
  const bool length = given(blast, hole_length), stemming = given(blast, hole_stemming),
             charge = given(blast, hole_charge_length);
  if (length + stemming + charge != 2) return;
  if (!length) blast[hole_length] = blast[hole_stemming] + blast[hole_charge_length];
  if (!stemming) blast[hole_stemming] = blast[hole_length] - blast[hole_charge_length];
  if (!charge) blast[hole_charge_length] = blast[hole_length] - blast[hole_stemming];
  if (blast[hole_stemming] < 0 || !(blast[hole_charge_length] > 0))
    throw std::invalid_argument(
        fmt::format("blast.hole: a length of {:.6g} m leaves {:.6g} m of stemming and {:.6g} m of charge",
                    blast[hole_length], blast[hole_stemming], blast[hole_charge_length]));
}

void complete_burden(Blast& blast) {
  if (given(blast, burden) || !given(blast, burden_crest) || !given(blast, burden_toe) ||
      !given(blast, hole_length))
    return;
  const double floor = blast[hole_length] - or_zero(blast, hole_subdrilling);
  if (!(floor > 0))
    throw std::invalid_argument(fmt::format(
        "blast.hole: with a length of {:.6g} m it ends above the floor of the bench", blast[hole_length]));
  const auto at = [&](double depth) {
    const double drilled = blast[burden_crest] + (blast[burden_toe] - blast[burden_crest]) * depth / floor;
    return drilled - or_zero(blast, hole_deviation) * depth;
  };
  blast[burden] = std::min(at(std::min(blast[hole_stemming], floor)), at(floor));
  if (!(blast[burden] > 0))
    throw std::invalid_argument(
        fmt::format("blast.hole.deviation: the hole deviates by {:.6g} m at the floor and leaves the rock",
                    blast[hole_deviation] * floor));
}

}  // namespace

void complete(Blast& blast) {
  complete_hole(blast);
  complete_burden(blast);
}

BlastDesign design_of(const Blast& blast, const Pattern& pattern) {
  BlastDesign design;
  const double diameter = blast[hole_diameter];
  design.linear_charge = pi / 4 * diameter * diameter * blast[explosive_density];
  design.charge_per_hole = design.linear_charge * blast[hole_charge_length];
  design.explosive = pattern.holes() * design.charge_per_hole;
  const double height = blast[hole_length] - or_zero(blast, hole_subdrilling);
  const double behind = pattern.row_distance > 0 ? pattern.row_distance : blast[burden];
  design.rock =
      pattern.holes_per_row * blast[spacing] * height * (blast[burden] + (pattern.rows - 1) * behind);
  design.powder_factor = design.explosive / design.rock;
  const double tangent = std::tan(blast[breakout_angle] / 2);
  const double share = design.linear_charge / (blast[burden] * blast[burden] * tangent);  // rho c/m
  design.powder_factor_shallow = 0.5 * share;
  design.powder_factor_deep = 0.8 * share;
  design.last_time = pattern.time(pattern.holes() - 1);
  design.depth_of_burial = design.fragment = std::numeric_limits<double>::quiet_NaN();
  if (blast[hole_stemming] > 0 && design.charge_per_hole > 0) {
    design.depth_of_burial = scaled_depth_of_burial(blast);
    design.fragment = mckenzie_fragment(design.depth_of_burial, diameter, blast[rock_density]);
  }
  return design;
}

std::string disagreement(const Blast& blast, const BlastDesign& design) {
  constexpr double fifth = 1.2;
  const double q = design.powder_factor, stated = blast[powder_factor];
  if (stated > fifth * q || stated < q / fifth)
    return fmt::format(
        "the powder factor is given as {:.3g} kg/m3; charge, burden, spacing and bench height make it {:.3g}",
        stated, q);
  if (q > fifth * design.powder_factor_deep || q < design.powder_factor_shallow / fifth)
    return fmt::format(
        "the pattern has {:.3g} kg/m3; the prism that a hole breaks out makes it {:.3g} (shallow) to {:.3g} "
        "(deep)",
        q, design.powder_factor_shallow, design.powder_factor_deep);
  return {};
}

}  // namespace flyrock
