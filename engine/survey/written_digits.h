#pragma once
// How many digits the coordinates of a text have.

#include <array>
#include <string>
#include <string_view>

namespace flyrock {

/// Some programs write numbers with a fixed count of digits: 2600008.125 becomes 2.60001e+06, so that the
/// ground near it is a staircase of 10 m. At the greatest exponent of an axis, the finest number tells how
/// far apart its numbers are. Numbers without an exponent have all their digits.
class WrittenDigits {
 public:
  void add(int axis, std::string_view number) {
    if (number.find_first_of("eE") != number.npos) add_power(axis, number);
  }

  /// Why the coordinates are no ground; empty: they may be one.
  std::string fault() const;
  /// A warning; empty: none.
  std::string note() const;

 private:
  struct Axis {
    int exponent = 0;     ///< the greatest
    int finest = 0;       ///< power of ten of the last digit
    std::string example;  ///< a number with it
  };

  void add_power(int axis, std::string_view number);
  const Axis* coarsest() const;
  std::string text() const;

  std::array<Axis, 3> axes_;
};

}  // namespace flyrock
