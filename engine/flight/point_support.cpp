#include "flight/point_support.h"

#include <algorithm>
#include <cmath>

namespace flyrock {

namespace {

enum class Way { open, blocked };

/// Whether a point on a face moves along it, or leaves it through one of the rims on which it is. Slow motion
/// across a rim is decided by the acceleration, and its part that leads out is removed.
template <int D>
Way way_on(const Face<D>& face, const Vec<D>& at, double slow, Sliding<D>& sliding) {
  const auto is_on = [&](int i) { return face.inside(i, at) <= 2 * face_reach; };
  for (int i = 0; i < face.rims; ++i) {
    const double rate = sliding.velocity.dot(face.inward[i]);
    if (!is_on(i) || rate >= 0) continue;
    if (rate < -slow) return Way::blocked;
    sliding.velocity -= rate * face.inward[i];
  }
  // At a corner, what is taken off at one rim may lead out of another.
  for (int i = 0; i < face.rims; ++i) {
    const double rate = sliding.velocity.dot(face.inward[i]);
    if (!is_on(i) || rate > slow) continue;
    if (rate < -1e-12 || sliding.acceleration().dot(face.inward[i]) < -1e-9 * sliding.pull.norm())
      return Way::blocked;
  }
  return Way::open;
}

/// Whether the ground rises from `face` to `other` at a point of both.
template <int D>
bool is_valley(const Face<D>& face, const Face<D>& other, const Vec<D>& at) {
  for (int i = 0; i < other.rims; ++i)
    if (other.inside(i, at) <= 2 * face_reach && other.inward[i].dot(face.normal) > 1e-9 &&
        std::abs(other.normal.dot(face.normal)) < 1 - 1e-12)
      return true;
  return false;
}

/// Two faces that meet in a valley: along its edge in 3D, at rest in 2D.
template <int D>
bool holds_between(PointContact<D>& contact, const Face<D>& a, const Face<D>& b, double time,
                   const Vec<D>& at, const Vec<D>& v, const Vec<D>& force, Support<D>& support) {
  Vec<D> edge = Vec<D>::Zero();
  if constexpr (D == 3) edge = a.normal.cross(b.normal).normalized();
  const Vec<D> press = -(force - force.dot(edge) * edge);
  // press = share_a a.normal + share_b b.normal
  const double mixed = a.normal.dot(b.normal), pa = press.dot(a.normal), pb = press.dot(b.normal);
  const double scale = 1 - mixed * mixed;
  const double share_a = (pa - mixed * pb) / scale, share_b = (pb - mixed * pa) / scale;
  if (share_a < 0 || share_b < 0) return false;
  const auto grip_a = contact.grip(a, time, at, v, share_a), grip_b = contact.grip(b, time, at, v, share_b);
  Sliding<D> sliding;
  sliding.velocity = v.dot(edge) * edge;
  sliding.pull = force.dot(edge) * edge;
  sliding.friction = grip_a.slides + grip_b.slides;
  sliding.holds = grip_a.holds + grip_b.holds;
  support = {
      &a, &b, sliding, grip_a.rolls && grip_b.rolls, grip_a.constant && grip_b.constant, sliding.at_rest()};
  return true;
}

}  // namespace

template <int D>
Support<D> support_of(PointContact<D>& contact, const std::vector<Face<D>>& faces, double time,
                      const Vec<D>& at, const Vec<D>& v, const Vec<D>& force, double slow) {
  const double rounding = rounding_of_speed(v.norm());
  Support<D> support;
  bool blocked = false;
  for (const Face<D>& face : faces) {
    const double rise = v.dot(face.normal), press = -force.dot(face.normal);
    if (rise > rounding || !(press > 0)) continue;
    Sliding<D> sliding;
    sliding.velocity = v - rise * face.normal;
    if (sliding.velocity.squaredNorm() < 1e-24) sliding.velocity.setZero();
    sliding.pull = force + press * face.normal;
    const auto grip = contact.grip(face, time, at, sliding.velocity, press);
    sliding.friction = grip.slides;
    sliding.holds = grip.holds;
    const bool rests = sliding.at_rest();
    if (!rests && way_on(face, at, slow, sliding) == Way::blocked) {
      blocked = true;
      continue;
    }
    return {&face, nullptr, sliding, grip.rolls, grip.constant, rests};
  }
  if (!blocked) return support;
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (std::size_t k = i + 1; k < faces.size(); ++k) {
      const Face<D>&a = faces[i], &b = faces[k];
      if (v.dot(a.normal) > slow || v.dot(b.normal) > slow || !is_valley(a, b, at)) continue;
      if (!holds_between(contact, a, b, time, at, v, force, support)) continue;
      if (support.stays) return support;
      // In 3D the edge may end here, at a third face that closes the valley.
      Sliding<D> along = support.sliding;
      if (way_on(a, at, slow, along) == Way::open && way_on(b, at, slow, along) == Way::open) return support;
      support = {};
    }
  // At the bottom of a pit no face and no edge leads on. A slow point falls straight down: where all faces
  // look up, it would fall into the ground.
  const bool all_carry = std::all_of(faces.begin(), faces.end(),
                                     [&](const Face<D>& face) { return force.dot(face.normal) < 0; });
  if (v.norm() <= 10 * slow && all_carry) {
    support.face = &faces.front();
    support.stays = true;
  }
  return support;
}

template Support<2> support_of(PointContact<2>&, const std::vector<Face<2>>&, double, const Vec2&,
                               const Vec2&, const Vec2&, double);
template Support<3> support_of(PointContact<3>&, const std::vector<Face<3>>&, double, const Vec3&,
                               const Vec3&, const Vec3&, double);

}  // namespace flyrock
