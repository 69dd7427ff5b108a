#include "units/unit_table.h"

namespace flyrock {

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double foot = 0.3048;                           // m, exactly
constexpr double inch = foot / 12;                        // m
constexpr double mile = 5280 * foot;                      // m
constexpr double pound = 0.45359237;                      // kg, exactly
constexpr double standard_gravity = 9.80665;              // m/s2, exactly
constexpr double pound_force = pound * standard_gravity;  // N
constexpr double psi = pound_force / (inch * inch);       // Pa
constexpr double calorie = 4.184;                         // J, thermochemical
constexpr double gallon = 231 * inch * inch * inch;       // m3, US liquid

constexpr Dimension area{2, 0, 0, 0};
constexpr Dimension volume{3, 0, 0, 0};
constexpr Dimension frequency{0, 0, -1, 0};
constexpr Dimension force{1, 1, -2, 0};
constexpr Dimension pressure{-1, 1, -2, 0};
constexpr Dimension power{2, 1, -3, 0};

constexpr NamedUnit table[] = {
    // length
    {"m", {1, dimension::length}},
    {"um", {1e-6, dimension::length}},
    {"mm", {1e-3, dimension::length}},
    {"cm", {1e-2, dimension::length}},
    {"dm", {0.1, dimension::length}},
    {"km", {1e3, dimension::length}},
    {"in", {inch, dimension::length}},
    {"ft", {foot, dimension::length}},
    {"yd", {3 * foot, dimension::length}},
    {"mi", {mile, dimension::length}},
    // area and volume
    {"ha", {1e4, area}},
    {"acre", {43560 * foot * foot, area}},
    {"l", {1e-3, volume}},
    {"L", {1e-3, volume}},
    {"ml", {1e-6, volume}},
    {"gal", {gallon, volume}},
    // mass
    {"kg", {1, dimension::mass}},
    {"g", {1e-3, dimension::mass}},
    {"mg", {1e-6, dimension::mass}},
    {"t", {1e3, dimension::mass}},
    {"tonne", {1e3, dimension::mass}},
    {"kt", {1e6, dimension::mass}},
    {"lb", {pound, dimension::mass}},
    {"oz", {pound / 16, dimension::mass}},
    {"ton_short", {2000 * pound, dimension::mass}},
    {"ton_long", {2240 * pound, dimension::mass}},
    // time
    {"s", {1, dimension::time}},
    {"us", {1e-6, dimension::time}},
    {"ms", {1e-3, dimension::time}},
    {"min", {60, dimension::time}},
    {"h", {3600, dimension::time}},
    {"d", {86400, dimension::time}},
    {"Hz", {1, frequency}},
    {"kHz", {1e3, frequency}},
    // angle and spin
    {"rad", {1, dimension::angle}},
    {"mrad", {1e-3, dimension::angle}},
    {"deg", {pi / 180, dimension::angle}},
    {"°", {pi / 180, dimension::angle}},
    {"grad", {pi / 200, dimension::angle}},
    {"gon", {pi / 200, dimension::angle}},
    {"turn", {2 * pi, dimension::angle}},
    {"rev", {2 * pi, dimension::angle}},
    {"rpm", {2 * pi / 60, dimension::spin}},
    // speed and acceleration
    {"kph", {1e3 / 3600, dimension::speed}},
    {"mph", {mile / 3600, dimension::speed}},
    {"fps", {foot, dimension::speed}},
    {"knot", {1852.0 / 3600, dimension::speed}},
    // force
    {"N", {1, force}},
    {"kN", {1e3, force}},
    {"MN", {1e6, force}},
    {"kgf", {standard_gravity, force}},
    {"lbf", {pound_force, force}},
    {"kip", {1e3 * pound_force, force}},
    // pressure
    {"Pa", {1, pressure}},
    {"kPa", {1e3, pressure}},
    {"MPa", {1e6, pressure}},
    {"GPa", {1e9, pressure}},
    {"bar", {1e5, pressure}},
    {"atm", {101325, pressure}},
    {"psi", {psi, pressure}},
    {"ksi", {1e3 * psi, pressure}},
    // energy and power
    {"J", {1, dimension::energy}},
    {"kJ", {1e3, dimension::energy}},
    {"MJ", {1e6, dimension::energy}},
    {"GJ", {1e9, dimension::energy}},
    {"cal", {calorie, dimension::energy}},
    {"kcal", {1e3 * calorie, dimension::energy}},
    {"kWh", {3.6e6, dimension::energy}},
    {"ft-lb", {foot * pound_force, dimension::energy}},
    {"ft-lbf", {foot * pound_force, dimension::energy}},
    {"W", {1, power}},
    {"kW", {1e3, power}},
    {"MW", {1e6, power}},
    // ratio
    {"%", {1e-2, dimension::none}},
};

}  // namespace

std::span<const NamedUnit> unit_table() { return table; }

}  // namespace flyrock
