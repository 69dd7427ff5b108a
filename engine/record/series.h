#pragma once
// What a run records over time (`output.series`): bodies, contacts, links, regions, solves, stresses and
// meshes, in SI units.

#include <array>
#include <cmath>
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
  /// N, on `a`: normal and tangential part, in the axes of the world; of an impact NaN
  Vec3 force = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
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

/// A box over which a series averages, in the coordinates of the scenario; without z in 2D.
struct RegionBox {
  std::string name;
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();  ///< m
};

/// Means over a region at the end of a step (flight/region_means.h).
struct SeriesRegion {
  double time = 0;
  std::string region;
  double step = 0;                                     ///< s, its length
  int bodies = 0;                                      ///< whose centres are in the region
  double porosity = 1;                                 ///< share that they leave free
  double stress_xx = 0, stress_yy = 0, stress_zz = 0;  ///< Pa, compression is positive
  double stress_xy = 0, stress_xz = 0, stress_yz = 0;  ///< Pa
};

/// The numbers of a SeriesRegion, as measures and columns name them.
struct RegionQuantity {
  const char *name, *column, *unit;
  double SeriesRegion::*value;
  bool in_space = false;  ///< only in 3D
};
inline constexpr std::array<RegionQuantity, 7> region_quantities{
    {{"porosity", "porosity", "", &SeriesRegion::porosity},
     {"stress_xx", "stress_xx_Pa", "Pa", &SeriesRegion::stress_xx},
     {"stress_yy", "stress_yy_Pa", "Pa", &SeriesRegion::stress_yy},
     {"stress_zz", "stress_zz_Pa", "Pa", &SeriesRegion::stress_zz, true},
     {"stress_xy", "stress_xy_Pa", "Pa", &SeriesRegion::stress_xy},
     {"stress_xz", "stress_xz_Pa", "Pa", &SeriesRegion::stress_xz, true},
     {"stress_yz", "stress_yz_Pa", "Pa", &SeriesRegion::stress_yz, true}}};

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

/// Whether a block is stressed more: a greater share of its volume is above its tensile strength. Without a
/// strength, or with the same share, 1 % of its volume exceeds a greater tension.
inline bool is_stressed_more(const SeriesStress& a, const SeriesStress& b) {
  const auto share = [](const SeriesStress& row) {
    return std::isnan(row.above_strength) ? 0 : row.above_strength;
  };
  return share(a) != share(b) ? share(a) > share(b) : a.tension_1pct > b.tension_1pct;
}

/// A node of a deformable block at an instant, in the axes of the world.
struct SeriesNode {
  double time = 0;
  std::string body;
  int node = 0;
  Vec3 place = Vec3::Zero();         ///< m, where it is
  Vec3 displacement = Vec3::Zero();  ///< m, of it from its place in the rigid body
  Vec3 rate = Vec3::Zero();          ///< m/s, of the displacement
};

/// A cell of a deformable block at an instant.
struct SeriesCell {
  double time = 0;
  std::string body;
  int cell = 0;
  int a = 0, b = 0, c = 0;              ///< its nodes
  int d = -1;                           ///< the fourth one in 3D; -1: none
  double tension = 0, compression = 0;  ///< Pa, the greatest principal stress, and the least one negated
};

/// The numbers of a SeriesStress, as measures and columns name them.
struct StressQuantity {
  const char *name, *unit;
  double SeriesStress::*value;
};
inline constexpr std::array<StressQuantity, 8> stress_quantities{
    {{"strain", "J", &SeriesStress::strain},
     {"vibration", "J", &SeriesStress::vibration},
     {"damped", "J", &SeriesStress::damped},
     {"touch", "J", &SeriesStress::touch},
     {"settled", "J", &SeriesStress::settled},
     {"tension_1pct", "Pa", &SeriesStress::tension_1pct},
     {"compression_1pct", "Pa", &SeriesStress::compression_1pct},
     {"share_above_strength", "", &SeriesStress::above_strength}}};

struct Series {
  std::vector<SeriesBody> bodies;
  std::vector<SeriesContact> contacts;
  std::vector<SeriesLink> links;
  std::vector<SeriesRegion> regions;
  std::vector<SeriesSolve> solves;
  std::vector<SeriesStress> stresses;
  std::vector<SeriesNode> nodes;  ///< of deformable blocks when they are stressed most, or at each row
  std::vector<SeriesCell> cells;
};

}  // namespace flyrock
