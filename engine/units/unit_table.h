#pragma once
// The units that a scenario may use.

#include <span>
#include <string_view>

#include "units/units.h"

namespace flyrock {

struct NamedUnit {
  std::string_view name;
  Unit unit;
};

/// All units, grouped by quantity. Sources of the factors: BIPM, The International System of Units (2019);
/// NIST SP 811 (2008), appendix B, for US units. "ton" alone is left out, because it can be short, long or
/// metric.
std::span<const NamedUnit> unit_table();

}  // namespace flyrock
