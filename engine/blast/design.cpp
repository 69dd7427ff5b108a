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

double or_zero(const Blast& blast, BlastField field) { return std::isnan(blast[field]) ? 0 : blast[field]; }

void complete_hole(BlastWriter& blast) {
  const bool length = blast.has(hole_length), stemming = blast.has(hole_stemming),
             charge = blast.has(hole_charge_length);
  if (length + stemming + charge != 2) return;
  if (!length) blast.put(hole_length, blast.read(hole_stemming) + blast.read(hole_charge_length));
  if (!stemming) blast.put(hole_stemming, blast.read(hole_length) - blast.read(hole_charge_length));
  if (!charge) blast.put(hole_charge_length, blast.read(hole_length) - blast.read(hole_stemming));
  if (blast[hole_stemming] < 0 || !(blast[hole_charge_length] > 0))
    throw std::invalid_argument(
        fmt::format("blast.hole: a length of {:.6g} m leaves {:.6g} m of stemming and {:.6g} m of charge",
                    blast[hole_length], blast[hole_stemming], blast[hole_charge_length]));
}

void complete_burden(BlastWriter& blast) {
  if (blast.has(burden) || !blast.has(burden_crest) || !blast.has(burden_toe) || !blast.has(hole_length))
    return;
  const double floor = blast.read(hole_length) - blast.read_or_zero(hole_subdrilling);
  if (!(floor > 0))
    throw std::invalid_argument(fmt::format(
        "blast.hole: with a length of {:.6g} m it ends above the floor of the bench", blast[hole_length]));
  const double crest = blast.read(burden_crest), toe = blast.read(burden_toe);
  const double deviation = blast.read_or_zero(hole_deviation);
  const auto at = [&](double depth) { return crest + (toe - crest) * depth / floor - deviation * depth; };
  const double least = std::min(at(std::min(blast.read(hole_stemming), floor)), at(floor));
  if (!(least > 0))
    throw std::invalid_argument(
        fmt::format("blast.hole.deviation: the hole deviates by {:.6g} m at the floor and leaves the rock",
                    deviation * floor));
  blast.put(burden, least);
}

/// The charge per length that a table or a plan gives takes the place of the one that fills the hole: models
/// that read diameter and density of the explosive then see it without a change. Without a diameter the hole
/// is the one that this explosive fills.
void complete_charge(BlastWriter& blast) {
  if (!blast.has(hole_linear_charge) && blast.has(hole_charge) && blast.has(hole_charge_length))
    blast.put(hole_linear_charge, blast.read(hole_charge) / blast.read(hole_charge_length));
  if (blast.has(hole_linear_charge)) {
    if (blast.has(hole_diameter)) {
      const double linear = blast.read(hole_linear_charge), diameter = blast.read(hole_diameter);
      blast.put(explosive_density, linear / (pi / 4 * diameter * diameter));
    } else if (blast.has(explosive_density)) {
      const double linear = blast.read(hole_linear_charge), density = blast.read(explosive_density);
      blast.put(hole_diameter, std::sqrt(linear / (pi / 4 * density)));
    }
  } else {
    const double diameter = blast.read(hole_diameter), density = blast.read(explosive_density);
    blast.put(hole_linear_charge, pi / 4 * diameter * diameter * density);
  }
  if (!blast.has(hole_charge))
    blast.put(hole_charge, blast.read(hole_linear_charge) * blast.read(hole_charge_length));
}

}  // namespace

void complete(Blast& blast, BlastSources* sources) {
  BlastWriter writer(blast, sources);
  complete_hole(writer);
  complete_charge(writer);
  complete_burden(writer);
}

BlastDesign design_of(const Blast& blast, const Pattern& pattern) {
  BlastDesign design;
  const double diameter = blast[hole_diameter];
  design.linear_charge = blast[hole_linear_charge];
  design.charge_per_hole = blast[hole_charge];
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
  design.charge_to_mass = share / blast[rock_density];
  design.last_time = pattern.time(pattern.holes() - 1);
  design.depth_of_burial = design.fragment = std::numeric_limits<double>::quiet_NaN();
  if (blast[hole_stemming] > 0 && design.charge_per_hole > 0) {
    design.depth_of_burial = scaled_depth_of_burial(blast);
    design.fragment = mckenzie_fragment(design.depth_of_burial, diameter, blast[rock_density]);
  }
  return design;
}

BlastDesign design_of_holes(const std::vector<BlastDesign>& holes, const Pattern& pattern) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  BlastDesign sum;
  sum.linear_charge = sum.depth_of_burial = sum.fragment = sum.charge_to_mass = none;
  double shallow = 0;
  for (const BlastDesign& hole : holes) {
    sum.explosive += hole.explosive;
    sum.rock += hole.rock;
    shallow += hole.powder_factor_shallow * hole.rock;
  }
  const auto n = static_cast<double>(holes.size());
  sum.charge_per_hole = sum.explosive / n;
  sum.powder_factor = sum.explosive / sum.rock;
  sum.powder_factor_shallow = shallow / sum.rock;
  sum.powder_factor_deep = sum.powder_factor_shallow * 0.8 / 0.5;
  for (int hole = 0; hole < pattern.holes(); ++hole)
    sum.last_time = std::max(sum.last_time, pattern.time(hole));
  return sum;
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
