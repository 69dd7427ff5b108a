#pragma once
// Where the rocks of a 3D run ended, for the plan.

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "record/records.h"

namespace flyrock {

/// The ends of the first rocks, whether their paths are stored or not.
class Deposits {
 public:
  explicit Deposits(std::size_t most) : most_(most) {}

  /// Takes the chunks in order.
  void add(const TrialRecords& chunk);

  /// { x, y, z, trial, rock, group, reason, count }: a column each; x, y, z are differences in thousandths,
  /// `trial` differences, `count` is that of all rocks without faults.
  nlohmann::ordered_json data() const;

 private:
  struct End {
    Vec3 place;
    std::uint64_t trial;
    int rock, group;
    StopReason reason;
  };
  std::size_t most_;
  std::uint64_t count_ = 0;
  std::vector<End> ends_;
};

}  // namespace flyrock
