#pragma once
// The units that a scenario may write.

#include <span>
#include <string_view>

#include "units/units.h"

namespace flyrock {

struct NamedUnit {
  std::string_view name;
  Unit unit;
};

/// All of them, by field. Factors: BIPM, The International System of Units (2019); NIST SP 811 (2008),
/// appendix B, for US units. A bare "ton" is left out: it is short, long or metric.
std::span<const NamedUnit> unit_table();

}  // namespace flyrock
