#pragma once
// Finds the values of one to three numbers with which a model agrees best with what was measured, and the
// region of values that the measurements do not exclude.
//
// The numbers are varied on a lattice of `lattice` steps from their least to their greatest value: first on a
// coarse grid, then by NLopt (Sbplx, which needs no derivative) from the best point of it, then on a finer
// grid about the region. All points use the same random numbers, so the misfit is a function of the point.
//
// Region: a point is inside if its energy distance from what was measured, less the least one of all points,
// is at most the 90 % quantile of the same difference of 400 draws of its own trials, as if each was
// measured. So it holds a true point with a probability of 90 %, and it is never empty: it compares points,
// and says nothing of the form of the model. That is judged by the energy distance itself: no point agrees if
// it is above the 90 % quantile of that of its own draws at each of them.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "results/compare/misfit.h"
#include "results/statistics/unknown.h"

namespace flyrock {

inline constexpr int lattice = 960;  ///< steps of a number; a coarse grid's step is a whole number of them

/// A place on the lattice: of each number from 0 to `lattice`.
using LatticePoint = std::vector<int>;

/// Which end of its way a best point is at. Within a hundredth of the way counts as the end: the misfit of a
/// simulation is not smooth, so where a model is best beyond an end, the least misfit is found near it.
enum class WayEnd { none, low, high };
WayEnd end_at(int place);

/// What is known of one point.
struct Evaluation {
  LatticePoint at;
  double misfit = 0;     ///< what is made least
  double energy = 0;     ///< energy distance of what was measured [m]
  double noise_p90 = 0;  ///< of the energy distances of the draws of its own trials [m]
  DistanceTable table;   ///< of its trials
  std::string stage;     ///< "grid", "search" or "region"

  bool is_inside = false;           ///< the region
  double difference_p90 = unknown;  ///< m, up to which it is inside; NaN: far outside

  /// Its trials may have been what was measured.
  bool agrees() const { return energy <= noise_p90; }
};

/// A model that is fitted. Both functions may throw, which ends the search.
struct CalibratedModel {
  std::function<Evaluation(const LatticePoint&)> evaluate;
  /// Draws of the trials of a point (MisfitPool::drawn).
  std::function<std::vector<std::vector<Vec2>>(const LatticePoint&)> draws;
};

/// The range of one number in the region, in shares of its way from its least to its greatest value.
struct RegionRange {
  double low = 0, high = 1;
  bool is_open_below = false, is_open_above = false;  ///< the region touches an end of the way

  /// The measurements say little about a number whose region has most of its way, or both of its ends.
  bool is_determined() const { return !(is_open_below && is_open_above) && high - low < most_undetermined; }
  static constexpr double most_undetermined = 0.8;
};

struct Calibration {
  std::vector<Evaluation> evaluations;  ///< each point once, in the order in which they were asked for
  Evaluation best;
  std::vector<RegionRange> region;                              ///< of each number
  std::vector<LatticePoint> inside;                             ///< points of the region
  bool agrees = false;                                          ///< some point agrees with what was measured
  std::optional<std::vector<std::vector<double>>> correlation;  ///< of the numbers over them; absent: too few
  std::vector<bool> on_bound;     ///< of each number: the best point is at an end of its way
  std::vector<int> coarse, fine;  ///< lattice coordinates of the two grids of the first number

  bool any_on_bound() const;
};

/// Evaluates at most some hundred points, each once.
Calibration calibrate(std::size_t numbers, const CalibratedModel& model, int search_evaluations);

/// The number of points of the coarse grid, for progress.
std::size_t coarse_points(std::size_t numbers);

}  // namespace flyrock
