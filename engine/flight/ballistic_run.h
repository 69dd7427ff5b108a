#pragma once
// One rock of the method `ballistic`: a point at its centre of mass that flies until it first touches the
// ground.

#include "flight/ballistic.h"
#include "world/body.h"
#include "world/places.h"

namespace flyrock {

template <int D>
struct BallisticRun {
  Forces<D> forces;
  /// s; a flight whose start_time is later than its stop_time is timed out at its start
  double start_time = 0, stop_time = 60;
  double trajectory_every = 0;  ///< s between stored points; 0: none
  double bin_width = 0;         ///< m, of BodyHistory::path; 0: no bins are kept; 2D only
  std::span<const Gate> gates;
  std::span<const Barrier> barriers;
};

/// Flies the body from its position with its velocity and spin. The run ends as `stopped` at the ground, as
/// `caught` at a barrier, as `left_domain` or as `timed_out`. Records that a flight does not have (impacts,
/// contact) are empty. The ground is a Profile in 2D and a Ground3 in 3D.
template <int D, class Ground>
BodyHistory run_ballistic(const Body<D>& body, const Ground& ground, const BallisticRun<D>& run);

}  // namespace flyrock
