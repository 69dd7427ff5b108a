#pragma once
// The rows of a table that belong to one rock.

#include <span>
#include <vector>

#include "record/records.h"

namespace flyrock {

/// The rows of a rock, from `row` on, which then is the first one of the next rock. Rows are sorted as the
/// rocks are.
template <class Row>
std::span<const Row> rows_of_rock(const std::vector<Row>& rows, std::size_t& row, const RockRecord& rock) {
  const std::size_t first = row;
  while (row < rows.size() && rows[row].trial == rock.trial && rows[row].rock == rock.rock) ++row;
  return {rows.data() + first, row - first};
}

/// Whether a rock that has not arrived at a gate or barrier may still do so. `decided`: a bit for each, of
/// RockRecord.
inline bool may_still_arrive(const RockRecord& rock, std::uint64_t decided, std::size_t place) {
  constexpr std::size_t bits = 64;
  return rock.censored && !(place < bits && (decided >> place & 1) != 0);
}

}  // namespace flyrock
