#include "collision/outline/outline.h"

#include <algorithm>

#include "collision/pairs.h"
#include "collision/rules.h"

namespace flyrock {

namespace {

Rotation2 seen_from(const Rotation2& frame, const Rotation2& r) {
  const Vec2 axis = frame.inverse(Vec2(r.c, r.s));
  return {axis.x(), axis.y()};
}
Rotation3 seen_from(const Rotation3& frame, const Rotation3& r) { return frame.inverse() * r; }

template <class Pose>
Pose seen_from(const Pose& frame, const Pose& pose) {
  return {frame.r.inverse(pose.x - frame.x), seen_from(frame.r, pose.r)};
}

/// A path as a frame sees it that moves without turning.
template <int D, class Rotation>
void see_path(const Path<D>& frame, const Rotation& r, Path<D>& path) {
  path.x = r.inverse(path.x - frame.x);
  path.v = r.inverse(path.v - frame.v);
  path.a = r.inverse(path.a - frame.a);
}

Motion2 seen_from(const Motion2& frame, Motion2 motion) {
  see_path<2>(frame, frame.start(), motion);
  motion.angle -= frame.angle;
  motion.rotation.reset();
  return motion;
}

Motion3 seen_from(const Motion3& frame, Motion3 motion) {
  const Rotation3 r = frame.turn(0).rotation;
  see_path<3>(frame, r, motion);
  std::visit([&](auto& rotation) { rotation = rotation.seen_from(r); }, motion.rotation);
  return motion;
}

double depth_in(const Ground2& ground, const Vec2& place) {
  if (!ground.is_inside(place)) return 0;
  double nearest = 1e300;
  for (int i = 0; i < ground.segments(); ++i) {
    const double along = (place - ground.start(i)).dot(ground.tangent(i));
    const Vec2 on = ground.start(i) + std::clamp(along, 0.0, ground.length(i)) * ground.tangent(i);
    nearest = std::min(nearest, (place - on).norm());
  }
  return nearest;
}
double depth_in(const Ground3& ground, const Vec3& place) { return std::max(0.0, ground.depth(place)); }

template <int D>
void contacts_in_frame(const PlacedIn<D>& other, const PlacedIn<D>& outline, double reach, double turn,
                       Contacts<D>& out) {
  const std::size_t begin = out.size();
  terrain_contacts({other.shape, seen_from(outline.pose, other.pose), other.index}, *outline.shape.ground,
                   reach, turn, out);
  for (std::size_t i = begin; i < out.size(); ++i) {
    out[i].point = outline.pose * out[i].point;
    out[i].normal = outline.pose.r * out[i].normal;
  }
}

}  // namespace

void outline_contacts(const Placed2& other, const Placed2& outline, double reach, double turn,
                      Contacts<2>& out) {
  contacts_in_frame<2>(other, outline, reach, turn, out);
}
double outline_gap(const Placed2& other, FeatureId feature, const Placed2& outline, FeatureId against) {
  return feature_gap({other.shape, seen_from(outline.pose, other.pose)}, feature, *outline.shape.ground,
                     against);
}
std::optional<double> outline_touch(const Moving2& other, const Moving2& outline, double t_max,
                                    const TouchSearch& search) {
  return time_of_contact({other.shape, seen_from(outline.motion, other.motion), other.index},
                         *outline.shape.ground, t_max, search);
}
double depth_in_outline(const Placed2& outline, const Vec2& place) {
  return depth_in(*outline.shape.ground, outline.pose.r.inverse(place - outline.pose.x));
}

void outline_contacts(const Placed3& other, const Placed3& outline, double reach, double turn,
                      Contacts<3>& out) {
  contacts_in_frame<3>(other, outline, reach, turn, out);
}
double outline_gap(const Placed3& other, FeatureId feature, const Placed3& outline, FeatureId against) {
  return feature_gap({other.shape, seen_from(outline.pose, other.pose)}, feature, *outline.shape.ground,
                     against);
}
std::optional<double> outline_touch(const Moving3& other, const Moving3& outline, double t_max,
                                    const TouchSearch& search) {
  return time_of_contact({other.shape, seen_from(outline.motion, other.motion), other.index},
                         *outline.shape.ground, t_max, search);
}
double depth_in_outline(const Placed3& outline, const Vec3& place) {
  return depth_in(*outline.shape.ground, outline.pose.r.inverse(place - outline.pose.x));
}

}  // namespace flyrock
