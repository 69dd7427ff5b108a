#include "collision/outline/outline.h"

#include <algorithm>

#include "collision/rules.h"
#include "geometry/ground.h"

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

/// In 2D, a search knows no directions.
TouchSearch seen_from(Workspace&, const Motion2&, const TouchSearch& search) { return search; }
TouchSearch seen_from(Workspace& work, const Motion3& frame, TouchSearch search) {
  const Rotation3 r = frame.turn(0).rotation;
  work.seen_from_outline.assign(search.held.list.begin(), search.held.list.end());
  for (HeldContact& held : work.seen_from_outline) held.normal = r.inverse(held.normal);
  search.held.list = work.seen_from_outline;
  return search;
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

}  // namespace

template <int D>
void outline_contacts(Workspace& work, const Placed<D>& other, const Placed<D>& outline, double reach,
                      double turn, Contacts<D>& out) {
  const std::size_t begin = out.size();
  terrain_contacts<D>(work, {other.shape, seen_from(outline.pose, other.pose), other.index},
                      *outline.shape.ground, reach, turn, out);
  for (std::size_t i = begin; i < out.size(); ++i) {
    out[i].point = outline.pose * out[i].point;
    out[i].normal = outline.pose.r * out[i].normal;
  }
}

template <int D>
double outline_gap(Workspace& work, const Placed<D>& other, FeatureId feature, const Placed<D>& outline,
                   FeatureId against, const Vec<D>& normal) {
  const GroundIn<D>& ground = *outline.shape.ground;
  return feature_gap<D>(work, {other.shape, seen_from(outline.pose, other.pose), other.index}, feature,
                        ground, against, outline.pose.r.inverse(normal));
}

template <int D>
std::optional<double> outline_touch(Workspace& work, const Moving<D>& other, const Moving<D>& outline,
                                    double t_max, const TouchSearch& search) {
  const GroundIn<D>& ground = *outline.shape.ground;
  const auto motion = seen_from(outline.motion, other.motion);
  const TouchSearch seen = seen_from(work, outline.motion, search);
  return time_of_contact<D>(work, {other.shape, motion, other.index}, ground, t_max, seen);
}

template <int D>
double depth_in_outline(const Placed<D>& outline, const Vec<D>& place) {
  return depth_in(*outline.shape.ground, outline.pose.r.inverse(place - outline.pose.x));
}

#define FLYROCK_INSTANTIATE(D)                                                                         \
  template void outline_contacts(Workspace&, const Placed<D>&, const Placed<D>&, double, double,       \
                                 Contacts<D>&);                                                        \
  template double outline_gap(Workspace&, const Placed<D>&, FeatureId, const Placed<D>&, FeatureId,    \
                              const Vec<D>&);                                                          \
  template std::optional<double> outline_touch(Workspace&, const Moving<D>&, const Moving<D>&, double, \
                                               const TouchSearch&);                                    \
  template double depth_in_outline(const Placed<D>&, const Vec<D>&)
FLYROCK_INSTANTIATE(2);
FLYROCK_INSTANTIATE(3);
#undef FLYROCK_INSTANTIATE

}  // namespace flyrock
