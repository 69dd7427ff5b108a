#include "trial/block_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/bearing.h"
#include "solver/cone_of_motions.h"
#include "trial/instances.h"

namespace flyrock {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// The number of a parameter in its list of values; nothing if it was left out.
std::optional<double> param_of(const PluginUse& use, const std::vector<double>& values,
                               std::string_view name) {
  const int at = use.plugin->spec.find(name);
  if (at < 0 || use.values[static_cast<std::size_t>(at)].numbers.empty()) return std::nullopt;
  std::size_t slot = 0;
  for (int i = 0; i < at; ++i) slot += use.values[static_cast<std::size_t>(i)].numbers.size();
  return values[slot];
}

/// The joints that carry a block, each once: "bedding, j2".
template <int D>
std::string names_of_joints(const BlockPlan<D>& plan, const std::vector<int>& joints) {
  std::vector<std::string> names;
  for (const int joint : joints) {
    const std::string name = joint < 0 ? "ground" : plan.region->joints.at(static_cast<std::size_t>(joint));
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

/// The direction of a motion: trend clockwise from north, plunge below the horizontal.
void set_direction(BlockRow& row, const Vec2& drive, double) {
  row.plunge = std::atan2(-drive.y(), std::abs(drive.x()));
}
void set_direction(BlockRow& row, const Vec3& drive, double north) {
  row.plunge = std::atan2(-drive.z(), drive.head<2>().norm());
  if (drive.head<2>().norm() <= 1e-9 * drive.norm()) return;  // straight down or up
  row.trend = bearing_of_azimuth(std::atan2(drive.y(), drive.x()), north);
}

BlockMode mode_of(bool drives, bool removable, std::size_t carrying) {
  if (!drives) return removable ? BlockMode::held : BlockMode::locked;
  return carrying == 0 ? BlockMode::falls : carrying == 1 ? BlockMode::plane : BlockMode::wedge;
}

}  // namespace

JointStrength joint_strength(const Scenario& scenario, int material, const DrawKey& key) {
  const std::optional<PluginUse>& use = scenario.materials[static_cast<std::size_t>(material)].friction;
  if (!use) return {};
  JointStrength strength;
  const std::string& law = use->plugin->spec.name;
  const bool varies = std::any_of(use->slots.begin(), use->slots.end(), [&](const Number& number) {
    return !number.is_constant() &&
           scenario.draws[static_cast<std::size_t>(number.draw)].scope == Scope::impact;
  });
  if (law != "coulomb" && law != "mohr_coulomb") {
    strength.reason =
        fmt::format("no factor with the friction `{}`, only with `coulomb` and `mohr_coulomb`", law);
  } else if (varies) {
    strength.reason = "no factor with a friction that is drawn at each impact";
  } else {
    const std::vector<double> values = values_of(*use, scenario, key);
    if (const auto angle = param_of(*use, values, "angle")) strength.mu = std::tan(*angle);
    if (const auto mu = param_of(*use, values, "mu")) strength.mu = *mu;
    strength.cohesion = param_of(*use, values, "cohesion").value_or(0);
  }
  return strength;
}

template <int D>
BlockRow block_row(const BlockPlan<D>& plan, const Body<D>& body, double gravity,
                   const JointStrength& strength, double north) {
  const double width = body.volume / plan.volume;  // m in 2D, where the plan is of one metre; 1 in 3D
  const double weight = body.mass / width * gravity;
  BlockRow row;
  row.volume = body.volume;
  row.faces = static_cast<int>(plan.faces.size());
  Vec<D> load = -weight * Vec<D>::Unit(D - 1) + weight * plan.push + plan.pull;
  std::vector<const typename BlockPlan<D>::Face*> closed;
  std::vector<Vec<D>> normals;  // into the block
  for (const auto& face : plan.faces) {
    (face.joint == BlockPlan<D>::free ? row.free_area : row.joint_area) += width * face.area;
    if (face.joint == BlockPlan<D>::free) continue;
    closed.push_back(&face);
    normals.push_back(-face.normal);
    load -= plan.pressure * face.area * face.normal;
  }
  const BlockMotion<D> motion = block_motion<D>(normals, load);
  const bool drives = !motion.drive.isZero(0);
  const std::vector<int> carrying = motion.active();
  row.removable = motion.removable;
  row.mode = mode_of(drives, motion.removable, carrying.size());
  row.trend = row.plunge = row.factor = none;
  if (!drives) return row;
  set_direction(row, motion.drive, north);
  std::vector<int> joints;
  double resistance = 0;
  for (const int i : carrying) {
    const auto place = static_cast<std::size_t>(i);
    joints.push_back(closed[place]->joint);
    resistance += strength.cohesion * closed[place]->area + strength.mu * motion.pressing[place];
  }
  row.joints = names_of_joints(plan, joints);
  if (row.mode == BlockMode::falls)
    row.factor = 0;
  else if (strength.reason.empty())
    row.factor = resistance / motion.drive.norm();
  else
    row.reason = strength.reason;
  return row;
}

template <int D>
bool moves(const BlockPlan<D>& plan, const BlockRow& row) {
  switch (plan.moving) {
    case MovingBlocks::all:
      return true;
    case MovingBlocks::removable:
      return row.removable;
    case MovingBlocks::factor_below_1:
      return row.factor < 1;
  }
  return true;
}

BlockRegionRow region_row(const JointedRegion& region, int blocks) {
  return {.volume = region.volume,
          .blocks = blocks,
          .left_out = region.left_out,
          .left_out_volume = region.left_out_volume,
          .joints = region.planes,
          .joint_area = region.joint_area,
          .joint_count = region.joint_count};
}

template BlockRow block_row(const BlockPlan<2>&, const Body<2>&, double, const JointStrength&, double);
template BlockRow block_row(const BlockPlan<3>&, const Body<3>&, double, const JointStrength&, double);
template bool moves(const BlockPlan<2>&, const BlockRow&);
template bool moves(const BlockPlan<3>&, const BlockRow&);

}  // namespace flyrock
