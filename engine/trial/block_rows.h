#pragma once
// The rows of the table `blocks`: what a block between joints can do.

#include <optional>
#include <string>

#include "plugin/block_plan.h"
#include "record/block_row.h"
#include "scenario/scenario.h"
#include "world/body.h"

namespace flyrock {

/// What holds a block on a joint by friction, |r_t| <= mu r_n + cohesion A.
struct JointStrength {
  double mu = 0;
  double cohesion = 0;      ///< Pa
  std::string reason = {};  ///< why the material has no such numbers; empty if it has
};

/// That of a material whose friction is `coulomb` or `mohr_coulomb` and does not change from impact to
/// impact.
JointStrength joint_strength(const Scenario& scenario, int material, const DrawKey& key);

/// The row of a block that is at rest. Its load is its weight with the push, the bolts and the water of its
/// plan; solver/cone_of_motions.h says how it starts to move. With the forces N_i of the joints that carry
/// it, factor = sum(c A_i + N_i mu) / |drive|. A block that falls has the factor 0; one that is held or
/// locked has none. `gravity` [m/s2]; `north`: the azimuth of
/// bearing 0 [rad].
template <int D>
BlockRow block_row(const BlockPlan<D>& plan, const Body<D>& body, double gravity,
                   const JointStrength& strength, double north = pi / 2);

/// Whether the plan of its population lets a block move.
template <int D>
bool moves(const BlockPlan<D>& plan, const BlockRow& row);

/// The row of the rock that was cut into `blocks` blocks, as the table has it.
BlockRegionRow region_row(const JointedRegion& region, int blocks);

}  // namespace flyrock
