#pragma once
// The numbers of a rock of which there are statistics: the columns of `rocks` with the name of a statistic.

#include <array>
#include <cstddef>
#include <string_view>
#include <type_traits>

#include "record/tables.h"

namespace flyrock {

struct RockStatistic {
  Column column;  ///< column.statistic is its name in measures and summary.json
  double RockRecord::*real = nullptr;
  int RockRecord::*whole = nullptr;  ///< in place of `real`

  constexpr std::string_view name() const { return column.statistic; }
  double of(const RockRecord& rock) const { return real ? rock.*real : static_cast<double>(rock.*whole); }
};

inline constexpr std::size_t rock_statistic_count = [] {
  std::size_t count = 0;
  visit_rocks([&](const Column& column, auto) { count += column.statistic != nullptr; });
  return count;
}();

/// What the path of a rock decides comes first, then what was known at its start.
inline constexpr std::array<RockStatistic, rock_statistic_count> rock_statistics = [] {
  std::array<RockStatistic, rock_statistic_count> list{};
  std::size_t at = 0;
  for (const bool at_start : {false, true})
    visit_rocks([&](const Column& column, auto get) {
      if (!column.statistic || (column.known == KnownFrom::start) != at_start) return;
      list[at].column = column;
      if constexpr (std::is_same_v<decltype(get), double RockRecord::*>) list[at].real = get;
      if constexpr (std::is_same_v<decltype(get), int RockRecord::*>) list[at].whole = get;
      ++at;
    });
  return list;
}();

/// The place of a statistic in that list; the size of the list if there is none of that name.
constexpr std::size_t find_rock_statistic(std::string_view name) {
  std::size_t place = 0;
  while (place < rock_statistics.size() && rock_statistics[place].name() != name) ++place;
  return place;
}
/// The same for a name that is known when flyrock is compiled, which must be there.
consteval std::size_t rock_statistic(std::string_view name) {
  const std::size_t place = find_rock_statistic(name);
  if (place == rock_statistics.size()) throw "no statistic of rocks has this name";
  return place;
}

}  // namespace flyrock
