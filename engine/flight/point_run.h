#pragma once
// One rock as a point at its centre of mass: the methods `ballistic` and `lumped_mass`.

#include "flight/any_run.h"
#include "flight/point_contact.h"
#include "record/plan_cells.h"
#include "world/body.h"

namespace flyrock {

/// A ballistic run is a lumped mass that ends at its first touch of the ground.
template <int D>
struct PointRun : AnyRun {
  Forces<D> forces;
  double start_time = 0;       ///< s
  PlanCells* cells = nullptr;  ///< where the path is recorded for maps; null: nowhere; 3D only
  DrawKey key;                 ///< of the draws of the rock, for trees

  bool ends_at_touch = true;        ///< all below, and stop_speed and keep_impacts, are of a run that goes on
  double rest_speed = 0.02;         ///< m/s; an approach that is not faster has no restitution
  bool keep_extremes = true;        ///< of each component of the state, BodyHistory::min and max
  Vec<D> origin = Vec<D>::Zero();   ///< from where the engine counts, for the laws [m]
  std::span<PairLaws* const> laws;  ///< of each part of the terrain; null: no laws
  SolverQuality* quality = nullptr;  ///< where impacts and gains of energy are counted; may be null
};

/// Moves the body from its position with its velocity. Its spin counts only in a run that ends at the first
/// touch, where the body turns freely; a lumped mass has none.
///
/// The run ends as `caught` at a barrier or a tree, as `left_domain` or as `timed_out`. With `ends_at_touch`
/// it ends as `stopped` at the ground. Otherwise:
///   - An approach to a face that is faster than rest_speed is an impact: of the face or of a tilted one
///     (Roughness), by the restitution and friction of its material (solver/point_impact.h).
///   - A slower approach puts the point on the face, with friction. It then slides (flight/slide.h) while
///     gravity and air press it to the face, over flat and concave edges. At a convex edge it leaves on its
///     parabola. If two faces carry it, it slides along their common edge; in 2D it rests.
///   - It stops as bodies do (flight/rest.h).
///   - It ends as `diverged` if it is below the ground, has energy from nowhere, a state that is not finite,
///     or 10,000 events without progress.
/// Throws TrialError and Interrupted.
template <int D>
BodyHistory run_point(const Body<D>& body, const typename Geometry<D>::Terrain& terrain,
                      const PointRun<D>& run);

}  // namespace flyrock
