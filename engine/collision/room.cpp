#include "collision/room.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision/contact_patch.h"
#include "collision/facing.h"
#include "math/farthest_on_ellipse.h"

namespace flyrock {

namespace {

/// The index of the second place of a rim that is nearest to a round wall, in the ids of facing.h.
constexpr int second_place = 8;

/// A contact of a place of `other` with the wall. The normal points from the antagonist to the candidate.
template <int D>
ContactPoint<D> contact_at(const Vec<D>& place, const Vec<D>& normal, double gap, double radius,
                           FeatureId of_other, FeatureId of_room, bool room_is_candidate) {
  const Vec<D> middle = place - (radius + 0.5 * gap) * normal;
  if (room_is_candidate) return {middle, -normal, gap, of_room, of_other};
  return {middle, normal, gap, of_other, of_room};
}

/// The place of a rim with this index of facing.h.
Vec3 place_on_rim(const Placed3& other, int index, const Room3& room, const Vec3& origin) {
  if (room.is_plane()) return rim_place(other, index, -room.axis());
  const Ring ring = ring_of(other, other.shape.circles[circle_of_rim(index)], origin);
  const auto nearest = room.nearest(ring);
  return origin + ring.at(place_of_rim(index) == second_place ? nearest.back() : nearest.front());
}

}  // namespace

Vec2 Room2::normal(const Vec2& from) const {
  const double rho = from.norm();
  return rho > 0 ? Vec2(-from / rho) : Vec2::UnitY();
}

Room3::Room3(const Placed3& room) : plane_(room.shape.is_half_space()) {
  if (plane_) {
    axis_ = room.pose.r * Vec3::UnitZ();
    radius_ = half_ = std::numeric_limits<double>::infinity();
  } else {
    const Contactor3::Circle& end = room.shape.circles.front();
    axis_ = room.pose.r * end.axis;
    radius_ = end.radius;
    half_ = end.axis.dot(end.centre);
  }
  first_ = axis_.unitOrthogonal();
  second_ = axis_.cross(first_);
}

double Room3::gap(const Vec3& from) const {
  return plane_ ? axis_.dot(from) : radius_ - (from - axis_.dot(from) * axis_).norm();
}

Vec3 Room3::normal(const Vec3& from) const {
  if (plane_) return axis_;
  const Vec3 across = from - axis_.dot(from) * axis_;
  const double rho = across.norm();
  return rho > 0 ? Vec3(-across / rho) : first_;
}

boost::container::static_vector<double, 2> Room3::nearest(const Ring& ring) const {
  if (plane_) return {std::atan2(-axis_.dot(ring.b), -axis_.dot(ring.a))};
  const auto flat = [&](const Vec3& v) { return Vec2(first_.dot(v), second_.dot(v)); };
  return farthest_on_ellipse(flat(ring.centre), flat(ring.a), flat(ring.b));
}

double Room3::least_gap(const Ring& ring, double from, double to) const {
  double least = std::min(gap(ring.at(from)), gap(ring.at(to)));
  for (const double angle : nearest(ring)) {
    const double after = std::fmod(angle - from + 4 * pi, 2 * pi);
    if (after <= to - from) least = std::min(least, gap(ring.at(angle)));
  }
  return least;
}

bool Room3::holds(const Vec3& middle) const {
  return plane_ || (std::abs(axis_.dot(middle)) <= half_ && gap(middle) > -Room2::wall_share * radius_);
}

Vec2 middle_of(const Contactor2& shape) {
  Vec2 sum = Vec2::Zero();
  for (const Vec2& point : shape.points) sum += point;
  return sum / static_cast<double>(shape.points.size());
}

Vec3 middle_of(const Contactor3& shape) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& point : shape.points) sum += point;
  for (const Contactor3::Circle& circle : shape.circles) sum += circle.centre;
  return sum / static_cast<double>(shape.points.size() + shape.circles.size());
}

Ring ring_of(const Placed3& shape, const Contactor3::Circle& circle, const Vec3& origin) {
  const Vec3 first = circle.axis.unitOrthogonal();
  return {shape.pose * circle.centre - origin, shape.pose.r * Vec3(circle.radius * first),
          shape.pose.r * Vec3(circle.radius * circle.axis.cross(first))};
}

