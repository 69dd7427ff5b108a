#pragma once
// What a run records of each body: its states, impacts and extremes.

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "math/space.h"
#include "record/path_bins.h"

namespace flyrock {

/// The state of a body at one time, in SI units. Components that do not exist in 2D are 0 there.
struct BodyState {
  double time = 0;
  Vec3 position = Vec3::Zero();  ///< of the centre of mass
  Vec3 velocity = Vec3::Zero();
  Vec3 spin = Vec3::Zero();   ///< rad/s, world frame; (0, 0, w) in 2D
  double angle = 0;           ///< rad, 2D, counted through full turns
  double kinetic_energy = 0;  ///< J
};

/// An impact of one manifold. A manifold is the set of contacts of one pair of bodies whose normals lie
/// within 15 degrees; the whole terrain counts as one body. Impulses and energies are sums over the contacts.
/// Place and velocities are means weighted by the normal impulse.
struct Impact {
  int body = 0;
  int other = -1;  ///< the other body, -1 for the terrain
  int part = -1;   ///< of the terrain
  int number = 0;  ///< of this body, from 1
  double time = 0;
  Vec3 place = Vec3::Zero();
  double vn_before = 0, vn_after = 0;
  double vt_before = 0, vt_after = 0;  ///< signed in 2D: t = (n_y, -n_x)
  double pn = 0, pt = 0;               ///< N s
  double energy_change = 0;            ///< J
  int count = 1;                       ///< of the impacts that are summed here (BodyLog::struck)
  /// rad, of a point on rough ground: of its face along the motion, and in 3D across it (Roughness)
  std::array<double, 2> tilt = {};
};

/// Adds a later impact of the same pair: impulses and energies are summed, places and velocities are means
/// weighted by the normal impulse. Time and number stay those of the first.
void add(Impact& sum, const Impact& later);

struct Apex {
  double time = 0;
  double height = 0;  ///< m, of the centre of mass above its position at the first contact
};

enum class StopReason { stopped, left_domain, timed_out, caught, diverged, plugin_error, not_started };
inline constexpr std::size_t stop_reasons = 7;
const char* name_of(StopReason reason);

/// The arrival of a body's centre of mass at a gate or barrier; see flight/crossing.h.
struct Arrival {
  double time = 0;
  double speed = 0;           ///< m/s
  double kinetic_energy = 0;  ///< J
  double height = 0;          ///< m above the ground there
  double along = 0;           ///< m along the line of the gate or barrier; y where it stands across x
};

struct Passage : Arrival {
  int gate = 0;
};

enum class BarrierOutcome { caught, over_top, over_energy };
const char* name_of(BarrierOutcome outcome);

/// Speed and energy are those before the barrier acts.
struct BarrierHit : Arrival {
  int barrier = 0;
  BarrierOutcome outcome = BarrierOutcome::caught;
};

/// A body hits a tree (world/tree_law.h).
struct TreeHit {
  int tree = 0;  ///< index of the stem
  double time = 0;
  double energy_before = 0, energy_after = 0;  ///< kinetic, J
  double height = 0;                           ///< m, of the centre of mass above the foot of the stem
};

/// How a body travels.
///  - flight: in the air until it first lands on the terrain. A contact at its release does not count as
///    landing, and neither does a contact with another body.
///  - bounce: in the air after that.
///  - roll: in contact, and every contact sticks or slips slower than a twentieth of the body's speed.
///  - slide: in contact otherwise.
enum class TravelMode { flight, bounce, slide, roll };
inline constexpr std::array<const char*, 4> travel_mode_names = {"flight", "bounce", "slide", "roll"};

/// Time [s] and path length of the centre of mass [m] in each mode, indexed by TravelMode.
struct Travel {
  std::array<double, 4> time{}, distance{};
  void add(TravelMode mode, double dt, double length) {
    time[static_cast<int>(mode)] += dt;
    distance[static_cast<int>(mode)] += length;
  }
};

/// One stored point of a trajectory.
struct TrajectoryPoint {
  BodyState state;
  TravelMode mode = TravelMode::flight;  ///< the mode in which the body arrived at this point
  /// 3D: the attitude as a unit quaternion w, x, y, z that maps the body's frame to the world. In 2D the
  /// angle of the state is the attitude.
  std::array<double, 4> turn = {1, 0, 0, 0};
};

struct BodyHistory {
  BodyState first, last;
  BodyState min, max;  ///< extremes of each component over the run, flights included
  double min_speed = 0, max_speed = 0;
  StopReason reason = StopReason::timed_out;
  std::string fault;  ///< why the body diverged, which plugin failed, or which side of the terrain it left
  double stop_time = std::numeric_limits<double>::quiet_NaN();  ///< start of the 0.2 s at rest
  double contact_time = 0;                                      ///< s spent in contact
  double max_distance = 0;                                      ///< m, greatest |x - x_first| ever reached
  bool landed = false;  ///< the body flew and then touched the terrain
  double flight_range =
      0;  ///< m, horizontal distance to the first landing, or to the end of the run if the body never landed
  double bounce_height = 0;  ///< m, greatest height of the centre of mass above the ground below it
  int impact_count = 0;
  Travel travel;                     ///< for a body that stopped: until it came to rest
  PathBins path;                     ///< greatest height, speed and energy along x
  std::vector<Passage> passages;     ///< of gates, each gate at most once
  std::vector<BarrierHit> barriers;  ///< barriers that the body reached, each at most once
  std::vector<TreeHit> trees;        ///< each tree at most once
  std::vector<Impact> impacts;
  std::vector<Apex> apexes;  ///< after the first impact
  std::vector<TrajectoryPoint> trajectory;

