#include "results/compare/calibration.h"

#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <memory>

namespace flyrock {

namespace {

/// Points along each number; with more numbers fewer.
constexpr int coarse_steps[] = {32, 12, 6};  // divide the lattice
constexpr int fine_steps[] = {32, 10, 4};

constexpr double region_probability = 0.9;
constexpr int rough_draws = 80;  ///< of the region about which the finer grid lies

std::vector<int> spread(int low, int high, int steps) {
  std::vector<int> places;
  for (int i = 0; i <= steps; ++i) {
    const int place = low + static_cast<int>(std::lround(static_cast<double>(high - low) * i / steps));
    if (places.empty() || places.back() != place) places.push_back(place);
  }
  return places;
}

/// All points of a grid, the last number fastest.
std::vector<LatticePoint> grid_of(const std::vector<std::vector<int>>& axes) {
  std::vector<LatticePoint> points{{}};
  for (const std::vector<int>& axis : axes) {
    std::vector<LatticePoint> longer;
    for (const LatticePoint& point : points)
      for (const int place : axis) {
        longer.push_back(point);
        longer.back().push_back(place);
      }
    points = std::move(longer);
  }
  return points;
}

class Calibrating {
 public:
  Calibrating(std::size_t numbers, const CalibratedModel& model, int search_evaluations)
      : numbers_(numbers), model_(model), search_evaluations_(search_evaluations) {}

  Calibration result() {
    stage_ = "grid";
    const std::vector<std::vector<int>> coarse(numbers_, spread(0, lattice, coarse_steps[numbers_ - 1]));
    for (const LatticePoint& point : grid_of(coarse)) at(point);
    stage_ = "search";
    search();
    stage_ = "region";
    judge_points(rough_draws);
    const std::vector<std::vector<int>> fine = axes_about_region(lattice / coarse_steps[numbers_ - 1]);
    for (const LatticePoint& point : grid_of(fine)) at(point);
    result_.coarse = coarse.front();
    result_.fine = fine.front();
    find_best();
    judge_points(MisfitPool::draws);
    find_region(fine);
    correlate(fine);
    return std::move(result_);
  }

 private:
  const Evaluation& at(const LatticePoint& point) {
    const auto known = index_.find(point);
    if (known != index_.end()) return result_.evaluations[known->second];
    Evaluation evaluation = model_.evaluate(point);
    evaluation.at = point;
    evaluation.stage = stage_;
    index_[point] = result_.evaluations.size();
    result_.evaluations.push_back(std::move(evaluation));
    return result_.evaluations.back();
  }

  void find_best() {
    const auto less = [](const Evaluation& a, const Evaluation& b) {
      return a.misfit != b.misfit ? a.misfit < b.misfit : a.at < b.at;
    };
    result_.best = *std::min_element(result_.evaluations.begin(), result_.evaluations.end(), less);
    result_.on_bound.clear();
    for (const int place : result_.best.at) result_.on_bound.push_back(end_at(place) != WayEnd::none);
  }

  // The search.

  static double ask(unsigned count, const double* x, double*, void* self) {
    auto& calibrating = *static_cast<Calibrating*>(self);
    if (calibrating.error_) return 0;
    LatticePoint point;
    for (unsigned i = 0; i < count; ++i)
      point.push_back(std::clamp(static_cast<int>(std::lround(x[i])), 0, lattice));
    try {
      return calibrating.at(point).misfit;
    } catch (...) {  // must not pass through the library
      calibrating.error_ = std::current_exception();
      nlopt_force_stop(calibrating.optimiser_.get());
      return 0;
    }
  }

  void search() {
    find_best();
    const auto count = static_cast<unsigned>(numbers_);
    optimiser_.reset(nlopt_create(NLOPT_LN_SBPLX, count));
    nlopt_set_lower_bounds1(optimiser_.get(), 0);
    nlopt_set_upper_bounds1(optimiser_.get(), lattice);
    nlopt_set_min_objective(optimiser_.get(), ask, this);
    nlopt_set_initial_step1(optimiser_.get(), 0.5 * lattice / coarse_steps[numbers_ - 1]);
    nlopt_set_xtol_abs1(optimiser_.get(), 0.5);
    nlopt_set_maxeval(optimiser_.get(), search_evaluations_);
    std::vector<double> x(result_.best.at.begin(), result_.best.at.end());
    double least = 0;
    nlopt_optimize(optimiser_.get(), x.data(), &least);
    if (error_) std::rethrow_exception(error_);
  }

  // The region.

  /// The 90 % quantile, over draws of a point, of the energy distance from it less the least one of all
  /// points.
  double difference_p90(const Evaluation& point, int draws) const {
    std::vector<double> differences;
    for (const std::vector<Vec2>& draw : model_.draws(point.at)) {
      if (static_cast<int>(differences.size()) == draws) break;
      double least = point.table.partial_energy(draw);
      const double own = least;
      for (const Evaluation& other : result_.evaluations)
        least = std::min(least, other.table.partial_energy(draw));
      differences.push_back(own - least);
    }
    return SortedSample(std::move(differences)).quantile(region_probability);
  }

  double least_energy() const {
    double least = infinite;
    for (const Evaluation& evaluation : result_.evaluations) least = std::min(least, evaluation.energy);
    return least;
  }

  /// Which points are inside. The difference of a draw is at most its energy distance: a point whose own
  /// difference is above the quantile of these is outside, and takes no time.
  void judge_points(int draws) {
    const double least = least_energy();
    result_.agrees = false;
    for (Evaluation& evaluation : result_.evaluations) {
      const double difference = evaluation.energy - least;
      const bool may_be_inside = difference <= evaluation.noise_p90;
      evaluation.difference_p90 = may_be_inside ? difference_p90(evaluation, draws) : unknown;
      evaluation.is_inside = difference == 0 || difference <= evaluation.difference_p90;
      result_.agrees = result_.agrees || evaluation.agrees();
    }
  }

