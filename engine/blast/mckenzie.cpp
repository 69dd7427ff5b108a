#include "blast/mckenzie.h"

#include <algorithm>
#include <cmath>

namespace flyrock {

namespace {

/// SDoB^-2.167 d^(2/3), with d in mm: the factor common to range and fragment size.
double scaled(double depth, double hole_diameter) {
  return std::pow(depth, -2.167) * std::pow(1000 * hole_diameter, 2.0 / 3);
}

}  // namespace

double scaled_depth_of_burial(const Blast& blast) {
  const double diameter = positive(blast, BlastField::hole_diameter);
  const double diameters = diameter >= 0.1 ? 10 : 8;
  const double length = std::min(positive(blast, BlastField::hole_charge_length), diameters * diameter);
  const double depth = positive(blast, BlastField::hole_stemming) + length / 2;
  return depth / std::cbrt(length * linear_charge(blast));
}

double mckenzie_range(double depth, double hole_diameter) { return 9.74 * scaled(depth, hole_diameter); }

double mckenzie_fragment(double depth, double hole_diameter, double rock_density) {
  return 0.003 * (2600 / rock_density) * scaled(depth, hole_diameter);
}

}  // namespace flyrock
