#include "collision/surface.h"

#include <algorithm>

#include "collision/feature_gap.h"
#include "collision/terrain_contact.h"

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

}  // namespace

template <int D>
void surface_contacts(const typename Geometry<D>::Placed& candidate, int candidate_index,
                      const typename Geometry<D>::Placed& antagonist, int antagonist_index, double reach,
                      double turn, std::vector<ContactPoint<D>>& out) {
  const bool is_candidate = candidate.shape.is_surface();
  if (is_candidate && antagonist.shape.is_surface()) return;
  const auto &surface = is_candidate ? candidate : antagonist, &other = is_candidate ? antagonist : candidate;
  const std::size_t begin = out.size();
  terrain_contacts({other.shape, seen_from(surface.pose, other.pose)},
                   is_candidate ? antagonist_index : candidate_index, *surface.shape.surface, reach, turn,
                   out);
  for (std::size_t i = begin; i < out.size(); ++i) {
    ContactPoint<D>& contact = out[i];
    contact.point = surface.pose * contact.point;
    contact.normal = surface.pose.r * contact.normal;
    if (!is_candidate) continue;
    contact.normal = -contact.normal;
    std::swap(contact.feature, contact.against);
  }
}

template <int D>
double surface_gap(const typename Geometry<D>::Placed& candidate, FeatureId feature,
                   const typename Geometry<D>::Placed& antagonist, FeatureId against) {
  if (candidate.shape.is_surface()) return surface_gap<D>(antagonist, against, candidate, feature);
  return feature_gap({candidate.shape, seen_from(antagonist.pose, candidate.pose)}, feature,
                     *antagonist.shape.surface, against);
}

template <int D>
std::optional<double> surface_touch(const typename Geometry<D>::Contactor& a, int a_index,
                                    const typename Geometry<D>::Motion& a_motion,
                                    const typename Geometry<D>::Contactor& b, int b_index,
                                    const typename Geometry<D>::Motion& b_motion, double t_max,
                                    const TouchSearch& search) {
  if (a.is_surface() && b.is_surface()) return std::nullopt;
  if (!a.is_surface())
    return time_of_contact(a, a_index, seen_from(b_motion, a_motion), *b.surface, t_max, search);
  thread_local std::vector<HeldContact> held;  // keeps its memory between calls
  held.clear();
  for (const HeldContact& h : search.held) held.push_back({h.against, h.feature, h.opened, h.yields});
  TouchSearch from_b = search;
  from_b.held = held;
  return time_of_contact(b, b_index, seen_from(a_motion, b_motion), *a.surface, t_max, from_b);
}

double depth_in_surface(const Placed2& surface, const Vec2& place) {
  return depth_in(*surface.shape.surface, surface.pose.r.inverse(place - surface.pose.x));
}
double depth_in_surface(const Placed3& surface, const Vec3& place) {
  return depth_in(*surface.shape.surface, surface.pose.r.inverse(place - surface.pose.x));
}

#define FLYROCK_INSTANTIATE(D)                                                                            \
  template void surface_contacts<D>(const Geometry<D>::Placed&, int, const Geometry<D>::Placed&, int,     \
                                    double, double, std::vector<ContactPoint<D>>&);                       \
  template double surface_gap<D>(const Geometry<D>::Placed&, FeatureId, const Geometry<D>::Placed&,       \
                                 FeatureId);                                                              \
  template std::optional<double> surface_touch<D>(                                                        \
      const Geometry<D>::Contactor&, int, const Geometry<D>::Motion&, const Geometry<D>::Contactor&, int, \
      const Geometry<D>::Motion&, double, const TouchSearch&)
FLYROCK_INSTANTIATE(2);
FLYROCK_INSTANTIATE(3);
#undef FLYROCK_INSTANTIATE

}  // namespace flyrock