  /// A finer grid about the points that are inside, and the best one.
  std::vector<std::vector<int>> axes_about_region(int step) {
    find_best();
    std::vector<std::vector<int>> axes;
    for (std::size_t k = 0; k < numbers_; ++k) {
      int low = result_.best.at[k], high = low;
      for (const Evaluation& evaluation : result_.evaluations)
        if (evaluation.is_inside) {
          low = std::min(low, evaluation.at[k]);
          high = std::max(high, evaluation.at[k]);
        }
      axes.push_back(
          spread(std::max(0, low - step), std::min(lattice, high + step), fine_steps[numbers_ - 1]));
    }
    return axes;
  }

  /// By how much a point is outside; at most 0 inside.
  double excess(const Evaluation& point) const {
    const double most =
        std::isnan(point.difference_p90) ? difference_p90(point, MisfitPool::draws) : point.difference_p90;
    return point.energy - least_energy() - most;
  }

  /// The range of each number over the points inside, and where the excess vanishes on the way to a neighbour
  /// on the finer grid that is outside.
  void find_region(const std::vector<std::vector<int>>& fine) {
    std::vector<RegionRange> ranges(numbers_, {.low = 2, .high = -1});
    for (const Evaluation& evaluation : result_.evaluations) {
      if (!evaluation.is_inside) continue;
      result_.inside.push_back(evaluation.at);
      for (std::size_t k = 0; k < numbers_; ++k) widen(ranges[k], evaluation.at[k]);
    }
    for (std::size_t k = 0; k < numbers_; ++k)
      for (const LatticePoint& point : grid_of(fine)) {
        const Evaluation& here = result_.evaluations[index_.at(point)];
        if (!here.is_inside) continue;
        const auto place = std::find(fine[k].begin(), fine[k].end(), point[k]);
        if (place != fine[k].begin()) widen_towards(ranges[k], here, k, *(place - 1));
        if (place + 1 != fine[k].end()) widen_towards(ranges[k], here, k, *(place + 1));
      }
    for (RegionRange& range : ranges) {
      range.is_open_below = range.low <= 0;
      range.is_open_above = range.high >= 1;
    }
    result_.region = std::move(ranges);
  }

  static void widen(RegionRange& range, double place) {
    range.low = std::min(range.low, place / lattice);
    range.high = std::max(range.high, place / lattice);
  }

  void widen_towards(RegionRange& range, const Evaluation& here, std::size_t k, int neighbour) {
    LatticePoint point = here.at;
    point[k] = neighbour;
    const Evaluation& there = result_.evaluations[index_.at(point)];
    if (there.is_inside) return;
    const double of_here = std::min(0.0, excess(here)), of_there = excess(there);
    if (!(of_there > 0)) return;
    const double share = of_here / (of_here - of_there);
    widen(range, here.at[k] + share * (neighbour - here.at[k]));
  }

  /// Correlates the numbers over the points of the finer grid that are inside.
  void correlate(const std::vector<std::vector<int>>& fine) {
    constexpr std::size_t least = 5;
    std::vector<LatticePoint> points;
    for (const LatticePoint& point : grid_of(fine))
      if (result_.evaluations[index_.at(point)].is_inside) points.push_back(point);
    if (points.size() < least) return;
    std::vector<double> mean(numbers_, 0.0);
    for (const LatticePoint& point : points)
      for (std::size_t k = 0; k < numbers_; ++k) mean[k] += point[k] / static_cast<double>(points.size());
    std::vector<std::vector<double>> sums(numbers_, std::vector<double>(numbers_, 0.0));
    for (const LatticePoint& point : points)
      for (std::size_t a = 0; a < numbers_; ++a)
        for (std::size_t b = 0; b < numbers_; ++b) sums[a][b] += (point[a] - mean[a]) * (point[b] - mean[b]);
    for (std::size_t a = 0; a < numbers_; ++a)
      if (sums[a][a] == 0) return;
    std::vector<std::vector<double>> correlation = sums;
    for (std::size_t a = 0; a < numbers_; ++a)
      for (std::size_t b = 0; b < numbers_; ++b)
        correlation[a][b] = a == b ? 1 : sums[a][b] / std::sqrt(sums[a][a] * sums[b][b]);
    result_.correlation = std::move(correlation);
  }

  struct Destroy {
    void operator()(nlopt_opt optimiser) const { nlopt_destroy(optimiser); }
  };

  const std::size_t numbers_;
  const CalibratedModel& model_;
  const int search_evaluations_;
  std::string stage_;
  std::map<LatticePoint, std::size_t> index_;  ///< of Calibration::evaluations
  std::unique_ptr<nlopt_opt_s, Destroy> optimiser_;
  std::exception_ptr error_;
  Calibration result_;
};

}  // namespace

WayEnd end_at(int place) {
  constexpr int near = lattice / 100;
  if (place <= near) return WayEnd::low;
  if (place >= lattice - near) return WayEnd::high;
  return WayEnd::none;
}

bool Calibration::any_on_bound() const {
  return std::find(on_bound.begin(), on_bound.end(), true) != on_bound.end();
}

Calibration calibrate(std::size_t numbers, const CalibratedModel& model, int search_evaluations) {
  return Calibrating(numbers, model, search_evaluations).result();
}

std::size_t coarse_points(std::size_t numbers) {
  std::size_t points = 1;
  for (std::size_t k = 0; k < numbers; ++k) points *= static_cast<std::size_t>(coarse_steps[numbers - 1] + 1);
  return points;
}

}  // namespace flyrock