void room_contacts(const Placed2& candidate, int ic, const Placed2& antagonist, int ia, double reach,
                   std::vector<ContactPoint<2>>& out) {
  const bool is_candidate = candidate.shape.is_room();
  if (is_candidate && antagonist.shape.is_room()) return;
  const Placed2 &placed = is_candidate ? candidate : antagonist,
                &other = is_candidate ? antagonist : candidate;
  const Room2 room(placed);
  if (!room.holds(other.pose * middle_of(other.shape) - placed.pose.x)) return;
  const int of_room = is_candidate ? ic : ia, of_other = is_candidate ? ia : ic;
  for (int i = 0; i < other.count(); ++i) {
    const Vec2 place = other.point(i), from = place - placed.pose.x;
    const double gap = room.gap(from) - other.shape.radius;
    if (gap <= reach)
      out.push_back(contact_at<2>(place, room.normal(from), gap, other.shape.radius, vertex_id(of_other, i),
                                  vertex_id(of_room, 0), is_candidate));
  }
}

void room_contacts(const Placed3& candidate, int ic, const Placed3& antagonist, int ia, double reach,
                   std::vector<ContactPoint<3>>& out) {
  const bool is_candidate = candidate.shape.is_room();
  if (is_candidate && antagonist.shape.is_room()) return;
  const Placed3 &placed = is_candidate ? candidate : antagonist,
                &other = is_candidate ? antagonist : candidate;
  const Room3 room(placed);
  const Vec3& origin = placed.pose.x;
  if (!room.holds(other.pose * middle_of(other.shape) - origin)) return;
  const int of_room = is_candidate ? ic : ia, of_other = is_candidate ? ia : ic;
  const std::size_t begin = out.size();
  const auto see = [&](const Vec3& place, FeatureKind kind, int index) {
    const double gap = room.gap(place - origin) - other.shape.radius;
    if (gap > reach) return false;
    out.push_back(contact_at<3>(place, room.normal(place - origin), gap, other.shape.radius,
                                feature_id(of_other, kind, index), feature_id(of_room, FeatureKind::face, 0),
                                is_candidate));
    return true;
  };
  for (int i = 0; i < other.count(); ++i) see(other.point(i), FeatureKind::vertex, i);
  for (int k = 0; k < static_cast<int>(other.shape.circles.size()); ++k) {
    if (room.is_plane()) {
      // Where a cap is level, all places of its rim are near. The first one is the nearest.
      for (int i = 0; i < rim_places; ++i) {
        const int index = rim_index(k, i);
        if (!see(rim_place(other, index, -room.axis()), FeatureKind::edge, index) && i == 0) break;
      }
      continue;
    }
    const Ring ring = ring_of(other, other.shape.circles[k], origin);
    const auto nearest = room.nearest(ring);
    for (std::size_t i = 0; i < nearest.size(); ++i)
      see(origin + ring.at(nearest[i]), FeatureKind::edge, rim_index(k, i == 0 ? 0 : second_place));
  }
  if (room.is_plane()) keep_four(out, begin);
}

double room_gap(const Placed2& candidate, FeatureId feature, const Placed2& antagonist, FeatureId against) {
  const bool is_candidate = candidate.shape.is_room();
  const Placed2 &room = is_candidate ? candidate : antagonist, &other = is_candidate ? antagonist : candidate;
  const int vertex = index_2d(is_candidate ? against : feature);
  return Room2(room).gap(other.point(vertex) - room.pose.x) - other.shape.radius;
}

double room_gap(const Placed3& candidate, FeatureId feature, const Placed3& antagonist, FeatureId against) {
  const bool is_candidate = candidate.shape.is_room();
  const Placed3 &placed = is_candidate ? candidate : antagonist,
                &other = is_candidate ? antagonist : candidate;
  const FeatureId of_other = is_candidate ? against : feature;
  const Room3 room(placed);
  const int index = index_of(of_other);
  const Vec3 place = kind_of(of_other) == FeatureKind::vertex
                         ? other.point(index)
                         : place_on_rim(other, index, room, placed.pose.x);
  return room.gap(place - placed.pose.x) - other.shape.radius;
}

}  // namespace flyrock
