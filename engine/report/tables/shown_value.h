#pragma once
// What tables show for the values of records.

#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "math/space.h"
#include "record/tables.h"
#include "scenario/scenario.h"

namespace flyrock {

/// The names that whole numbers of records count, for one sweep point.
struct RecordNames {
  explicit RecordNames(const Scenario& scenario)
      : groups(group_names(scenario)), branches(branch_names(scenario)) {
    for (const auto& gate : scenario.gates) gates.push_back(gate.name);
    for (const auto& barrier : scenario.barriers) barriers.push_back(barrier.name);
    if (scenario.blast)
      for (const Hole& hole : scenario.blast->pattern.measured) holes.push_back(hole.name);
  }
  const std::vector<std::string>& of(NamesOf list) const {
    switch (list) {
      case NamesOf::gates:
        return gates;
      case NamesOf::barriers:
        return barriers;
      case NamesOf::holes:
        return holes;
      case NamesOf::branches:
        return branches;
      default:
        return groups;
    }
  }

  std::vector<std::string> groups, gates, barriers, holes, branches;
  std::vector<int> inputs;  ///< their numbers in `input_paths`
};

/// Which columns the tables of a scenario show.
inline TableContent content_of(const Scenario& scenario) {
  return {.dimension = scenario.dimension,
          .holes = scenario.blast && scenario.blast->has_holes(),
          .branches = !scenario.branches.empty()};
}

/// Calls `use` with what a table shows for `value`: a number, a text, or a name.
template <class T>
auto shown_value(const Column& column, const T& value, const RecordNames& names, auto&& use) {
  if constexpr (std::is_same_v<T, TravelMode>)
    return use(std::string_view(travel_mode_names[static_cast<std::size_t>(value)]));
  else if constexpr (std::is_enum_v<T>)
    return use(std::string_view(name_of(value)));
  else if constexpr (std::is_same_v<T, std::string>)
    return use(std::string_view(value));
  else if constexpr (std::is_same_v<T, double>)
    return use(column.in_degrees ? value * 180 / pi : value);
  else if (column.names == NamesOf::inputs)
    return use(names.inputs.at(static_cast<std::size_t>(value)));
  else if (column.names != NamesOf::nothing)
    return use(std::string_view(names.of(column.names).at(static_cast<std::size_t>(value))));
  else
    return use(value);
}

/// The SQL type of such a value.
template <class T>
constexpr const char* sql_type(const Column& column) {
  if constexpr (std::is_same_v<T, double>) return "REAL";
  const bool is_named = column.names != NamesOf::nothing && column.names != NamesOf::inputs;
  const bool is_text = is_named || std::is_enum_v<T> || std::is_same_v<T, std::string>;
  return is_text ? "TEXT" : "INTEGER";
}

}  // namespace flyrock
