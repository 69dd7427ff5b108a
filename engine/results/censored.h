#pragma once
// Where censored rocks were when their paths were cut short: on what they rolled when time was up, where they
// left the domain.

#include <cstdint>
#include <vector>

#include "batch/records.h"

namespace flyrock {

/// Rocks that were cut short for one reason in one place.
struct CensoredPlace {
  StopReason reason = StopReason::timed_out;
  int part = -1;  ///< of the terrain, on which they were when time was up; -1: they were in the air, or left
                  ///< the domain
  bool ahead = true;  ///< beyond their release along x: of the two ends of a domain the right one
  std::uint64_t rocks = 0;
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();  ///< m, the box of their centres of mass

  bool same_place(const CensoredPlace& other) const;
  void add(const CensoredPlace& other);
};

/// Adds them up in a pass; there are as many places as parts, so that they take no more room for a million
/// rocks than for a thousand.
class CensoredTally {
 public:
  void see(const RockRecord& rock);
  /// Those with most rocks first.
  std::vector<CensoredPlace> places() const;

 private:
  std::vector<CensoredPlace> places_;
};

/// The places of several points together.
std::vector<CensoredPlace> joined(const std::vector<std::vector<CensoredPlace>>& points);

}  // namespace flyrock
