#pragma once
// Physical dimensions, and the units in which they are shown.

#include <string>

namespace flyrock {

/// Exponents of m, kg, s and rad, rounded to a millionth so that equal ones compare equal. An angle has its
/// own dimension here, so that degrees are not mistaken for radians.
struct Dimension {
  double metre = 0;
  double kilogram = 0;
  double second = 0;
  double radian = 0;

  bool operator==(const Dimension&) const = default;
};

namespace dimension {
inline constexpr Dimension none{};
inline constexpr Dimension length{1, 0, 0, 0};
inline constexpr Dimension mass{0, 1, 0, 0};
inline constexpr Dimension time{0, 0, 1, 0};
inline constexpr Dimension angle{0, 0, 0, 1};
inline constexpr Dimension speed{1, 0, -1, 0};
inline constexpr Dimension acceleration{1, 0, -2, 0};
inline constexpr Dimension spin{0, 0, -1, 1};
inline constexpr Dimension density{-3, 1, 0, 0};
inline constexpr Dimension energy{2, 1, -2, 0};
}  // namespace dimension

/// The SI unit of a dimension, for messages: "m/s", "kg m2/s2", "rad/s", or "1" for no dimension.
std::string si_unit(const Dimension& dimension);

/// The unit in which values of an SI unit are shown to people: deg for rad, kJ for kg m2/s2, N for kg m/s2,
/// "" for "1", otherwise the SI unit itself.
struct ReadableUnit {
  std::string name;
  double per_si = 1;  ///< units in one SI unit
};
ReadableUnit readable_unit(const std::string& si);

}  // namespace flyrock
