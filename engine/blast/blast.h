#pragma once
// The data of a blast that a velocity model reads.

#include <array>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "units/dimension.h"
#include "units/usual.h"

namespace flyrock {

/// Every field of a blast. The order is that of `blast_fields()`.
enum class BlastField {
  explosive_density,
  detonation_velocity,
  gurney_constant,  ///< sqrt(2E) of the Gurney model; 0.44 D for ANFO, D/3 for other explosives
  hole_diameter,
  hole_length,
  hole_stemming,
  hole_charge_length,
  hole_subdrilling,
  hole_deviation,
  hole_dip,
  hole_azimuth,
  hole_charge,         ///< kg
  hole_linear_charge,  ///< kg/m
  burden,              ///< the smallest burden along the charge
  burden_crest,
  burden_toe,
  spacing,
  rock_density,
  breakout_angle,
  powder_factor,
  count
};

/// The names of a field in a scenario and in a plugin (`reads = { "blast.burden" }`).
struct BlastFieldInfo {
  BlastField field;
  std::string_view path;  ///< below `blast`: "hole.diameter"
  std::string_view name;  ///< in Lua: blast.hole_diameter
  std::string_view unit;
  Dimension dimension;
  std::string_view doc;
  std::optional<UsualRange> usual = std::nullopt;
};
const std::vector<BlastFieldInfo>& blast_fields();

/// The blast of one hole, in SI units. A field that the scenario does not give is NaN. The decoder has
/// checked that no plugin in use reads such a field.
struct Blast {
  std::array<double, static_cast<int>(BlastField::count)> values;
  bool is_anfo = false;

  Blast() { values.fill(std::numeric_limits<double>::quiet_NaN()); }
  double operator[](BlastField field) const { return values[static_cast<int>(field)]; }
  double& operator[](BlastField field) { return values[static_cast<int>(field)]; }
};

/// The value of a field that a formula needs to be above 0. Otherwise throws std::invalid_argument,
/// "blast.burden is -1 m, must be above 0", also if the field is not given (NaN).
double positive(const Blast& blast, BlastField field);

/// g [m/s2] for the published distances. They were measured on the Earth, so the gravity of the scenario does
/// not apply.
inline constexpr double range_gravity = 9.81;

/// The mass of charge per length of hole [kg/m]: W/l = pi/4 d^2 rho_e. Throws std::invalid_argument.
double linear_charge(const Blast& blast);

/// Explosives known by name: `explosive: ANFO`.
struct Explosive {
  std::string_view name;
  double density;              // kg/m3
  double detonation_velocity;  // m/s
  double gurney_constant;      // m/s
  bool is_anfo;
  std::string_view source;
};
const std::vector<Explosive>& explosives();

}  // namespace flyrock
