#pragma once
// The misfit of a model: the distance of what was measured from all trials of the model together, and the
// same of draws of the model, which says what misfit a true model has.

#include <cstdint>
#include <limits>
#include <vector>

#include "results/compare/simulated_rows.h"
#include "results/statistics/energy_distance.h"

namespace flyrock {

/// What becomes of rocks that left the domain or still moved.
enum class Censored {
  left_out,
  at_their_end  ///< count where they were last seen, so that no fit gains by losing rocks
};

/// The mean distance E|x - Y| from the values of a pool, over the line or the plane, as a table in little
/// memory: linear between 1024 places of a line, or 64 x 64 of the plane. Where the values end, it goes on as
/// the distance from their mean.
class DistanceTable {
 public:
  DistanceTable() = default;
  template <class Sample>
  explicit DistanceTable(const Sample& sample);

  /// 2 E|X - Y| - E|Y - Y'|: the energy distance of values X from the pool, but for E|X - X'|, which is the
  /// same for all pools.
  double partial_energy(const std::vector<Vec2>& values) const;

 private:
  double at(const Vec2& x) const;

  Vec2 low_ = Vec2::Zero(), step_ = Vec2::Zero(), per_step_ = Vec2::Zero(), mean_ = Vec2::Zero();
  int columns_ = 2, rows_ = 1;
  double own_ = -std::numeric_limits<double>::infinity();  ///< of no values: infinitely far from all
  std::vector<double> distances_ = {0, 0};
};

/// All trials of some rows.
class MisfitPool {
 public:
  /// The number of draws.
  static constexpr int draws = 400;

  MisfitPool(std::vector<const SimulatedRow*> rows, bool in_plane, Censored censored);

  bool empty() const { return values_.empty(); }
  double energy_of(const std::vector<Vec2>& observed) const;
  /// The mean distance of quantiles, for numbers only.
  double quantiles_of(const std::vector<Vec2>& observed) const;
  /// Draws of the model: of each row one of its trials, or, where all rocks are one row, `count` of them.
  std::vector<std::vector<Vec2>> drawn(std::size_t count, std::uint64_t seed) const;
  /// The energy distances of these draws from all of the model.
  std::vector<double> energies_of_draws(std::size_t count, std::uint64_t seed) const;
  DistanceTable table() const { return in_plane_ ? DistanceTable(plane_) : DistanceTable(line_); }

 private:
  bool in_plane_;
  std::vector<std::vector<Vec2>> values_;  ///< of each row that has any
  SortedSample line_;
  PlaneSample plane_;
};

/// The energy distance of a model that gives one value.
double energy_of_constant(const std::vector<Vec2>& observed, const Vec2& constant, bool in_plane);

}  // namespace flyrock
