#pragma once
// Whether a fitted model predicts a group of rocks that it has not seen better than the distances of the
// other groups do.
//
// With the measured values X of the held group, all trials Y of its rocks in the model, and the measured
// values O of the rocks of the fit, the skill is D(X, Y) - D(X, O), with the energy distance D: below 0 the
// model is nearer. E|X - X'| is in both and cancels, so that
//   difference = mean over X of 2 (E|x - Y| - E|x - O|) - E|Y - Y'| + E|O - O'|,
// where E|O - O'| is the mean over pairs of different rows: with few rows, that over all pairs would make the
// other groups look worse than they are. The 95 % interval is that of the percentiles of 1,000 bootstraps,
// which draw rows of X and rows of O: with those of X alone, a model that knows nothing of the group has
// skill in half of all cases, by the chance of which rows O has.

#include <cstdint>
#include <string>
#include <vector>

#include "results/compare/simulated_rows.h"
#include "results/statistics/statistics.h"
#include "results/statistics/unknown.h"

namespace flyrock {

struct Skill {
  double difference = unknown;  ///< m; NaN: one of the samples has fewer than two values
  Interval interval{unknown, unknown};

  bool is_known() const { return interval.upper == interval.upper; }
  bool has_skill() const { return interval.upper < 0; }
  bool is_worse() const { return interval.lower > 0; }
  /// "skill", or "no skill" where the interval holds 0 or lies above it.
  const char* verdict() const { return has_skill() ? "skill" : "no skill"; }
};

/// Compares values in the plane, or numbers in x. Of more than 1,000 rows or 4,000 values of the model every
/// k-th counts.
Skill skill_of(const std::vector<Vec2>& held, const std::vector<Vec2>& model, const std::vector<Vec2>& others,
               bool in_plane, std::uint64_t seed);

/// What was measured of some rows: distances, or of places the ways from the start of each row, so that
/// groups from other places can be compared.
std::vector<Vec2> measured_ways(const ObservedPlan& plan, const SimulatedRows& simulated,
                                const std::vector<std::size_t>& rows);
/// The same of all trials of these rows; rocks that left count where they were last seen.
std::vector<Vec2> simulated_ways(const ObservedPlan& plan, const SimulatedRows& simulated,
                                 const std::vector<std::size_t>& rows);

/// "predicted worse than by the distances of the other groups: ..."; "the model predicts it better ...".
std::string skill_text(const Skill& skill, const std::string& held_name);

}  // namespace flyrock
