#include "record/block_row.h"

#include <array>

namespace flyrock {

std::string_view name_of(BlockMode mode) {
  constexpr std::array<std::string_view, 5> names{"falls", "plane", "wedge", "held", "locked"};
  return names[static_cast<std::size_t>(mode)];
}

}  // namespace flyrock
