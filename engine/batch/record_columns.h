#pragma once
// The columns of the tables of a run, described once: chunk files write and read them, rocks.csv and
// results.db show them. Tables without records (points, sweep, parts, ...) have theirs in
// report/database.cpp.
//
// Each writer adds the column `point` itself, and in tables other than rocks also `trial` and `rock`.
//
// visit_<table>(visit) calls visit(column, get) for each column in order. member_of(record, get) is a
// reference to the value of the column, const for a const record.

#include <string>
#include <string_view>
#include <type_traits>

#include "batch/member_of.h"
#include "batch/records.h"
#include "math/space.h"

namespace flyrock {

struct Column {
  const char* name = nullptr;  ///< in results.db and rocks.csv, with its unit; none: only in chunk files
  bool in_space =
      false;           ///< zero in 2D: then left out of rocks.csv and of tables with many rows for each rock
  bool in_csv = true;  ///< also in rocks.csv
  bool in_degrees = false;  ///< shown in degrees, stored in rad
  bool is_index = false;    ///< index of a group, gate or barrier; its name is shown
};

template <class Visit>
void visit_rocks(Visit&& visit) {
  using R = RockRecord;
  visit(Column{.name = "trial"}, &R::trial);
  visit(Column{.name = "rock"}, &R::rock);
  visit(Column{.name = "group", .is_index = true}, &R::group);
  visit(Column{.name = "mass_kg"}, &R::mass);
  visit(Column{.name = "volume_m3"}, &R::volume);
  visit(Column{.name = "launch_speed_m_s"}, &R::launch_speed);
  visit(Column{.name = "launch_elevation_deg", .in_degrees = true}, &R::launch_elevation);
  visit(Column{.name = "stop_reason"}, &R::reason);
  visit(Column{.name = "censored"}, &R::censored);
  visit(Column{}, &R::start_x);
  visit(Column{}, &R::start_y);
  visit(Column{.name = "runout_m"}, &R::runout);
  visit(Column{.name = "max_distance_m"}, &R::max_distance);
  visit(Column{.name = "stop_x_m"}, &R::stop_x);
  visit(Column{.name = "stop_y_m"}, &R::stop_y);
  visit(Column{.name = "stop_z_m", .in_space = true}, &R::stop_z);
  visit(Column{}, &R::end_part);
  visit(Column{}, &R::landed);
  visit(Column{.name = "flight_range_m"}, &R::flight_range);
  visit(Column{.name = "bounce_height_m"}, &R::bounce_height);
  visit(Column{.name = "max_speed_m_s"}, &R::max_speed);
  visit(Column{.name = "max_energy_J"}, &R::max_energy);
  visit(Column{.name = "impacts"}, &R::impacts);
  visit(Column{.name = "time_s"}, &R::time);
  // In the same order as travel_mode_names.
  constexpr const char* names[][2] = {
      {"flight_s", "flight_m"}, {"bounce_s", "bounce_m"}, {"slide_s", "slide_m"}, {"roll_s", "roll_m"}};
  static_assert(std::size(names) == travel_mode_names.size());
  for (std::size_t mode = 0; mode < std::size(names); ++mode) {
    visit(
        Column{.name = names[mode][0], .in_csv = false}, [mode](auto& r) -> auto& {
          return r.travel.time[mode];
        });
    visit(
        Column{.name = names[mode][1], .in_csv = false}, [mode](auto& r) -> auto& {
          return r.travel.distance[mode];
        });
  }
  visit(Column{.name = "fault", .in_csv = false}, &R::fault);
}

// The rows below belong to a rock. Their trial and rock are stored separately.

template <class Visit>
void visit_inputs(Visit&& visit) {
  visit(Column{.name = "input"}, &InputRecord::input);
  visit(Column{.name = "impact"}, &InputRecord::impact);
  visit(Column{.name = "value"}, &InputRecord::value);
}

/// Columns of an Impact. A vector has the components x and y in 2D, and z as well in 3D.
template <class Visit>
void visit_impact(Visit&& visit) {
  using I = Impact;
  visit(Column{}, &I::body);
  visit(Column{.name = "number"}, &I::number);
  visit(Column{.name = "time_s"}, &I::time);
  visit(
      Column{.name = "x_m"}, [](auto& i) -> auto& { return i.place[0]; });
  visit(
      Column{.name = "y_m"}, [](auto& i) -> auto& { return i.place[1]; });
  visit(
      Column{.name = "z_m", .in_space = true}, [](auto& i) -> auto& { return i.place[2]; });
  visit(Column{.name = "other"}, &I::other);
  visit(Column{.name = "part"}, &I::part);
  visit(Column{.name = "vn_before_m_s"}, &I::vn_before);
  visit(Column{.name = "vn_after_m_s"}, &I::vn_after);
  visit(Column{.name = "vt_before_m_s"}, &I::vt_before);
  visit(Column{.name = "vt_after_m_s"}, &I::vt_after);
  visit(Column{.name = "pn_N_s"}, &I::pn);
  visit(Column{.name = "pt_N_s"}, &I::pt);
  visit(Column{.name = "energy_change_J"}, &I::energy_change);
}

/// Columns of a BodyState.
template <class Visit>
void visit_state(Visit&& visit) {
  using S = BodyState;
  visit(Column{.name = "time_s"}, &S::time);
  visit(
      Column{.name = "x_m"}, [](auto& s) -> auto& { return s.position[0]; });
  visit(
      Column{.name = "y_m"}, [](auto& s) -> auto& { return s.position[1]; });
  visit(
      Column{.name = "z_m", .in_space = true}, [](auto& s) -> auto& { return s.position[2]; });
  visit(
      Column{.name = "vx_m_s"}, [](auto& s) -> auto& { return s.velocity[0]; });
  visit(
      Column{.name = "vy_m_s"}, [](auto& s) -> auto& { return s.velocity[1]; });
  visit(
      Column{.name = "vz_m_s", .in_space = true}, [](auto& s) -> auto& { return s.velocity[2]; });
  visit(
      Column{.name = "spin_x_rad_s", .in_space = true}, [](auto& s) -> auto& { return s.spin[0]; });
  visit(
      Column{.name = "spin_y_rad_s", .in_space = true}, [](auto& s) -> auto& { return s.spin[1]; });
  visit(
      Column{.name = "spin_z_rad_s"}, [](auto& s) -> auto& { return s.spin[2]; });
  visit(Column{.name = "angle_rad"}, &S::angle);
  visit(Column{.name = "kinetic_energy_J"}, &S::kinetic_energy);
}

/// Visits the columns of a member of a record: visit_impact(within(visit, &ImpactRecord::impact)).
template <class Visit, class Part>
auto within(Visit& visit, Part part) {
  return [&visit, part](const Column& column, auto get) {
    visit(
        column, [ part, get ](auto& record) -> auto& { return member_of(member_of(record, part), get); });
  };
}

template <class Visit>
void visit_impacts(Visit&& visit) {
  visit_impact(within(visit, &ImpactRecord::impact));
}

/// Columns of an attitude as a unit quaternion.
template <class Visit>
void visit_turn(Visit&& visit) {
  constexpr const char* quaternion[] = {"qw", "qx", "qy", "qz"};
  for (std::size_t i = 0; i < std::size(quaternion); ++i)
    visit(
        Column{.name = quaternion[i], .in_space = true}, [i](auto& turn) -> auto& { return turn[i]; });
}

template <class Visit>
void visit_trajectories(Visit&& visit) {
  visit_state(within(
      visit, [](auto& r) -> auto& { return r.point.state; }));
  visit(
      Column{.name = "mode"}, [](auto& r) -> auto& { return r.point.mode; });
  visit_turn(within(
      visit, [](auto& r) -> auto& { return r.point.turn; }));
}

/// Columns of a SurfaceCorner.
template <class Visit>
void visit_corner(Visit&& visit) {
  using C = SurfaceCorner;
  visit(Column{.name = "contactor"}, &C::contactor);
  visit(Column{.name = "face"}, &C::face);
  visit(
      Column{.name = "x_m"}, [](auto& c) -> auto& { return c.place[0]; });
  visit(
      Column{.name = "y_m"}, [](auto& c) -> auto& { return c.place[1]; });
  visit(
      Column{.name = "z_m", .in_space = true}, [](auto& c) -> auto& { return c.place[2]; });
  visit(Column{.name = "radius_m"}, &C::radius);
}

template <class Visit>
void visit_shapes(Visit&& visit) {
  visit_corner(within(visit, &ShapeRecord::corner));
}

// The following rows belong to a trial, which is stored separately.

template <class Visit>
void visit_fixtures(Visit&& visit) {
  visit(
      Column{.name = "body"}, [](auto& r) -> auto& { return r.row.body; });
  visit_state(within(
      visit, [](auto& r) -> auto& { return r.row.start; }));
  visit_turn(within(
      visit, [](auto& r) -> auto& { return r.row.turn; }));
  constexpr const char* accelerations[] = {"ax_m_s2", "ay_m_s2", "az_m_s2"};
  for (int i = 0; i < 3; ++i)
    visit(
        Column{.name = accelerations[i], .in_space = i == 2}, [i](auto& r) -> auto& {
          return r.row.acceleration[i];
        });
}

template <class Visit>
void visit_fixture_shapes(Visit&& visit) {
  visit(
      Column{.name = "body"}, [](auto& r) -> auto& { return r.row.body; });
  visit_corner(within(
      visit, [](auto& r) -> auto& { return r.row.corner; }));
}

template <class Visit>
void visit_series_bodies(Visit&& visit) {
  visit(
      Column{.name = "body"}, [](auto& r) -> auto& { return r.row.body; });
  visit_state(within(
      visit, [](auto& r) -> auto& { return r.row.state; }));
  visit(
      Column{.name = "potential_energy_J"}, [](auto& r) -> auto& { return r.row.potential_energy; });
  visit_turn(within(
      visit, [](auto& r) -> auto& { return r.row.turn; }));
  visit(
      Column{.name = "radius_m"}, [](auto& r) -> auto& { return r.row.radius; });
}

template <class Visit>
void visit_series_contacts(Visit&& visit) {
  using C = SeriesContact;
  const auto of_row = within(
      visit, [](auto& r) -> auto& { return r.row; });
  of_row(Column{.name = "time_s"}, &C::time);
  of_row(Column{.name = "a"}, &C::a);
  of_row(Column{.name = "b"}, &C::b);
  of_row(Column{.name = "number"}, &C::point);
  of_row(Column{.name = "step_s"}, &C::step);
  of_row(Column{.name = "gap_m"}, &C::gap);
  of_row(Column{.name = "un_m_s"}, &C::un);
  of_row(Column{.name = "ut_m_s"}, &C::ut);
  of_row(Column{.name = "pn_N_s"}, &C::pn);
  of_row(Column{.name = "pt_N_s"}, &C::pt);
  of_row(Column{.name = "rn_N"}, &C::rn);
  of_row(Column{.name = "rt_N"}, &C::rt);
  of_row(Column{.name = "state"}, &C::state);
  constexpr const char* places[] = {"x_m", "y_m", "z_m"};
  constexpr const char* normals[] = {"nx", "ny", "nz"};
  for (int i = 0; i < 3; ++i)
    of_row(
        Column{.name = places[i]}, [i](auto& row) -> auto& { return row.place[i]; });
  for (int i = 0; i < 3; ++i)
    of_row(
        Column{.name = normals[i]}, [i](auto& row) -> auto& { return row.normal[i]; });
}

template <class Visit>
void visit_series_solves(Visit&& visit) {
  using S = SeriesSolve;
  const auto of_row = within(
      visit, [](auto& r) -> auto& { return r.row; });
  of_row(Column{.name = "time_s"}, &S::time);
  of_row(Column{.name = "step_s"}, &S::step);
  of_row(Column{.name = "contacts"}, &S::contacts);
  of_row(Column{.name = "sweeps"}, &S::sweeps);
  of_row(Column{.name = "residual_m_s"}, &S::residual);
}

/// The tables of rows of trials: see(name, the rows of `records`, their visit).
template <class Records, class See>
void visit_trial_tables(Records& records, See&& see) {
  see("fixtures", records.fixtures, [](auto&& visit) { visit_fixtures(visit); });
  see("fixture_shapes", records.fixture_shapes, [](auto&& visit) { visit_fixture_shapes(visit); });
  see("series_bodies", records.series_bodies, [](auto&& visit) { visit_series_bodies(visit); });
  see("series_contacts", records.series_contacts, [](auto&& visit) { visit_series_contacts(visit); });
  see("series_solves", records.series_solves, [](auto&& visit) { visit_series_solves(visit); });
}

/// The columns that a passage of a gate and an arrival at a barrier share.
template <class Visit>
void visit_arrival(Visit&& visit) {
  visit(
      Column{.name = "time_s"}, [](auto& a) -> auto& { return a.time; });
  visit(
      Column{.name = "speed_m_s"}, [](auto& a) -> auto& { return a.speed; });
  visit(
      Column{.name = "energy_J"}, [](auto& a) -> auto& { return a.kinetic_energy; });
  visit(
      Column{.name = "height_m"}, [](auto& a) -> auto& { return a.height; });
  visit(
      Column{.name = "along_m"}, [](auto& a) -> auto& { return a.along; });
}

template <class Visit>
void visit_gates(Visit&& visit) {
  visit(
      Column{.name = "gate", .is_index = true}, [](auto& r) -> auto& { return r.passage.gate; });
  visit_arrival(within(visit, &GateRecord::passage));
}

template <class Visit>
void visit_barriers(Visit&& visit) {
  visit(
      Column{.name = "barrier", .is_index = true}, [](auto& r) -> auto& { return r.hit.barrier; });
  visit(
      Column{.name = "outcome"}, [](auto& r) -> auto& { return r.hit.outcome; });
  visit_arrival(within(visit, &BarrierRecord::hit));
}

template <class Visit>
void visit_trees(Visit&& visit) {
  visit(
      Column{.name = "tree"}, [](auto& r) -> auto& { return r.hit.tree; });
  visit(
      Column{.name = "time_s"}, [](auto& r) -> auto& { return r.hit.time; });
  visit(
      Column{.name = "energy_before_J"}, [](auto& r) -> auto& { return r.hit.energy_before; });
  visit(
      Column{.name = "energy_after_J"}, [](auto& r) -> auto& { return r.hit.energy_after; });
  visit(
      Column{.name = "height_m"}, [](auto& r) -> auto& { return r.hit.height; });
}

/// Calls `use` with what a table shows for `value`: a number, a text, or the name for an index. `names`: the
/// names for `is_index`.
template <class T>
auto shown_value(const Column& column, const T& value, const std::vector<std::string>& names, auto&& use) {
  if constexpr (std::is_same_v<T, TravelMode>)
    return use(std::string_view(travel_mode_names[static_cast<std::size_t>(value)]));
  else if constexpr (std::is_enum_v<T>)
    return use(std::string_view(name_of(value)));
  else if constexpr (std::is_same_v<T, std::string>)
    return use(std::string_view(value));
  else if constexpr (std::is_same_v<T, double>)
    return use(column.in_degrees ? value * 180 / pi : value);
  else if (column.is_index)
    return use(std::string_view(names.at(static_cast<std::size_t>(value))));
  else
    return use(value);
}

/// The SQL type of such a value.
template <class T>
constexpr const char* sql_type(const Column& column) {
  if constexpr (std::is_same_v<T, double>) return "REAL";
  return column.is_index || std::is_enum_v<T> || std::is_same_v<T, std::string> ? "TEXT" : "INTEGER";
}

}  // namespace flyrock