  /// Sets the first and last state and all extremes to `state`.
  void begin(const BodyState& state);
  /// Widens the extremes by `state`. Does not update max_distance, because its horizontal axes depend on the
  /// dimension.
  void include(const BodyState& state);
  /// Adds `by` to all places, when the engine has counted them from another origin. Distances stay, and so do
  /// the bins of `path`, which exist in 2D only.
  void move(const Vec3& by);
};

/// How well the equations were solved.
struct SolverQuality {
  std::uint64_t steps = 0;
  std::uint64_t cut_steps = 0;
  std::uint64_t refused_steps = 0;  ///< repeated with a shorter length because of their error
  double least_step = infinite;     ///< s, of the steps that no touch cut
  double greatest_step = 0;         ///< s
  double step_time = 0;             ///< s, sum of the lengths of all steps
  std::uint64_t flights = 0;
  std::uint64_t impact_problems = 0;
  /// Solves of impacts and of steps, including steps that were then repeated with a shorter length
  std::uint64_t problems = 0;
  std::uint64_t iterations = 0;
  std::uint64_t toc_iterations = 0;  ///< of the search for the time of impact
  std::uint64_t not_converged = 0;
  /// Greatest residual of the solves that did not converge, divided by the speed_scale of its contact; to be
  /// compared with the tolerance
  double not_converged_residual = 0;
  double max_residual = 0;     ///< m/s, residual of the scaled local map
  double max_penetration = 0;  ///< m
  /// rad, h sqrt(k W_nn): the phase that a spring (`penalty`) advances in one step; unstable from 2 on
  double max_spring_angle = 0;
  std::uint64_t energy_gains = 0;  ///< impacts and steps whose contacts gain energy, dT > 0 beyond rounding
  double energy_gained = 0;        ///< J
  /// Impacts of form `newton` that gain energy because slip stops or reverses; not among energy_gains
  std::uint64_t gains_by_slip = 0;
  double gained_by_slip = 0;  ///< J
  /// Instants whose impacts did not end by themselves (World::most_together)
  std::uint64_t endless_impacts = 0;
  std::uint64_t shocks = 0;  ///< velocity jumps in a step in which no contact approaches (Painleve)
  std::uint64_t dense_steps = 0;
  std::uint64_t dense_unfinished =
      0;                         ///< their solves that kept a residual above the tolerance of dense steps
  double dense_residual = 0;     ///< the greatest of them, relative to the speed_scale
  double unsolved_depth = 0;     ///< the deepest contact that a step leaves unsolved, of the smaller size
  double theta_loss = 0;         ///< J, potential energy that dense steps lose, being of first order; or gain
  double projection_energy = 0;  ///< J, by which they lift bodies out of each other
  double energy_relative_change = 0;  ///< (total energy at the end - total energy at the start) / |scale|

  /// The counts, and of what the greatest counts, as chunk files have them one after the other.
  static constexpr std::uint64_t SolverQuality::*counts[] = {
      &SolverQuality::steps,        &SolverQuality::cut_steps,       &SolverQuality::refused_steps,
      &SolverQuality::flights,      &SolverQuality::impact_problems, &SolverQuality::problems,
      &SolverQuality::iterations,   &SolverQuality::toc_iterations,  &SolverQuality::not_converged,
      &SolverQuality::energy_gains, &SolverQuality::gains_by_slip,   &SolverQuality::endless_impacts,
      &SolverQuality::shocks,       &SolverQuality::dense_steps,     &SolverQuality::dense_unfinished};
  static constexpr double SolverQuality::*greatest[] = {
      &SolverQuality::not_converged_residual, &SolverQuality::max_residual,   &SolverQuality::max_penetration,
      &SolverQuality::max_spring_angle,       &SolverQuality::dense_residual, &SolverQuality::unsolved_depth};

  /// Counts a step of length h; `cut`: a touch has cut it short.
  void count_step(double h, bool cut);
  void add(const SolverQuality& other);
};

}  // namespace flyrock
