#pragma once
// Where censored rocks were when their paths were cut short: the part that they rolled on when time ran out,
// or the end at which they left the domain.

#include <cstdint>
#include <vector>

#include "record/records.h"

namespace flyrock {

/// Rocks that were censored for the same reason in the same place.
struct CensoredPlace {
  StopReason reason = StopReason::timed_out;
  int part = -1;  ///< part of the terrain that they were on when time ran out; -1: they were in the air, or
                  ///< left the domain
  bool ahead = true;  ///< at larger x than their release: the right one of the two ends of a domain
  std::uint64_t rocks = 0;
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();  ///< m, box of their centres of mass

  bool same_place(const CensoredPlace& other) const;
  void add(const CensoredPlace& other);
};

/// Counts censored rocks by place in one pass. There are only as many places as parts, so a million rocks
/// take no more memory than a thousand.
class CensoredTally {
 public:
  void add(const RockRecord& rock);
  /// The places, most rocks first.
  std::vector<CensoredPlace> places() const;

 private:
  std::vector<CensoredPlace> places_;
};

/// The places of several sweep points together.
std::vector<CensoredPlace> joined(const std::vector<std::vector<CensoredPlace>>& points);

}  // namespace flyrock
