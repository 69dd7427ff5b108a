#pragma once
// The tables of a run and their columns, described once: chunk files, results.db, rocks.csv, the statistics
// of rocks and the report read this list. A new column is a member of its record and a line here; a new
// statistic of rocks is a `statistic` in that line. Tables that are not made of rows of trials (points,
// sweep, parts, ...) are in report/tables/database.cpp.
//
// visit_<table>(visit) calls visit(column, get) for each column in order. member_of(record, get) is a
// reference to the value of the column, const for a const record.

#include <array>

#include "record/member_of.h"
#include "record/records.h"
#include "record/rows.h"

namespace flyrock {

/// Which list a whole number counts; tables show the name, or of inputs the number in `input_paths`.
enum class NamesOf { nothing, groups, gates, barriers, inputs, holes, branches };

/// From when on a number of a rock is known. The path of a censored rock was cut short, so a number that is
/// known only at its end is a lower bound.
enum class KnownFrom { start, landing, end };

/// What a run has, where that decides which columns its tables show.
struct TableContent {
  int dimension = 2;
  bool holes = false;     ///< measured ones
  bool branches = false;  ///< besides the regular blast
  bool weights = false;   ///< of rocks
};

struct Column {
  const char* name = nullptr;       ///< in results.db and rocks.csv; none: only in chunk files
  const char* unit = "";            ///< of the numbers that tables show
  const char* doc = "";             ///< what it is, in a few words
  const char* statistic = nullptr;  ///< its name in measures, if there are statistics of it
  KnownFrom known = KnownFrom::end;
  /// A place along x: of a censored rock that went towards smaller x it is no lower bound, and is taken as it
  /// is.
  bool along_x = false;
  /// zero in 2D: then left out of rocks.csv and of tables with many rows for each rock
  bool in_space = false;
  bool in_csv = true;       ///< also in rocks.csv
  bool in_degrees = false;  ///< shown in degrees, stored in rad
  NamesOf names = NamesOf::nothing;
  bool of_weights = false;  ///< only in the tables of a run whose rocks have weights

