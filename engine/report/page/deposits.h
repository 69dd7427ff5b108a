#pragma once
// Where the rocks of a 3D run ended, for the plan.

#include <Eigen/Geometry>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "record/records.h"

namespace flyrock {

/// The ends of the first rocks, and of some of the others at each distance, whether their paths are stored or
/// not.
class Deposits {
 public:
  /// `most`: how many first rocks at most. Of the others each step of distance has a 500th of it, in the
  /// order in which they come, so that also the places where few rocks come are drawn, and the farthest one.
  explicit Deposits(std::size_t most) : most_first_(most), most_at_distance_(most / 500) {}

  /// Takes the chunks in order.
  void add(const TrialRecords& chunk);

  /// { x, y, z, trial, rock, group, reason, count, far, extent }: a column each, the first rocks, then `far`
  /// others; x, y, z are differences in thousandths, `trial` differences. `count` is that of all rocks
  /// without faults, `extent` is x and y of the least corner and of the greatest of the rectangle that holds
  /// the ends of all rocks; null without rocks.
  nlohmann::ordered_json data() const;

 private:
  struct End {
    Vec3 place;
    std::uint64_t trial;
    int rock, group;
    StopReason reason;
    double runout;
  };

  std::size_t most_first_, most_at_distance_;
  std::uint64_t count_ = 0;
  Eigen::AlignedBox2d extent_;
  std::vector<End> first_, others_;
  std::map<int, std::size_t> at_distance_;  ///< how many of `others_`, by step of distance
  std::optional<End> farthest_;             ///< of those that are in neither
};

}  // namespace flyrock
