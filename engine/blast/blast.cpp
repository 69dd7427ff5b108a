#include "blast/blast.h"

#include <fmt/format.h>

#include <stdexcept>

#include "math/space.h"

namespace flyrock {

const std::vector<BlastFieldInfo>& blast_fields() {
  static const std::vector<BlastFieldInfo> fields{
      {BlastField::explosive_density, "explosive.density", "explosive_density", "kg/m3", dimension::density,
       "density of the explosive in the hole", usual::density},
      {BlastField::detonation_velocity, "explosive.detonation_velocity", "detonation_velocity", "m/s",
       dimension::speed, "velocity of detonation D", usual::detonation_velocity},
      {BlastField::gurney_constant, "explosive.gurney_constant", "gurney_constant", "m/s", dimension::speed,
       "Gurney constant sqrt(2E): 0.44 D for ANFO, D/3 for other explosives unless it is given"},
      {BlastField::hole_diameter, "hole.diameter", "hole_diameter", "m", dimension::length,
       "diameter of the hole and of its charge", usual::hole_diameter},
      {BlastField::hole_length, "hole.length", "hole_length", "m", dimension::length,
       "length of the hole: stemming and charge"},
      {BlastField::hole_stemming, "hole.stemming", "hole_stemming", "m", dimension::length,
       "length of the stemming above the charge", usual::burden},
      {BlastField::hole_charge_length, "hole.charge_length", "hole_charge_length", "m", dimension::length,
       "length of the charge"},
      {BlastField::hole_subdrilling, "hole.subdrilling", "hole_subdrilling", "m", dimension::length,
       "depth of the hole below the bench's floor"},
      {BlastField::hole_deviation, "hole.deviation", "hole_deviation", "", dimension::none,
       "deviation of the hole towards the face, in m per m of depth"},
      {BlastField::hole_dip, "hole.dip", "hole_dip", "rad", dimension::angle,
       "dip of the hole from the horizontal, 90 deg upright"},
      {BlastField::hole_azimuth, "hole.azimuth", "hole_azimuth", "rad", dimension::angle,
       "direction in plan to which the hole leans downwards, from +x to +y"},
      {BlastField::hole_charge, "hole.charge", "hole_charge", "kg", dimension::mass,
       "mass of the charge; with the length of the charge it gives the linear charge"},
      {BlastField::hole_linear_charge, "hole.linear_charge", "hole_linear_charge", "kg/m",
       Dimension{-1, 1, 0, 0},
       "charge per length of hole; with the diameter it gives the density of the explosive in the hole"},
      {BlastField::burden, "burden", "burden", "m", dimension::length,
       "least distance from the charge of a hole of the front row to the face", usual::burden},
      {BlastField::burden_crest, "burden_crest", "burden_crest", "m", dimension::length,
       "distance from the collar of a hole of the front row to the crest", usual::burden},
      {BlastField::burden_toe, "burden_toe", "burden_toe", "m", dimension::length,
       "distance from the planned foot of a hole of the front row to the toe", usual::burden},
      {BlastField::spacing, "spacing", "spacing", "m", dimension::length, "distance of the holes in a row"},
      {BlastField::rock_density, "rock_density", "rock_density", "kg/m3", dimension::density,
       "density of the rock mass", usual::density},
      {BlastField::breakout_angle, "breakout_angle", "breakout_angle", "rad", dimension::angle,
       "opening angle of the prism that a hole breaks out to the face"},
      {BlastField::powder_factor, "powder_factor", "powder_factor", "kg/m3", dimension::density,
       "explosive per volume of rock, from the blast plan"},
  };
  return fields;
}

double positive(const Blast& blast, BlastField field) {
  const double value = blast[field];
  const BlastFieldInfo& info = blast_fields()[static_cast<std::size_t>(field)];
  if (!(value > 0))
    throw std::invalid_argument(
        fmt::format("blast.{} is {:.6g} {}, must be above 0", info.path, value, info.unit));
  return value;
}

double linear_charge(const Blast& blast) {
  const double diameter = positive(blast, BlastField::hole_diameter);
  return pi / 4 * diameter * diameter * positive(blast, BlastField::explosive_density);
}

const std::vector<Explosive>& explosives() {
  constexpr double anfo_velocity = 4273, emulsion_velocity = 5200;
  static const std::vector<Explosive> known{
      {"ANFO", 850, anfo_velocity, 0.44 * anfo_velocity, true,
       "Roth 1979: sqrt(2E) = 0.44 D; 850 kg/m3 poured, our assumption"},
      {"emulsion", 1150, emulsion_velocity, emulsion_velocity / 3, false,
       "Roth 1979: sqrt(2E) = D/3; 1150 kg/m3 and D = 5200 m/s of a bulk emulsion, our assumption"},
  };
  return known;
}

}  // namespace flyrock
