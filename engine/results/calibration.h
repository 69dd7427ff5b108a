#pragma once
// Finds the values of one to three numbers with which a model agrees best with what was measured, and the
// region of values that the measurements do not exclude.
//
// The numbers are varied on a lattice of `lattice` steps from their least to their greatest value: first on a
// coarse grid, then by NLopt (Sbplx, which needs no derivative) from the best point of it, then on a finer
// grid about the region. All points use the same random numbers, so the misfit is a function of the point.
//
// Region: a point is inside if the energy distance of what was measured from its trials is at most the 90 %
// quantile of the energy distances of 400 draws of these trials themselves. So it holds a true point with a
// probability of 90 %.

#include <functional>
#include <optional>
#include <string>
#include <vector>

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
  double noise_p90 = 0;  ///< of the draws of its own trials [m]
  std::string stage;     ///< "grid", "search" or "region"

  bool is_inside() const { return energy <= noise_p90; }
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
  std::optional<std::vector<RegionRange>> region;  ///< absent: no point agrees with what was measured
  std::vector<LatticePoint> inside;                ///< points of the region
  std::optional<std::vector<std::vector<double>>> correlation;  ///< of the numbers over them; absent: too few
  std::vector<bool> on_bound;     ///< of each number: the best point is at an end of its way
  std::vector<int> coarse, fine;  ///< lattice coordinates of the two grids of the first number

  bool any_on_bound() const;
};

/// Asks `evaluate` for at most some hundred points, each once. It may throw, which ends the search.
Calibration calibrate(std::size_t numbers, const std::function<Evaluation(const LatticePoint&)>& evaluate,
                      int search_evaluations);

/// The number of points of the coarse grid, for progress.
std::size_t coarse_points(std::size_t numbers);

}  // namespace flyrock
