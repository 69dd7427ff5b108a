#include "survey/written_digits.h"

#include <catch2/catch.hpp>
#include <sstream>

namespace written_digits_test {

flyrock::WrittenDigits digits_of(const std::string& x_of_places) {
  flyrock::WrittenDigits digits;
  std::istringstream words(x_of_places);
  for (std::string word; words >> word;) digits.add(0, word);
  return digits;
}

}  // namespace written_digits_test
using namespace written_digits_test;

TEST_CASE("numbers of six digits are no coordinates of a survey where they are a metre or more apart") {
  CHECK(digits_of("2.6e+06 2.60001e+06 2.60002e+06").fault() ==
        "its coordinates have too few digits: near `2.60001e+06` they are 10 apart; export them with three "
        "decimals, PLY with doubles, or local coordinates");
  CHECK(digits_of("2.600000e+06 2.600008e+06").fault().find("are 1 apart") != std::string::npos);
}

TEST_CASE("numbers that are centimetres or decimetres apart are a note, and finer ones nothing") {
  const flyrock::WrittenDigits coarse = digits_of("6.912000e+05 6.912001e+05 1.000000e+00");
  CHECK(coarse.fault() == "");
  CHECK(coarse.note().find("near `6.912000e+05` they are 0.1 apart") != std::string::npos);
  for (const char* fine : {"2600000 2600008.125", "2.600008125e+06", "2.400000e+02 8.000000e+00", "1e3 2e3",
                           "1e-20 5e-07", "NaN e", "1e5 2.5e4"}) {
    INFO(fine);
    CHECK(digits_of(fine).note() == "");
  }
}