  /// Whether tables show it: holes, branches and weights only where there are any.
  bool is_of(const TableContent& content) const {
    if (of_weights) return content.weights;
    if (names == NamesOf::holes) return content.holes;
    return names != NamesOf::branches || content.branches;
  }
};

template <class Visit>
constexpr void visit_rocks(Visit&& visit) {
  using R = RockRecord;
  visit(Column{.name = "trial", .doc = "number of the trial, from 0"}, &R::trial);
  visit(Column{.name = "rock", .doc = "number in the trial, from 0"}, &R::rock);
  visit(Column{.name = "group", .doc = "group of rocks, or body", .names = NamesOf::groups}, &R::group);
  visit(Column{.name = "hole", .doc = "measured hole that it leaves", .names = NamesOf::holes}, &R::hole);
  visit(Column{.name = "branch", .doc = "what became of its hole or blast", .names = NamesOf::branches},
        &R::branch);
  visit(Column{.name = "weight", .doc = "number of real rocks that it stands for", .of_weights = true},
        &R::weight);
  visit(Column{.name = "mass_kg", .unit = "kg", .doc = "of the whole rock"}, &R::mass);
  visit(Column{.name = "volume_m3", .unit = "m3", .doc = "of the whole rock"}, &R::volume);
  visit(Column{.name = "launch_speed_m_s",
               .unit = "m/s",
               .doc = "speed at the launch",
               .statistic = "launch_speed",
               .known = KnownFrom::start},
        &R::launch_speed);
  visit(Column{.name = "launch_elevation_deg",
               .unit = "deg",
               .doc = "angle of the launch above the horizontal",
               .in_degrees = true},
        &R::launch_elevation);
  visit(Column{.name = "stop_reason", .doc = "why its path ended"}, &R::reason);
  visit(Column{.name = "censored", .doc = "1: the path was cut short, its distances are lower bounds"},
        &R::censored);
  visit(Column{}, &R::decided_gates);
  visit(Column{}, &R::decided_barriers);
  visit(Column{.name = "start_x_m", .unit = "m", .doc = "centre of mass at the release", .in_csv = false},
        &R::start_x);
  visit(Column{.name = "start_y_m", .unit = "m", .doc = "centre of mass at the release", .in_csv = false},
        &R::start_y);
  visit(Column{.name = "runout_m",
               .unit = "m",
               .doc = "horizontal distance from release to stop",
               .statistic = "runout"},
        &R::runout);
  visit(Column{.name = "max_distance_m",
               .unit = "m",
               .doc = "greatest horizontal distance from the release",
               .statistic = "max_distance"},
        &R::max_distance);
  visit(Column{.name = "stop_x_m",
               .unit = "m",
               .doc = "centre of mass at the end",
               .statistic = "stop_x",
               .along_x = true},
        &R::stop_x);
  visit(Column{.name = "stop_y_m", .unit = "m", .doc = "centre of mass at the end"}, &R::stop_y);
  visit(Column{.name = "stop_z_m", .unit = "m", .doc = "centre of mass at the end", .in_space = true},
        &R::stop_z);
  visit(Column{}, &R::end_energy);
  visit(Column{}, &R::end_part);
  visit(Column{}, &R::landed);
  visit(Column{.name = "flight_range_m",
               .unit = "m",
               .doc = "horizontal distance from launch to first landing",
               .statistic = "flight_range",
               .known = KnownFrom::landing},
        &R::flight_range);
  visit(Column{.name = "bounce_height_m",
               .unit = "m",
               .doc = "greatest height of the centre of mass above the ground",
               .statistic = "bounce_height"},
        &R::bounce_height);
  visit(Column{.name = "max_speed_m_s", .unit = "m/s", .doc = "greatest speed", .statistic = "speed"},
        &R::max_speed);
  visit(Column{.name = "max_energy_J",
               .unit = "J",
               .doc = "greatest kinetic energy, rotation included",
               .statistic = "energy"},
        &R::max_energy);
  visit(Column{.name = "impacts",
               .doc = "contacts that closed faster than solver.rest_speed",
               .statistic = "impacts"},
        &R::impacts);
  visit(Column{.name = "time_s", .unit = "s", .doc = "from release to rest or end", .statistic = "time"},
        &R::time);
  // In the same order as travel_mode_names.
  constexpr const char* names[][2] = {
      {"flight_s", "flight_m"}, {"bounce_s", "bounce_m"}, {"slide_s", "slide_m"}, {"roll_s", "roll_m"}};
  static_assert(std::size(names) == travel_mode_names.size());
  for (std::size_t mode = 0; mode < std::size(names); ++mode) {
    visit(
        Column{.name = names[mode][0], .unit = "s", .doc = "time in this mode of travel", .in_csv = false},
        [mode](auto& r) -> auto& { return r.travel.time[mode]; });
    visit(
        Column{.name = names[mode][1], .unit = "m", .doc = "path in this mode of travel", .in_csv = false},
        [mode](auto& r) -> auto& { return r.travel.distance[mode]; });
  }
  visit(Column{.name = "fault", .doc = "why it failed, or which side it left", .in_csv = false}, &R::fault);
}

// The rows below belong to a rock. Their trial and rock are stored separately.

template <class Visit>
void visit_inputs(Visit&& visit) {
  visit(Column{.name = "input", .names = NamesOf::inputs}, &InputRecord::input);
  visit(Column{.name = "impact"}, &InputRecord::impact);
  visit(Column{.name = "value"}, &InputRecord::value);
}

/// Visits the columns of a member of a record: visit_impact(within(visit, &ImpactRecord::impact)).
template <class Visit, class Part>
auto within(Visit& visit, Part part) {
  return [&visit, part](const Column& column, auto get) {
    visit(
        column, [ part, get ](auto& record) -> auto& { return member_of(member_of(record, part), get); });
  };
}

/// The columns of a vector, which has the components x and y in 2D, and z as well in 3D.
template <class Visit, class Get>
void visit_vector(Visit&& visit, const char* const (&names)[3], const char* unit, Get get,
                  std::array<bool, 3> in_space = {false, false, true}) {
  for (std::size_t i = 0; i < 3; ++i)
    visit(
        Column{.name = names[i], .unit = unit, .in_space = in_space[i]},
        [ get, i ](auto& record) -> auto& { return member_of(record, get)[i]; });
}

/// Columns of an Impact.
template <class Visit>
void visit_impact(Visit&& visit) {
  using I = Impact;
  visit(Column{}, &I::body);
  visit(Column{.name = "number"}, &I::number);
  visit(Column{.name = "time_s", .unit = "s"}, &I::time);
  visit_vector(visit, {"x_m", "y_m", "z_m"}, "m", &I::place);
  visit(Column{.name = "other"}, &I::other);
  visit(Column{.name = "part"}, &I::part);
  visit(Column{.name = "vn_before_m_s", .unit = "m/s"}, &I::vn_before);
  visit(Column{.name = "vn_after_m_s", .unit = "m/s"}, &I::vn_after);
  visit(Column{.name = "vt_before_m_s", .unit = "m/s"}, &I::vt_before);
  visit(Column{.name = "vt_after_m_s", .unit = "m/s"}, &I::vt_after);
  visit(Column{.name = "pn_N_s", .unit = "N s"}, &I::pn);
  visit(Column{.name = "pt_N_s", .unit = "N s"}, &I::pt);
  visit(Column{.name = "energy_change_J", .unit = "J"}, &I::energy_change);
  visit(Column{.name = "count"}, &I::count);
}

/// Columns of a BodyState.
template <class Visit>
void visit_state(Visit&& visit) {
  using S = BodyState;
  visit(Column{.name = "time_s", .unit = "s"}, &S::time);
  visit_vector(visit, {"x_m", "y_m", "z_m"}, "m", &S::position);
  visit_vector(visit, {"vx_m_s", "vy_m_s", "vz_m_s"}, "m/s", &S::velocity);
  visit_vector(visit, {"spin_x_rad_s", "spin_y_rad_s", "spin_z_rad_s"}, "rad/s", &S::spin,
               {true, true, false});
  visit(Column{.name = "angle_rad", .unit = "rad"}, &S::angle);
  visit(Column{.name = "kinetic_energy_J", .unit = "J"}, &S::kinetic_energy);
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
  using P = TrajectoryPoint;
  const auto of_point = within(visit, &TrajectoryRecord::point);
  visit_state(within(of_point, &P::state));
  of_point(Column{.name = "mode"}, &P::mode);
  visit_turn(within(of_point, &P::turn));
}

/// Columns of a SurfaceCorner.
template <class Visit>
void visit_corner(Visit&& visit) {
  using C = SurfaceCorner;
  visit(Column{.name = "contactor"}, &C::contactor);
  visit(Column{.name = "face"}, &C::face);
  visit_vector(visit, {"x_m", "y_m", "z_m"}, "m", &C::place);
  visit(Column{.name = "radius_m", .unit = "m"}, &C::radius);
}

template <class Visit>
void visit_shapes(Visit&& visit) {
  visit_corner(within(visit, &ShapeRecord::corner));
}

// The following rows belong to a trial, which is stored separately.

template <class Visit>
void visit_blocks(Visit&& visit) {
  using B = BlockRow;
  const auto of_row = within(visit, &TrialRow<B>::row);
  of_row(Column{.name = "block"}, &B::block);
  of_row(Column{.name = "rock"}, &B::rock);
  visit_vector(of_row, {"x_m", "y_m", "z_m"}, "m", &B::centre);
  of_row(Column{.name = "volume_m3", .unit = "m3"}, &B::volume);
  of_row(Column{.name = "faces"}, &B::faces);
  of_row(Column{.name = "free_area_m2", .unit = "m2"}, &B::free_area);
  of_row(Column{.name = "joint_area_m2", .unit = "m2"}, &B::joint_area);
  of_row(Column{.name = "removable"}, &B::removable);
  of_row(Column{.name = "mode"}, &B::mode);
  of_row(Column{.name = "joints"}, &B::joints);
  of_row(Column{.name = "trend_deg", .unit = "deg", .in_degrees = true}, &B::trend);
  of_row(Column{.name = "plunge_deg", .unit = "deg", .in_degrees = true}, &B::plunge);
  of_row(Column{.name = "factor"}, &B::factor);
  of_row(Column{.name = "reason"}, &B::reason);
}

template <class Visit>
void visit_block_regions(Visit&& visit) {
  using R = BlockRegionRow;
  const auto of_row = within(visit, &TrialRow<R>::row);
  of_row(Column{.name = "volume_m3", .unit = "m3"}, &R::volume);
  of_row(Column{.name = "blocks"}, &R::blocks);
  of_row(Column{.name = "left_out"}, &R::left_out);
  of_row(Column{.name = "left_out_volume_m3", .unit = "m3"}, &R::left_out_volume);
  of_row(Column{.name = "joints"}, &R::joints);
  of_row(Column{.name = "joint_area_m2", .unit = "m2"}, &R::joint_area);
  of_row(Column{.name = "joint_count_per_m", .unit = "1/m"}, &R::joint_count);
}

template <class Visit>
void visit_block_corners(Visit&& visit) {
  using C = BlockCorner;
  const auto of_row = within(visit, &TrialRow<C>::row);
  of_row(Column{.name = "block"}, &C::block);
  of_row(Column{.name = "face"}, &C::face);
  of_row(Column{.name = "vertex"}, &C::vertex);
  visit_vector(of_row, {"x_m", "y_m", "z_m"}, "m", &C::place);
}

template <class Visit>
void visit_fixtures(Visit&& visit) {
  using F = Fixture;
  const auto of_row = within(visit, &TrialRow<F>::row);
  of_row(Column{.name = "body"}, &F::body);
  visit_state(within(of_row, &F::start));
  visit_turn(within(of_row, &F::turn));
  visit_vector(of_row, {"ax_m_s2", "ay_m_s2", "az_m_s2"}, "m/s2", &F::acceleration);
}

template <class Visit>
void visit_links(Visit&& visit) {
  using L = DrawnLink;
  using E = L::End;
  const auto of_row = within(visit, &TrialRow<L>::row);
  of_row(Column{.name = "link"}, &L::link);
  of_row(Column{.name = "type"}, &L::type);
  const auto of_a = within(of_row, &L::a), of_b = within(of_row, &L::b);
  of_a(Column{.name = "a"}, &E::body);
  of_a(Column{.name = "a_rock"}, &E::rock);
  visit_vector(of_a, {"ax_m", "ay_m", "az_m"}, "m", &E::place, {});
  of_b(Column{.name = "b"}, &E::body);
  of_b(Column{.name = "b_rock"}, &E::rock);
  visit_vector(of_b, {"bx_m", "by_m", "bz_m"}, "m", &E::place, {});
}

template <class Visit>
void visit_fixture_shapes(Visit&& visit) {
  using F = FixtureCorner;
  const auto of_row = within(visit, &TrialRow<F>::row);
  of_row(Column{.name = "body"}, &F::body);
  visit_corner(within(of_row, &F::corner));
}

template <class Visit>
void visit_series_bodies(Visit&& visit) {
  using B = SeriesBody;
  const auto of_row = within(visit, &TrialRow<B>::row);
  of_row(Column{.name = "body"}, &B::body);
  visit_state(within(of_row, &B::state));
  of_row(Column{.name = "potential_energy_J", .unit = "J"}, &B::potential_energy);
  visit_turn(within(of_row, &B::turn));
  of_row(Column{.name = "radius_m", .unit = "m"}, &B::radius);
}

template <class Visit>
void visit_series_contacts(Visit&& visit) {
  using C = SeriesContact;
  const auto of_row = within(visit, &TrialRow<C>::row);
  of_row(Column{.name = "time_s", .unit = "s"}, &C::time);
  of_row(Column{.name = "a"}, &C::a);
  of_row(Column{.name = "b"}, &C::b);
  of_row(Column{.name = "number"}, &C::point);
  of_row(Column{.name = "step_s", .unit = "s"}, &C::step);
  of_row(Column{.name = "gap_m", .unit = "m"}, &C::gap);
  of_row(Column{.name = "un_m_s", .unit = "m/s"}, &C::un);
  of_row(Column{.name = "ut_m_s", .unit = "m/s"}, &C::ut);
  of_row(Column{.name = "pn_N_s", .unit = "N s"}, &C::pn);
  of_row(Column{.name = "pt_N_s", .unit = "N s"}, &C::pt);
  of_row(Column{.name = "rn_N", .unit = "N"}, &C::rn);
  of_row(Column{.name = "rt_N", .unit = "N"}, &C::rt);
  of_row(Column{.name = "state"}, &C::state);
  visit_vector(of_row, {"x_m", "y_m", "z_m"}, "m", &C::place, {});
  visit_vector(of_row, {"nx", "ny", "nz"}, "", &C::normal, {});
  visit_vector(of_row, {"fx_N", "fy_N", "fz_N"}, "N", &C::force, {});
}

template <class Visit>
void visit_series_links(Visit&& visit) {
  using L = SeriesLink;
  const auto of_row = within(visit, &TrialRow<L>::row);
  of_row(Column{.name = "time_s", .unit = "s"}, &L::time);
  of_row(Column{.name = "link"}, &L::link);
  of_row(Column{.name = "step_s", .unit = "s"}, &L::step);
  of_row(Column{.name = "impulse_N_s", .unit = "N s"}, &L::impulse);
  of_row(Column{.name = "force_N", .unit = "N"}, &L::force);
  of_row(Column{.name = "length_m", .unit = "m"}, &L::length);
  of_row(Column{.name = "angle_rad", .unit = "rad"}, &L::angle);
  of_row(Column{.name = "energy_J", .unit = "J"}, &L::energy);
  visit_vector(of_row, {"ax_m", "ay_m", "az_m"}, "m", &L::end_a, {});
  visit_vector(of_row, {"bx_m", "by_m", "bz_m"}, "m", &L::end_b, {});
}

template <class Visit>
void visit_series_regions(Visit&& visit) {
  using R = SeriesRegion;
  const auto of_row = within(visit, &TrialRow<R>::row);
  of_row(Column{.name = "time_s", .unit = "s"}, &R::time);
  of_row(Column{.name = "region"}, &R::region);
  of_row(Column{.name = "step_s", .unit = "s"}, &R::step);
  of_row(Column{.name = "bodies"}, &R::bodies);
  for (const RegionQuantity& number : region_quantities)
    of_row(Column{.name = number.column, .unit = number.unit, .in_space = number.in_space}, number.value);
}

template <class Visit>
void visit_series_solves(Visit&& visit) {
  using S = SeriesSolve;
  const auto of_row = within(visit, &TrialRow<S>::row);
  of_row(Column{.name = "time_s", .unit = "s"}, &S::time);
  of_row(Column{.name = "step_s", .unit = "s"}, &S::step);
  of_row(Column{.name = "contacts"}, &S::contacts);
  of_row(Column{.name = "sweeps"}, &S::sweeps);
  of_row(Column{.name = "residual_m_s", .unit = "m/s"}, &S::residual);
}

template <class Visit>
void visit_series_stress(Visit&& visit) {
  using S = SeriesStress;
  const auto of_row = within(visit, &TrialRow<S>::row);
  of_row(Column{.name = "time_s", .unit = "s"}, &S::time);
  of_row(Column{.name = "body"}, &S::body);
  of_row(Column{.name = "strain_J", .unit = "J"}, &S::strain);
  of_row(Column{.name = "vibration_J", .unit = "J"}, &S::vibration);
  of_row(Column{.name = "damped_J", .unit = "J"}, &S::damped);
  of_row(Column{.name = "touch_J", .unit = "J"}, &S::touch);
  of_row(Column{.name = "settled_J", .unit = "J"}, &S::settled);
  of_row(Column{.name = "tension_1pct_Pa", .unit = "Pa"}, &S::tension_1pct);
  of_row(Column{.name = "compression_1pct_Pa", .unit = "Pa"}, &S::compression_1pct);
  of_row(Column{.name = "share_above_strength"}, &S::above_strength);
}

template <class Visit>
void visit_series_nodes(Visit&& visit) {
  using N = SeriesNode;
  const auto of_row = within(visit, &TrialRow<N>::row);
  of_row(Column{.name = "time_s", .unit = "s"}, &N::time);
  of_row(Column{.name = "body"}, &N::body);
  of_row(Column{.name = "node"}, &N::node);
  visit_vector(of_row, {"x_m", "y_m", "z_m"}, "m", &N::place);
  visit_vector(of_row, {"ux_m", "uy_m", "uz_m"}, "m", &N::displacement);
  visit_vector(of_row, {"ux_rate_m_s", "uy_rate_m_s", "uz_rate_m_s"}, "m/s", &N::rate);
}

template <class Visit>
void visit_series_cells(Visit&& visit) {
  using C = SeriesCell;
  const auto of_row = within(visit, &TrialRow<C>::row);
  of_row(Column{.name = "time_s", .unit = "s"}, &C::time);
  of_row(Column{.name = "body"}, &C::body);
  of_row(Column{.name = "cell"}, &C::cell);
  of_row(Column{.name = "a"}, &C::a);
  of_row(Column{.name = "b"}, &C::b);
  of_row(Column{.name = "c"}, &C::c);
  of_row(Column{.name = "d", .in_space = true}, &C::d);
  of_row(Column{.name = "tension_Pa", .unit = "Pa"}, &C::tension);
  of_row(Column{.name = "compression_Pa", .unit = "Pa"}, &C::compression);
}

/// Columns of an Arrival.
template <class Visit>
void visit_arrival(Visit&& visit) {
  using A = Arrival;
  visit(Column{.name = "time_s", .unit = "s"}, &A::time);
  visit(Column{.name = "speed_m_s", .unit = "m/s"}, &A::speed);
  visit(Column{.name = "energy_J", .unit = "J"}, &A::kinetic_energy);
  visit(Column{.name = "height_m", .unit = "m"}, &A::height);
  visit(Column{.name = "along_m", .unit = "m"}, &A::along);
}

template <class Visit>
void visit_gates(Visit&& visit) {
  const auto of_passage = within(visit, &GateRecord::passage);
  of_passage(Column{.name = "gate", .names = NamesOf::gates}, &Passage::gate);
  visit_arrival(of_passage);
}

template <class Visit>
void visit_barriers(Visit&& visit) {
  const auto of_hit = within(visit, &BarrierRecord::hit);
  of_hit(Column{.name = "barrier", .names = NamesOf::barriers}, &BarrierHit::barrier);
  of_hit(Column{.name = "outcome"}, &BarrierHit::outcome);
  visit_arrival(of_hit);
}

template <class Visit>
void visit_trees(Visit&& visit) {
  using T = TreeHit;
  const auto of_hit = within(visit, &TreeRecord::hit);
  of_hit(Column{.name = "tree"}, &T::tree);
  of_hit(Column{.name = "time_s", .unit = "s"}, &T::time);
  of_hit(Column{.name = "energy_before_J", .unit = "J"}, &T::energy_before);
  of_hit(Column{.name = "energy_after_J", .unit = "J"}, &T::energy_after);
  of_hit(Column{.name = "height_m", .unit = "m"}, &T::height);
}

/// Columns of last_states.csv after the point. What it holds is also read back by them.
template <class Visit>
void visit_last_states(Visit&& visit) {
  using R = LastStateRecord;
  using S = LastState;
  visit(Column{.name = "body", .names = NamesOf::groups}, &R::group);
  const auto of_last = within(visit, &R::last);
  of_last(Column{.name = "mass_kg", .unit = "kg"}, &S::mass);
  of_last(Column{.name = "shape"}, &S::shape);
  visit_state(within(of_last, &S::state));
  visit_turn(within(of_last, &S::turn));
}

/// What the rows of a table belong to. It gives their first columns: trial, or trial and rock.
enum class RowOwner { itself, rock, trial };

struct Table {
  const char* name;  ///< in results.db
  Part part;         ///< the part of a chunk file that holds it
  RowOwner owner;
  /// a rock has many rows: results.db finds them by the first and the last (report/tables/record_tables.h)
  const char* many_rows = nullptr;
};

/// The list of tables, in the order of chunk files: see(table, the rows of `records`, visit_columns), where
/// visit_columns(visit) visits the columns without those of the owner.
template <class Records, class See>
void visit_tables(Records& records, See&& see) {
  using enum RowOwner;
  see(Table{"rocks", Part::brief, itself}, records.rocks, [](auto&& visit) { visit_rocks(visit); });
  see(Table{"gates", Part::brief, rock}, records.gates, [](auto&& visit) { visit_gates(visit); });
  see(Table{"barriers", Part::brief, rock}, records.barriers, [](auto&& visit) { visit_barriers(visit); });
  see(Table{"trees", Part::brief, rock}, records.trees, [](auto&& visit) { visit_trees(visit); });
  see(Table{"drawn", Part::whole, rock, "input"}, records.inputs, [](auto&& visit) { visit_inputs(visit); });
  see(Table{"impacts", Part::whole, rock, "impact"}, records.impacts,
      [](auto&& visit) { visit_impacts(visit); });
  see(Table{"trajectories", Part::whole, rock, "trajectory"}, records.trajectories,
      [](auto&& visit) { visit_trajectories(visit); });
  see(Table{"shapes", Part::whole, rock, "shape"}, records.shapes, [](auto&& visit) { visit_shapes(visit); });
  see(Table{"last_states", Part::whole, rock}, records.last_states,
      [](auto&& visit) { visit_last_states(visit); });
  see(Table{"blocks", Part::brief, trial}, records.blocks, [](auto&& visit) { visit_blocks(visit); });
  see(Table{"block_regions", Part::brief, trial}, records.block_regions,
      [](auto&& visit) { visit_block_regions(visit); });
  see(Table{"block_corners", Part::whole, trial}, records.block_corners,
      [](auto&& visit) { visit_block_corners(visit); });
  see(Table{"links", Part::whole, trial}, records.links, [](auto&& visit) { visit_links(visit); });
  see(Table{"fixtures", Part::whole, trial}, records.fixtures, [](auto&& visit) { visit_fixtures(visit); });
  see(Table{"fixture_shapes", Part::whole, trial}, records.fixture_shapes,
      [](auto&& visit) { visit_fixture_shapes(visit); });
  see(Table{"series_bodies", Part::whole, trial}, records.series_bodies,
      [](auto&& visit) { visit_series_bodies(visit); });
  see(Table{"series_contacts", Part::whole, trial}, records.series_contacts,
      [](auto&& visit) { visit_series_contacts(visit); });
  see(Table{"series_links", Part::whole, trial}, records.series_links,
      [](auto&& visit) { visit_series_links(visit); });
  see(Table{"series_regions", Part::whole, trial}, records.series_regions,
      [](auto&& visit) { visit_series_regions(visit); });
  see(Table{"series_solves", Part::whole, trial}, records.series_solves,
      [](auto&& visit) { visit_series_solves(visit); });
  see(Table{"series_stress", Part::whole, trial}, records.series_stress,
      [](auto&& visit) { visit_series_stress(visit); });
  see(Table{"series_nodes", Part::whole, trial}, records.series_nodes,
      [](auto&& visit) { visit_series_nodes(visit); });
  see(Table{"series_cells", Part::whole, trial}, records.series_cells,
      [](auto&& visit) { visit_series_cells(visit); });
}

/// For a walk over the tables alone.
inline const TrialRecords none_of_the_records;

/// Visits the columns that name the owner of the rows of a table.
template <class Row, class Visit>
void visit_owner(const Table& table, Visit&& visit) {
  if (table.owner == RowOwner::itself) return;
  visit(Column{.name = "trial"}, &Row::trial);
  if constexpr (requires { &Row::rock; })
    if (table.owner == RowOwner::rock) visit(Column{.name = "rock"}, &Row::rock);
}

}  // namespace flyrock
