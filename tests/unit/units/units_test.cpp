#include "units/units.h"

#include <catch2/catch.hpp>
#include <cmath>

using namespace flyrock;

namespace {
double si(std::string_view text) {
  const auto quantity = parse_quantity(text);
  INFO(text);
  REQUIRE(quantity);
  return quantity->si();
}
Dimension dimension_of(std::string_view text) {
  const auto unit = parse_unit(text);
  INFO(text);
  REQUIRE(unit);
  return unit->dimension;
}
}  // namespace

TEST_CASE("numbers are shown in the units that people read") {
  CHECK(readable_unit("rad").name == "deg");
  CHECK(readable_unit("rad").per_si == Approx(57.29577951));
  CHECK(readable_unit(si_unit(dimension::energy)).name == "kJ");
  CHECK(readable_unit(si_unit(dimension::none)).name.empty());
  CHECK(readable_unit("m/s").name == "m/s");
  CHECK(readable_unit("m/s").per_si == 1);
}

TEST_CASE("quantities of mechanics, mining and US practice are converted to SI") {
  CHECK(si("12 m") == 12);
  CHECK(si("12m") == 12);
  CHECK(si("5") == 5);
  CHECK(si("-3.5e2 kPa") == Approx(-350e3));
  CHECK(si("2.7 g/cm3") == Approx(2700));
  CHECK(si("1 lb") == Approx(0.45359237));
  CHECK(si("102 mm") == 0.102);
  CHECK(si("42 ms") == 0.042);
  CHECK(si("2.7 g/cm3") == 2700);
  CHECK(si("30 mph") == Approx(13.4112));
  CHECK(si("90 km/h") == Approx(25));
  CHECK(si("1 psi") == Approx(6894.757293168361));
  CHECK(si("1 ft-lb") == Approx(1.3558179483314004));
  CHECK(si("1 lbf ft") == Approx(1.3558179483314004));
  CHECK(si("60 rpm") == Approx(2 * 3.14159265358979));
  CHECK(si("180 deg") == Approx(3.14159265358979));
  CHECK(si("180°") == Approx(3.14159265358979));
  CHECK(si("1 gal") == Approx(3.785411784e-3));
  CHECK(si("9.81 m/s²") == 9.81);
  CHECK(si("9.81 m s^-2") == 9.81);
  CHECK(si("1 ton_short") == Approx(907.18474));
  CHECK(si("500 kJ") == Approx(5e5));
  CHECK(si("45 %") == Approx(0.45));
}

TEST_CASE("dimensions of unit expressions") {
  CHECK(dimension_of("m/s") == dimension::speed);
  CHECK(dimension_of("kg m2/s2") == dimension::energy);
  CHECK(dimension_of("N.m") == dimension::energy);
  CHECK(dimension_of("kg*m^2/s^2") == dimension_of("J"));
  CHECK(dimension_of("rpm") == dimension::spin);
  CHECK(dimension_of("1/s") == Dimension{0, 0, -1, 0});
  CHECK(dimension_of("km") == dimension::length);
  CHECK(si_unit(dimension::speed) == "m/s");
  CHECK(si_unit(dimension::energy) == "kg m2/s2");
  CHECK(si_unit(dimension::spin) == "rad/s");
  CHECK(si_unit(dimension::none) == "1");
  CHECK(si_unit({0, 0, -1, 0}) == "1/s");
}

TEST_CASE("the SI unit of a dimension reads back as that dimension") {
  for (const std::string& name : unit_names()) {
    const Dimension dimension = dimension_of(name);
    INFO(name);
    CHECK(dimension_of(si_unit(dimension)) == dimension);
    CHECK(parse_unit(si_unit(dimension))->factor == 1);
  }
}

TEST_CASE("unit names are unique and there are enough of them") {
  std::vector<std::string> names = unit_names();
  CHECK(names.size() >= 60);
  std::sort(names.begin(), names.end());
  CHECK(std::adjacent_find(names.begin(), names.end()) == names.end());
}

