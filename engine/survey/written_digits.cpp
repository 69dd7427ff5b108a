#include "survey/written_digits.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace flyrock {

void WrittenDigits::add_power(int axis, std::string_view number) {
  const std::size_t mark = number.find_first_of("eE"), point = number.find('.');
  std::string_view power = number.substr(mark + 1);
  if (power.starts_with('+')) power.remove_prefix(1);
  int exponent = 0;
  if (std::from_chars(power.data(), power.data() + power.size(), exponent).ec != std::errc()) return;
  constexpr int of_whole_digits = 4;  // six digits hold smaller numbers to 1 mm, and 2e3 is no loss
  if (exponent < of_whole_digits) return;
  const int decimals = point < mark ? static_cast<int>(mark - point) - 1 : 0;
  Axis& own = axes_[static_cast<std::size_t>(axis)];
  const int last = exponent - decimals;
  if (exponent > own.exponent || (exponent == own.exponent && last < own.finest))
    own = {exponent, last, std::string(number)};
}

/// The axis whose numbers are farthest apart; null: no number was cut by a program.
const WrittenDigits::Axis* WrittenDigits::coarsest() const {
  constexpr int of_programs = 4;  // decimals at least; 1e5 and 2.5e4 are round numbers of people
  const Axis* found = nullptr;
  for (const Axis& axis : axes_)
    if (axis.exponent - axis.finest >= of_programs && (!found || axis.finest > found->finest)) found = &axis;
  return found;
}

std::string WrittenDigits::text() const {
  return fmt::format(
      "its coordinates have too few digits: near `{}` they are {:g} apart; export them with three decimals, "
      "PLY with doubles, or local coordinates",
      coarsest()->example, std::pow(10.0, coarsest()->finest));
}

std::string WrittenDigits::fault() const {
  return coarsest() && coarsest()->finest >= 0 ? text() : std::string();
}

std::string WrittenDigits::note() const {
  constexpr int of_surveys = -2;  // a survey is not coarser than 1 cm
  return coarsest() && coarsest()->finest >= of_surveys ? text() : std::string();
}

}  // namespace flyrock
