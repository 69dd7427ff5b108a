#pragma once
// Numbers that are not known.

#include <array>
#include <limits>

namespace flyrock {

/// A number that is unknown because a run has too few rocks, or none.
inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// What a point may tell of its rocks: all, or only how many there are of each kind, because too many failed
/// (results/measured/lost.h). All other numbers of its results are then unknown.
enum class Told { all, counts };

/// N times the same value.
template <std::size_t N, class T>
constexpr std::array<T, N> each(const T& value) {
  std::array<T, N> values{};
  values.fill(value);
  return values;
}

}  // namespace flyrock
