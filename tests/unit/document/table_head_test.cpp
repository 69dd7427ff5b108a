#include "document/table_head.h"

#include <catch2/catch.hpp>

using namespace flyrock;

namespace table_head_test {

const std::vector<TableColumn> columns = {
    {.name = "hole", .dimension = {}, .is_text = true},
    {.name = "row", .dimension = {}},
    {.name = "x", .dimension = dimension::length},
    {.name = "y", .dimension = dimension::length},
    {.name = "z", .dimension = dimension::length},
    {.name = "diameter", .dimension = dimension::length, .also = {"hole_diameter"}},
    {.name = "burden", .dimension = dimension::length},
    {.name = "burden_toe", .dimension = dimension::length, .also = {"toe_burden"}},
    {.name = "charge_length", .dimension = dimension::length},
    {.name = "charge", .dimension = dimension::mass},
    {.name = "linear_charge", .dimension = {-1, 1, 0, 0}, .also = {"charge"}},
    {.name = "dip", .dimension = dimension::angle},
    {.name = "bearing", .dimension = dimension::angle},
    {.name = "time", .dimension = dimension::time},
    {.name = "vx", .dimension = dimension::speed},
};

HeadMatch match(std::string_view head) { return match_head(head, columns, {}); }

}  // namespace table_head_test

using namespace table_head_test;

TEST_CASE("spellings of heads are read with the unit that they mean") {
  constexpr double foot = 0.3048, inch = 0.0254, degree = 3.14159265358979323846 / 180;
  const std::tuple<const char*, const char*, double> spellings[] = {
      {"burden_m", "burden", 1},
      {"BURDEN_M", "burden", 1},
      {"Burden (m)", "burden", 1},
      {"burden [m]", "burden", 1},
      {"burden{m}", "burden", 1},
      {"Burden, m", "burden", 1},
      {"burden m", "burden", 1},
      {"burden in m", "burden", 1},
      {"burden in", "burden", inch},
      {"burden_in", "burden", inch},
      {"burden-m", "burden", 1},
      {"burden.m", "burden", 1},
      {"Burden (metres)", "burden", 1},
      {"burden in Feet", "burden", foot},
      {"BURDEN_FT", "burden", foot},
      {"burden (ft.)", "burden", foot},
      {"Burden [Inches]", "burden", inch},
      {"burden: cm", "burden", 0.01},
      {"burden (in m)", "burden", 1},
      {"Burden [M]", "burden", 1},
      {"hole diameter (mm)", "diameter", 1e-3},
      {"Hole_Diameter_MM", "diameter", 1e-3},
      {"Diameter [millimetres]", "diameter", 1e-3},
      {"diameter_in", "diameter", inch},
      {"Toe burden (m)", "burden_toe", 1},
      {"burden toe [m]", "burden_toe", 1},
      {"Charge length (m)", "charge_length", 1},
      {"charge-length_m", "charge_length", 1},
      {"Charge (kg)", "charge", 1},
      {"CHARGE_KG", "charge", 1},
      {"charge in pounds", "charge", 0.45359237},
      {"charge (lbs)", "charge", 0.45359237},
      {"charge_kg_per_m", "linear_charge", 1},
      {"Charge (kg/m)", "linear_charge", 1},
      {"Linear charge [kg per metre]", "linear_charge", 1},
      {"linear_charge_kg_m", "linear_charge", 1},
      {"LINEAR CHARGE, KG/M", "linear_charge", 1},
      {"linearcharge (lb/ft)", "linear_charge", 0.45359237 / foot},
      {"dip_deg", "dip", degree},
      {"Dip (degrees)", "dip", degree},
      {"Dip [°]", "dip", degree},
      {"DIP DEG", "dip", degree},
      {"dip in gon", "dip", degree * 0.9},
      {"Bearing (Degrees)", "bearing", degree},
      {"time_ms", "time", 1e-3},
      {"Time (ms)", "time", 1e-3},
      {"TIME MS", "time", 1e-3},
      {"Delay [msec]", "time", 1e-3},
      {"delay_milliseconds", "time", 1e-3},
      {"firing time (s)", "time", 1},
      {"vx_m_s", "vx", 1},
      {"Vx (m/s)", "vx", 1},
      {"vx in metres per second", "vx", 1},
      {"Easting", "x", 1},
      {"Easting (m)", "x", 1},
      {"X_COLLAR", "x", 1},
      {"Collar X [ft]", "x", foot},
      {"NORTHING_M", "y", 1},
      {"North", "y", 1},
      {"RL", "z", 1},
      {"Elevation (m)", "z", 1},
      {"RL [m]", "z", 1},
      {"Z-Collar", "z", 1},
      {"Hole ID", "hole", 1},
      {"HoleID", "hole", 1},
      {"hole no.", "hole", 1},
      {"Hole #", "hole", 1},
      {"ID", "hole", 1},
      {"No.", "hole", 1},
      {"Row no.", "row", 1},
  };
  for (const auto& [head, column, factor] : spellings) {
    CAPTURE(head);
    const HeadMatch found = match(head);
    REQUIRE(found.column);
    CHECK(found.column->name == column);
    CHECK(found.unit.unit.factor == Approx(factor).epsilon(1e-12));
    CHECK(found.unit.unit.dimension == found.column->dimension);
  }
}

TEST_CASE("a head that begins with a name and goes on with no unit of it is not passed over") {
  const std::pair<const char*, const char*> heads[] = {{"burden_mean_m", "burden"},
                                                       {"burden (kg)", "burden"},
                                                       {"Burden m (design)", "burden"},
                                                       {"dip_m", "dip"},
                                                       {"time_stamp", "time"},
                                                       {"hole type", "hole"},
                                                       {"x_utm", "x"},
                                                       {"Easting UTM32", "x"},
                                                       {"charge_kg_per_hole", "charge"},
                                                       {"burden_us_ft", "burden"},
                                                       {"delay (ms) planned", "time"}};
  for (const auto& [head, column] : heads) {
    CAPTURE(head);
    const HeadMatch found = match(head);
    CHECK_FALSE(found.column);
    REQUIRE(found.begun);
    CHECK(found.begun->name == column);
  }
}

TEST_CASE("a head that begins with no name is none of the columns") {
  for (const char* head :
       {"note", "burdens", "xylem", "colour [m]", "north_pole_distance_of", "normal", "idea"}) {
    CAPTURE(head);
    const HeadMatch found = match(head);
    CHECK_FALSE(found.column);
    if (std::string_view(head) != "north_pole_distance_of") CHECK_FALSE(found.begun);
  }
}
