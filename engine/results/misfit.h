#pragma once
// The misfit of a model: the distance of what was measured from all trials of the model together, and the
// same of draws of the model, which says what misfit a true model has.

#include <cstdint>
#include <vector>

#include "results/energy_distance.h"
#include "results/simulated_rows.h"

namespace flyrock {

/// What becomes of rocks that left the domain or still moved.
enum class Censored {
  left_out,
  at_their_end  ///< count where they were last seen, so that no fit gains by losing rocks
};

/// All trials of some rows.
class MisfitPool {
 public:
  /// The number of draws of energies_of_draws().
  static constexpr int draws = 400;

  MisfitPool(std::vector<const SimulatedRow*> rows, bool in_plane, Censored censored);

  bool empty() const { return values_.empty(); }
  double energy_of(const std::vector<Vec2>& observed) const;
  /// Of numbers only: the mean distance of quantiles.
  double quantiles_of(const std::vector<Vec2>& observed) const;
  /// The energy distances of draws of the model from all of it: of each row one of its trials, or, where all
  /// rocks are one row, `count` of them.
  std::vector<double> energies_of_draws(std::size_t count, std::uint64_t seed) const;

 private:
  bool in_plane_;
  std::vector<std::vector<Vec2>> values_;  ///< of each row that has any
  SortedSample line_;
  PlaneSample plane_;
};

/// The energy distance of a model that gives one value.
double energy_of_constant(const std::vector<Vec2>& observed, const Vec2& constant, bool in_plane);

}  // namespace flyrock
