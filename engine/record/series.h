#pragma once
// What a run records over time (`output.series`): bodies, contacts, solves and stresses, in SI units.

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "record/observe.h"

namespace flyrock {

/// A body at the end of a step, before or after an impact, or at an end of a flight.
struct SeriesBody {
  std::string body;
  BodyState state;
  double potential_energy = 0;                               ///< J, above height 0 of the scenario
  std::array<double, 4> turn = {1, 0, 0, 0};                 ///< 3D: attitude, as in TrajectoryPoint
  double radius = std::numeric_limits<double>::quiet_NaN();  ///< m, of a pneumatic disk; NaN: a rigid body
};

/// The state of a contact. `open`: within reach, but without a force in this step.
enum class SeriesState { open, sticking, sliding, before_impact, after_impact };
const char* name_of(SeriesState state);

/// A contact at the end of a step, or before and after an impact.
struct SeriesContact {
  double time = 0;
  std::string a, b;       ///< the bodies; the normal points from b to a; `terrain` or `terrain.<part>`
  int point = 0;          ///< number among the contacts of the pair, from 0
  double step = 0;        ///< s, length of the step; 0: an impact
  double gap = 0;         ///< m
  double un = 0, ut = 0;  ///< m/s, relative velocity; along t = (n_y, -n_x) in 2D, a length in 3D
  double pn = 0, pt = 0;  ///< N s, impulse in the step or impact; 0 before an impact
  double rn = 0, rt = 0;  ///< N, impulse / step; of an impact NaN, because its impulse has no duration
  SeriesState state = SeriesState::open;
  Vec3 place = Vec3::Zero(), normal = Vec3::Zero();
};

/// A link at the end of a step, or after an impact.
struct SeriesLink {
  double time = 0;
  std::string link;
  double step = 0;     ///< s, length of the step; 0: an impact
  double impulse = 0;  ///< N s, in the step or impact; positive where the link pulls, of a hinge its amount
  double force = 0;    ///< N, impulse / step; of an impact NaN
  double length = 0;   ///< m, the distance of its ends
  double angle = std::numeric_limits<double>::quiet_NaN();  ///< rad, of a hinge since the start
  double energy = 0;                                        ///< J, of a spring
  Vec3 end_a = Vec3::Zero(), end_b = Vec3::Zero();
};

/// The solution of the contact problem of a step or an impact.
struct SeriesSolve {
  double time = 0;
  double step = 0;  ///< s; 0: an impact
  int contacts = 0;
  int sweeps = 0;       ///< iterations of the solver
  double residual = 0;  ///< m/s
};

/// Energy and stress of a deformable block at the end of a step or of a flight (world/deformation.h,
/// elastic/stress_share.h).
struct SeriesStress {
  double time = 0;
  std::string body;
  double strain = 0, vibration = 0;                                  ///< J
  double damped = 0, touch = 0, settled = 0;                         ///< J, so far
  double tension_1pct = 0, compression_1pct = 0;                     ///< Pa
  double above_strength = std::numeric_limits<double>::quiet_NaN();  ///< share of the volume
};

struct Series {
  std::vector<SeriesBody> bodies;
  std::vector<SeriesContact> contacts;
  std::vector<SeriesLink> links;
  std::vector<SeriesSolve> solves;
  std::vector<SeriesStress> stresses;
};

}  // namespace flyrock
