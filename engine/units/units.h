#pragma once
// Converts quantities in units of mechanics, mining and US practice, such as "2.7 g/cm3", to SI.

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "units/dimension.h"

namespace flyrock {

struct Unit {
  double factor = 1;  ///< SI value of one unit
  Dimension dimension;
};

/// Parses a unit expression: known units with exponents up to 9, `*`, blank or `.` between factors, one `/`:
/// "kg/m3", "m/s^2", "g/cm3", "ft-lb", "N/m^1.5", "N/m^(3/2)". Returns nullopt if a unit is unknown;
/// `unknown` then names it.
std::optional<Unit> parse_unit(std::string_view text, std::string* unknown = nullptr);

/// The names of all known units, for "did you mean".
std::vector<std::string> unit_names();

/// A number with an optional unit: "12 m", "-3.5e2 kPa", "5".
struct Quantity {
  double value = 0;  ///< in the unit as written
  bool has_unit = false;
  Unit unit;
  std::string unit_text;
  bool rounded = false;  ///< see rounds_to_whole
  /// The value in SI units. If the factor is one over a whole number (mm, ms), the value is divided by this
  /// number, because 102 / 1000 is the double nearest to 0.102 and 102 * 1e-3 is not.
  double si() const {
    const double inverse = 1 / unit.factor;
    return inverse == std::floor(inverse) ? value / inverse : value * unit.factor;
  }
};

/// Why a text is not a quantity. `unit_text` is set if the number was valid but the unit was not.
struct QuantityError {
  std::string unit_text;
  std::string nearest;  ///< the nearest known unit, or empty
};

/// A strict decimal number: no leading zeros ("010"), no hexadecimal, no NaN or infinity.
std::optional<double> parse_number(std::string_view text);

/// The greatest whole number up to which a double holds every whole number: 2^53.
inline constexpr double greatest_whole = 9007199254740992.0;

/// Whether a decimal number is read as a whole number that it is not, because a double has not so many
/// digits: "9007199254740993", "2.00000000000000001".
bool rounds_to_whole(std::string_view text);

/// Parses a text. If it is not a number with an optional unit, returns nullopt and fills `error`.
std::optional<Quantity> parse_quantity(std::string_view text, QuantityError* error = nullptr);

/// A text in small letters, from A to Z.
std::string lower(std::string_view text);

/// The candidate nearest to `word` by edit distance, or an empty text if none is near.
std::string nearest_name(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace flyrock
