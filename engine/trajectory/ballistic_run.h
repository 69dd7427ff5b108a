#pragma once
// One rock of the method `ballistic`: a point at its centre of mass that flies to the first ground it meets.

#include "trajectory/ballistic.h"
#include "world/body.h"
#include "world/observe.h"

namespace flyrock {

struct BallisticRun {
  Forces<2> forces;
  double start_time = 0, stop_time = 60;  ///< s; the flight lasts stop_time - start_time at most
  double trajectory_every = 0;            ///< s between stored points; 0: none
  double bin_width = 0;                   ///< m, of BodyHistory::path; 0: none is kept
};

/// Flies the body from its place with its velocity and spin. It `stopped` where it met the ground, left the domain, or
/// timed out; what a flight does not have (impacts, contact) is empty.
BodyHistory run_ballistic(const Body<2>& body, const Profile& ground, const BallisticRun& run);

}  // namespace flyrock
