#pragma once
// Where the rocks of a point were: the piece of the terrain that its pictures show.

#include <Eigen/Geometry>

#include "record/records.h"

namespace flyrock {

/// Collects places of rocks without faults: releases, ends and stored paths.
class PlanReach {
 public:
  void add(const TrialRecords& chunk);

  bool empty() const { return count_ == 0; }
  /// The rectangle in plan that holds the places, with a margin of a tenth of their greatest extent [m].
  Eigen::AlignedBox2d window() const;
  /// The line in plan through the mean release towards the mean end. It is long enough for all places.
  struct Line {
    Vec2 release;     ///< mean
    Vec2 direction;   ///< unit; +x if the rocks ended where they began
    double from, to;  ///< m from `release`, over the window
  };
  Line mean_line() const;

 private:
  Eigen::AlignedBox3d box_;
  std::uint64_t count_ = 0;
  Vec2 releases_ = Vec2::Zero(), ends_ = Vec2::Zero();  ///< sums, from the first release
  Vec2 first_ = Vec2::Zero();
};

}  // namespace flyrock
