#pragma once
// A number of a scenario that is varied: its path, and its least and greatest value.

#include <optional>
#include <string>

#include "results/compare/calibration.h"

namespace flyrock {

struct VariedNumber {
  std::string path;
  double low = 0, high = 0;  ///< in `unit`
  std::string unit;          ///< as written; empty: none
  double si_factor = 1;      ///< SI value of one unit
  std::string si;            ///< the SI unit: "m", "rad", "1"

  /// The value at a share of the way from low to high, as a scenario writes it: "12.5 deg".
  std::string text_at(double share) const;
  double si_at(double share) const;
};

/// Reads "PATH=LOW:HIGH", as in materials.ground.friction.mu=0.3:0.7 or x.sd=2 deg:20 deg. Otherwise `fault`
/// says what is wrong.
std::optional<VariedNumber> read_varied(const std::string& text, std::string& fault);

}  // namespace flyrock
