#pragma once
// One rock of the method `ballistic`: a point at its centre of mass that flies to the first ground it meets.

#include "flight/ballistic.h"
#include "world/body.h"
#include "world/places.h"

namespace flyrock {

template <int D>
struct BallisticRun {
  Forces<D> forces;
  double start_time = 0,
         stop_time = 60;  ///< s; a flight that would start later than it stops is timed out where it stands
  double trajectory_every = 0;  ///< s between stored points; 0: none
  double bin_width = 0;         ///< m, of BodyHistory::path; 0: none is kept; 2D
  std::span<const Gate> gates;
  std::span<const Barrier> barriers;
};

/// Flies the body from its place with its velocity and spin. It `stopped` where it met the ground, was caught
/// by a barrier, left the domain, or timed out; what a flight does not have (impacts, contact) is empty. The
/// ground is a Profile in 2D and a Plane in 3D.
template <int D, class Ground>
BodyHistory run_ballistic(const Body<D>& body, const Ground& ground, const BallisticRun<D>& run);

}  // namespace flyrock