TEST_CASE("what is not a quantity") {
  QuantityError error;
  CHECK_FALSE(parse_quantity("fast", &error));
  CHECK(error.unit_text.empty());
  CHECK_FALSE(parse_quantity("12 mtr", &error));
  CHECK(error.unit_text == "mtr");
  CHECK_FALSE(parse_quantity("12 degrees", &error));
  CHECK(error.nearest == "deg");
  CHECK_FALSE(parse_quantity("12 kg/mm/s"));
  CHECK_FALSE(parse_quantity("12 /s"));
  CHECK_FALSE(parse_quantity("12 m/"));
  CHECK_FALSE(parse_quantity(""));
  CHECK_FALSE(parse_quantity("010 m"));
}

TEST_CASE("numbers are strict decimals") {
  CHECK(parse_number("1e3") == 1000.0);
  CHECK(parse_number("+0.5") == 0.5);
  CHECK(parse_number(".5") == 0.5);
  CHECK(parse_number("5.") == 5.0);
  CHECK(parse_number("-0") == 0.0);
  for (const char* text :
       {"", "010", "0x10", "nan", "inf", "1e999", "1_000", "1e", ".", "-", "1 2", "--1", "1,5"}) {
    INFO(text);
    CHECK_FALSE(parse_number(text));
  }
}

TEST_CASE("the nearest name") {
  const std::vector<std::string> names{"disk", "polygon", "restitution", "explosive"};
  CHECK(nearest_name("polygn", names) == "polygon");
  CHECK(nearest_name("dsik", names) == "disk");
  CHECK(nearest_name("explos", names) == "explosive");
  CHECK(nearest_name("sphere", names).empty());
  CHECK(nearest_name("", names).empty());
}

TEST_CASE("exponents of units may have digits after the point, or be fractions") {
  CHECK(si("1 N/m^1.5") == 1);
  CHECK(si("1 N/m1.5") == 1);
  CHECK(si("1 kN/mm^1.5") == Approx(1e3 / std::pow(1e-3, 1.5)));
  CHECK(si("2e7 N m^-1.5") == 2e7);
  CHECK(dimension_of("N/m^1.5") == dimension_of("N/m^(3/2)"));
  CHECK(dimension_of("N/m^1.5") == dimension_of("kg/m^0.5 s2"));
  CHECK(dimension_of("N m^(-3/2)") == dimension_of("N/m^1.5"));
  CHECK(dimension_of("N/m^1.3") == dimension_of("kg m^-0.3/s2"));
  CHECK(dimension_of("m^0.5 m^0.5") == dimension::length);
  CHECK(si_unit(dimension_of("N/m^1.5")) == "kg/m^0.5 s2");
  CHECK(dimension_of(si_unit(dimension_of("N/m^1.5"))) == dimension_of("N/m^1.5"));
  for (const char* text :
       {"1 m^", "1 m^1.5.2", "1 m^(3/0)", "1 m^0", "1 m^(3/2", "1 m^10", "1 m^x", "1 1.5m"}) {
    INFO(text);
    CHECK_FALSE(parse_quantity(text));
  }
  // A dot between letters still multiplies.
  CHECK(dimension_of("N.m") == dimension::energy);
  CHECK(dimension_of("kg.m2.s-2") == dimension::energy);
}

TEST_CASE("a number that is read as a whole number that it is not") {
  for (const char* text :
       {"9007199254740993", "-9007199254740993", "900719925474099.25e1", "2.00000000000000001",
        "9.007199254740993e15", "123456789012345678901", "0.99999999999999999999"}) {
    INFO(text);
    CHECK(rounds_to_whole(text));
  }
  for (const char* text :
       {"9007199254740992", "9007199254740994", "0009", "1e300", "12", "2.0000000000000000000",
        "90071992547409920e-1", "2.5", "0.1000000000000000055511", "-0.0", "18014398509481984"}) {
    INFO(text);
    CHECK_FALSE(rounds_to_whole(text));
  }
  // Against whole numbers of 64 bits: a number rounds if and only if the double is another one.
  std::uint64_t state = 12345;
  for (int i = 0; i < 20000; ++i) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    const std::uint64_t whole = state >> (i % 40);
    const auto number = static_cast<double>(whole);
    const bool is_exact = number < 18446744073709551616.0 && static_cast<std::uint64_t>(number) == whole;
    INFO(whole);
    CHECK(rounds_to_whole(std::to_string(whole)) == !is_exact);
  }
}
