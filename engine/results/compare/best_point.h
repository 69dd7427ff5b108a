#pragma once
// Which point of a sweep is the best: the one with the least number of those that keep the limits (`answer`).

#include <string>
#include <vector>

#include "results/measured/measures.h"

namespace flyrock {

struct Plan;

/// A measure at a point, with its interval.
struct AskedNumber {
  Measured measured;
  Interval interval{unknown, unknown};
  bool holds = true;          ///< it keeps its limit; of the measure that is least: it is known
  double short_by = unknown;  ///< by how much it does not keep the limit
};

struct BestPoint {
  struct Point {
    AskedNumber least;
    std::vector<AskedNumber> limits;  ///< in the order of AnswerPlan::limits

    bool holds() const;
  };
  std::vector<Point> points;
  std::vector<std::size_t> best;  ///< none: no point keeps the limits; several: they are equal
};

/// Whether a measure is a share of rocks or trials, which people read in percent.
bool is_share(const std::string& measure);

BestPoint find_best_point(const Plan& plan, const std::vector<PointResult>& points);

/// "Least rocks.runout.p95 such that gate.road.passed below 5 %: point 2 (height 3 m), with 12.3 m (95 %
/// interval 11.8 m to 12.9 m); 4 of 6 points can be chosen. ", "...: none of 6 points. ", "...: a tie of ..."
std::string best_point_text(const Plan& plan, const BestPoint& best);
/// Why a point is not the best: "barrier.fence.past.per_trial is 7.2 % (95 % interval ...), 2.2 % too much".
/// Empty if it keeps the limits.
std::string short_text(const Plan& plan, const BestPoint::Point& point);

}  // namespace flyrock
