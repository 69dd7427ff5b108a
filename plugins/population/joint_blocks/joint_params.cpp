#include "plugins/population/joint_blocks/joint_params.h"

#include <fmt/format.h>

#include "geometry/bearing.h"

namespace flyrock::plugins {

namespace {

[[noreturn]] void refuse_params(const std::string& text) {
  throw PluginError("plugin joint_blocks: " + text);
}

/// The horizontal unit vector of a bearing. `north`: the azimuth of bearing 0.
Vec2 along_bearing(double bearing, double north) {
  const double azimuth = azimuth_of_bearing(bearing, north);
  return {std::cos(azimuth), std::sin(azimuth)};
}

Vec3 downwards(double trend, double plunge, double north) {
  const Vec2 level = along_bearing(trend, north);
  return {std::cos(plunge) * level.x(), std::cos(plunge) * level.y(), -std::sin(plunge)};
}

template <int D>
Vec<D> vector_at(Values values, int slot) {
  Vec<D> vector;
  for (int k = 0; k < D; ++k) vector[k] = values[static_cast<std::size_t>(slot + k)];
  return vector;
}

double value_or(Values values, int slot, double otherwise) {
  return slot < 0 ? otherwise : values[static_cast<std::size_t>(slot)];
}

}  // namespace

template <int D>
JointParams<D>::JointParams(Params& params)
    : least_volume_(params.slot("least_volume")),
      most_blocks_(params.slot("most_blocks")),
      horizontal_(params.slot("horizontal")),
      bearing_(params.slot("bearing")),
      water_(params.slot("water")) {
  const bool is_notch = params.text("region") == "notch";
  for (const ParamRecord& region : params.records("region"))
    for (const std::vector<double>& point : region.points("points"))
      region_.push_back(Eigen::Map<const Vec<D>>(point.data()));
  if (!is_notch && region_.size() < D + 1)
    refuse_params(fmt::format("`region` has {} points, expected at least {}", region_.size(), D + 1));
  for (const ParamRecord& record : params.records("sets")) sets_.push_back(read_set(record, sets_.size()));
  for (const ParamRecord& record : params.records("planes"))
    measured_.push_back(read_measured(record, measured_.size()));
  if (sets_.empty() && measured_.empty())
    refuse_params("needs `sets` or `planes`: without joints there are no blocks");
  for (const ParamRecord& record : params.records("bolts"))
    bolts_.push_back({record.slot("at"), record.slot("trend"), record.slot("plunge"), record.slot("force")});
  const std::string only = params.text("only");
  moving_ = only == "removable"        ? MovingBlocks::removable
            : only == "factor_below_1" ? MovingBlocks::factor_below_1
                                       : MovingBlocks::all;
  if (D == 2 && bearing_ >= 0) refuse_params("`bearing` is for 3D: in 2D the horizontal force acts along +x");
}

template <int D>
typename JointParams<D>::Orientation JointParams<D>::orientation_of(const ParamRecord& record,
                                                                    const std::string& key) {
  const Orientation found{record.slot("dip"), record.slot("dip_direction"), record.slot("angle")};
  if (D == 2 && (found.dip >= 0 || found.direction >= 0))
    refuse_params(fmt::format("`{}` has in 2D an `angle`, from +x counter-clockwise, and no `dip`", key));
  if (D == 3 && found.angle >= 0)
    refuse_params(fmt::format("`{}` has in 3D `dip` and `dip_direction`, and no `angle`", key));
  return found;
}

template <int D>
Vec<D> JointParams<D>::normal_of(Values values, const Orientation& orientation, double north) {
  if constexpr (D == 2) {
    const double angle = values[static_cast<std::size_t>(orientation.angle)];
    return {-std::sin(angle), std::cos(angle)};
  } else {
    const double dip = values[static_cast<std::size_t>(orientation.dip)];
    const Vec2 level = along_bearing(values[static_cast<std::size_t>(orientation.direction)], north);
    return {std::sin(dip) * level.x(), std::sin(dip) * level.y(), std::cos(dip)};
  }
}

template <int D>
typename JointParams<D>::SetSlots JointParams<D>::read_set(const ParamRecord& record,
                                                           std::size_t place) const {
  SetSlots slots;
  const std::string key = fmt::format("sets.{}", place);
  slots.set.name = record.text("name").empty() ? fmt::format("set_{}", place + 1) : record.text("name");
  slots.orientation = orientation_of(record, key);
  slots.fisher_k = record.slot("fisher_k");
  slots.persistence = record.slot("persistence");
  slots.origin = record.slot("origin");
  slots.set.spacing = record.law("spacing");
  slots.set.radius = record.law("radius");
  if (slots.set.radius && slots.persistence >= 0)
    refuse_params(fmt::format("`{}` has `persistence` and `radius`, expected one of the two", key));
  if (slots.set.radius && slots.origin >= 0)
    refuse_params(fmt::format("`{}` has `origin` and `radius`: discs lie at random places", key));
  return slots;
}

template <int D>
typename JointParams<D>::Measured JointParams<D>::read_measured(const ParamRecord& record,
                                                                std::size_t place) const {
  Measured plane;
  const std::string key = fmt::format("planes.{}", place);
  plane.name = record.text("set").empty() ? fmt::format("plane_{}", place + 1) : record.text("set");
  plane.orientation = orientation_of(record, key);
  plane.radius = record.slot("radius");
  const char* names[] = {"x", "y", "z"};
  int given = 0;
  for (int k = 0; k < 3; ++k) {
    plane.place[k] = record.slot(names[k]);
    given += plane.place[k] >= 0 && k < D;
  }
  if (given != 0 && given != D)
    refuse_params(fmt::format("`{}` needs all of {} or none", key, D == 2 ? "`x`, `y`" : "`x`, `y`, `z`"));
  if (given == 0 && plane.radius >= 0)
    refuse_params(fmt::format("`{}` has a `radius`, which needs its place {}", key,
                              D == 2 ? "`x`, `y`" : "`x`, `y`, `z`"));
  return plane;
}

template <int D>
std::vector<Joint<D>> JointParams<D>::measured(Values values, double north,
                                               const std::vector<Vec<D>>& corners, RandomStream& rng) const {
  std::vector<Joint<D>> joints;
  for (const Measured& plane : measured_) {
    Joint<D> joint;
    joint.set = static_cast<int>(joints.size());
    joint.normal = normal_of(values, plane.orientation, north);
    if (plane.place[0] >= 0) {
      for (int k = 0; k < D; ++k) joint.centre[k] = values[static_cast<std::size_t>(plane.place[k])];
      joint.offset = joint.normal.dot(joint.centre);
    } else {
      double low = infinite, high = -infinite;
      for (const Vec<D>& p : corners) {
        low = std::min(low, joint.normal.dot(p));
        high = std::max(high, joint.normal.dot(p));
      }
      joint.offset = rng.uniform(low, high);
    }
    joint.radius = value_or(values, plane.radius, infinite);
    joints.push_back(joint);
  }
  return joints;
}

template <int D>
std::vector<JointSet<D>> JointParams<D>::sets(Values values, double north) const {
  std::vector<JointSet<D>> sets;
  for (const SetSlots& slots : sets_) {
    JointSet<D>& set = sets.emplace_back(slots.set);
    set.normal = normal_of(values, slots.orientation, north);
    set.fisher_k = value_or(values, slots.fisher_k, 0);
    set.persistence = value_or(values, slots.persistence, 1);
    if (slots.origin >= 0) set.origin = vector_at<D>(values, slots.origin);
  }
  return sets;
}

template <int D>
Vec<D> JointParams<D>::push(Values values, double north, const Vec<D>& outward) const {
  const double share = values[static_cast<std::size_t>(horizontal_)];
  if (D == 2 || bearing_ < 0) {
    if (share != 0 && outward.isZero(0))
      refuse_params(
          "`horizontal` needs `bearing`, its direction clockwise from north, where the region is no notch");
    return share * outward;
  }
  Vec<D> push = Vec<D>::Zero();
  push.template head<2>() = share * along_bearing(values[static_cast<std::size_t>(bearing_)], north);
  return push;
}

template <int D>
std::vector<typename JointParams<D>::Bolt> JointParams<D>::bolts(Values values, double north) const {
  std::vector<Bolt> bolts;
  for (const BoltSlots& slots : bolts_) {
    Bolt& bolt = bolts.emplace_back();
    bolt.at = vector_at<D>(values, slots.at);
    const double trend = values[static_cast<std::size_t>(slots.trend)];
    const double plunge = values[static_cast<std::size_t>(slots.plunge)];
    const double force = values[static_cast<std::size_t>(slots.force)];
    if constexpr (D == 2)
      bolt.force = force * Vec2(std::cos(plunge), -std::sin(plunge));
    else
      bolt.force = force * downwards(trend, plunge, north);
  }
  return bolts;
}

template class JointParams<2>;
template class JointParams<3>;

}  // namespace flyrock::plugins
