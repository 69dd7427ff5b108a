#pragma once
// Numbers of a blast by which engineers compare blasts. They are made of numbers that the scenario gives, so
// they are no further causes of what happens.
//
//   powder_factor          q / (B S H)           kg/m3; B of rows behind the first: the distance of rows
//   powder_factor_by_mass  1000 q / (B S H rho)  kg/t
//   charge_ratio           c/m = q_l / (rho B^2 tan(beta/2))  of the breakout prism (blast/gurney.h)
//   charge                 q                     kg
//   scaled_burden          B / sqrt(q_l)         m/(kg/m)^0.5
//   scaled_depth           as scaled_depth_of_burial()  m/kg^(1/3) (McKenzie)
//   burden_to_diameter     B / d
//   stemming_to_burden     T / B
//   delay_per_burden       dt / B                ms/m, dt: after the hole that went off before it in its row
//
// q: charge of the hole, q_l: charge per length, B: burden, S: spacing, H: length less subdrilling, T:
// stemming, d: diameter of the hole, rho: density of the rock, beta: breakout angle.

#include <array>
#include <string_view>
#include <vector>

#include "blast/design.h"

namespace flyrock {

enum class Derived {
  powder_factor,
  powder_factor_by_mass,
  charge_ratio,
  charge,
  scaled_burden,
  scaled_depth,
  burden_to_diameter,
  stemming_to_burden,
  delay_per_burden,
  count
};
inline constexpr std::size_t derived_count = static_cast<std::size_t>(Derived::count);

struct DerivedInfo {
  std::string_view name;          ///< "powder_factor"
  const char* unit;               ///< as above; "1" without
  std::vector<BlastField> reads;  ///< of the completed blast
  bool reads_times = false;       ///< and the times of the holes
};
const std::array<DerivedInfo, derived_count>& derived_infos();

/// One of each; NaN where the blast does not give what it needs.
using DerivedNumbers = std::array<double, derived_count>;

/// The numbers of one hole, from 0, of a completed blast. `delay`: s, see delay_in_row().
DerivedNumbers derived_numbers(const Blast& blast, const Pattern& pattern, int hole, double delay);

/// The numbers of a whole blast: means over its holes, weighted by the rock of each; the charge and the delay
/// are plain means. The powder factor is then all explosive over all rock. `rock`: m3, of each hole; NaN
/// where a volume is not known, and then all means are plain.
DerivedNumbers derived_of_blast(const std::vector<DerivedNumbers>& holes, const std::vector<double>& rock);

/// The time of each hole since the hole that went off before it in its row [s]; NaN for the first of a row.
std::vector<double> delays_in_rows(const Pattern& pattern, const std::vector<double>& times);

}  // namespace flyrock
