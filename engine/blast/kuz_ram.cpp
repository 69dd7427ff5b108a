#include "blast/kuz_ram.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace flyrock {

namespace {

double bench_height(const Blast& blast) {
  const double height = positive(blast, BlastField::hole_length) - blast[BlastField::hole_subdrilling];
  if (!(height > 0))
    throw std::invalid_argument("the hole is all subdrilling, or `blast.hole.subdrilling` is missing");
  return height;
}

}  // namespace

double volume_of_hole(const Blast& blast) {
  return positive(blast, BlastField::burden) * positive(blast, BlastField::spacing) * bench_height(blast);
}

FragmentSizes kuz_ram(const Blast& blast, const KuzRam& rock) {
  const double burden = positive(blast, BlastField::burden), spacing = positive(blast, BlastField::spacing);
  const double diameter = 1000 * positive(blast, BlastField::hole_diameter);  // mm
  const double length = positive(blast, BlastField::hole_charge_length);
  const double charge = linear_charge(blast) * length;
  const double above_floor = length - blast[BlastField::hole_subdrilling];
  FragmentSizes sizes;
  sizes.median = 0.01 * rock.rock_factor * std::pow(volume_of_hole(blast) / charge, 0.8) *
                 std::pow(charge, 1.0 / 6) * std::pow(1.15 / rock.strength, 19.0 / 30);
  sizes.uniformity = (2.2 - 14 * burden / diameter) * std::sqrt((1 + spacing / burden) / 2) *
                     (1 - rock.deviation / burden) * std::pow(1.1, 0.1) * above_floor / bench_height(blast);
  if (!(sizes.uniformity > 0))
    throw std::invalid_argument(
        fmt::format("the uniformity of Kuz-Ram is {:.3g}, must be above 0: the burden is {:.3g} m, the hole "
                    "{:.3g} mm, the charge above the floor {:.3g} m",
                    sizes.uniformity, burden, diameter, above_floor));
  return sizes;
}

}  // namespace flyrock
