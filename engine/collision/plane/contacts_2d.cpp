// Contacts of balls, pills and hulls in 2D.

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "collision/rules.h"

namespace flyrock {

namespace {

/// The edge of `polygon` that separates `points`, at their pose, most, and its separation [m]. The search
/// ends at an edge that separates by more than `reach`.
struct Separation {
  int edge = 0;
  double distance = -1e300;
};
Separation separation(const Placed2& polygon, const Pose2& pose, std::span<const Vec2> points, double reach) {
  Separation best;
  const Vec2 away = polygon.pose.r.inverse(pose.x - polygon.pose.x);
  for (int e = 0; e < polygon.count() && best.distance <= reach; ++e) {
    const Vec2& normal = polygon.shape.normals[e];
    const Vec2 turned = pose.r.inverse(polygon.pose.r * normal);  // the normal in the frame of the points
    double nearest = 1e300;
    for (const Vec2& point : points) nearest = std::min(nearest, turned.dot(point));
    nearest += normal.dot(away - polygon.shape.points[e]);
    if (nearest > best.distance) best = {e, nearest};
  }
  return best;
}

/// The edge of `polygon` whose normal is most opposite to `direction`.
int facing_edge(const Placed2& polygon, const Vec2& direction) {
  int edge = 0;
  double least = 1e300;
  for (int e = 0; e < polygon.count(); ++e)
    if (const double along = polygon.normal(e).dot(direction); along < least) least = along, edge = e;
  return edge;
}

/// The place of the core of a hull that is nearest to a point.
struct NearestPlace {
  double distance = 1e300;      ///< m, negative inside
  Vec2 normal = Vec2::UnitY();  ///< unit, towards the point
  bool on_edge = false;
  int feature = 0;  ///< the edge or the vertex
};
NearestPlace nearest_place(const Placed2& hull, const Placed2& other, int vertex, double reach) {
  const Vec2 point = other.point(vertex);
  const Separation face = separation(hull, other.pose, {&other.shape.points[vertex], 1}, reach);
  if (face.distance > reach) return {};
  const int next = (face.edge + 1) % hull.count();
  const Vec2 p = hull.point(face.edge), q = hull.point(next), along = q - p;
  const double s = (point - p).dot(along) / along.squaredNorm();
  const bool inside = hull.count() > 2 && face.distance <= 0;
  if (inside || (s >= 0 && s <= 1)) return {face.distance, hull.normal(face.edge), true, face.edge};
  const int corner = s < 0 ? face.edge : next;
  const Vec2 away = point - hull.point(corner);
  const double distance = away.norm();
  return {distance, distance > 0 ? Vec2(away / distance) : hull.normal(face.edge), false, corner};
}

FeatureId feature_of(const NearestPlace& place, const Placed2& hull) {
  return place.on_edge ? hull.edge(place.feature) : hull.vertex(place.feature);
}

/// The contacts of two hulls of which one or both are grown by a radius. A vertex of one is nearest to the
/// other; where it is nearest to an edge, and its own edge lies flush on that one, there is a second contact
/// at the other end of what is common.
class GrownContacts {
 public:
  GrownContacts(const Placed2& a, const Placed2& b, double reach, Contacts<2>& out)
      : a_(a), b_(b), reach_(reach), radii_(a.shape.radius + b.shape.radius), out_(out) {}

  void find() {
    if (cores_meet()) return;
    NearestPlace nearest;
    int vertex = 0;
    bool of_a = true;
    const auto try_vertices = [&](const Placed2& points, const Placed2& hull, bool are_of_a) {
      for (int i = 0; i < points.count(); ++i) {
        const NearestPlace place = nearest_place(hull, points, i, reach_ + radii_);
        if (place.distance < nearest.distance) nearest = place, vertex = i, of_a = are_of_a;
      }
    };
    try_vertices(a_, b_, true);
    try_vertices(b_, a_, false);
    if (nearest.distance - radii_ > reach_) return;
    const Placed2 &own = of_a ? a_ : b_, &other = of_a ? b_ : a_;
    emit(own.point(vertex), nearest.normal, nearest.distance, own.vertex(vertex), feature_of(nearest, other),
         of_a);
    if (nearest.on_edge && nearest.distance > 0) second(own, vertex, other, nearest.feature, of_a);
  }

 private:
  /// Cores that overlap, which only fixed time steps produce, are pushed apart along the edge that separates
  /// most.
  bool cores_meet() {
    const double most = reach_ + radii_;
    const Separation of_a = separation(a_, b_.pose, b_.shape.points, most);
    const Separation of_b = separation(b_, a_.pose, a_.shape.points, most);
    if (std::max(of_a.distance, of_b.distance) >= 0) return false;
    const bool a_is_reference = of_a.distance > of_b.distance;
    const Placed2 &reference = a_is_reference ? a_ : b_, &other = a_is_reference ? b_ : a_;
    const Separation& by = a_is_reference ? of_a : of_b;
    int deepest = 0;
    for (int i = 1; i < other.count(); ++i)
      if (reference.outside(by.edge, other.point(i)) < reference.outside(by.edge, other.point(deepest)))
        deepest = i;
    emit(other.point(deepest), reference.normal(by.edge), by.distance, other.vertex(deepest),
         reference.edge(by.edge), !a_is_reference);
    return true;
  }

  void second(const Placed2& own, int vertex, const Placed2& other, int edge, bool own_is_a) {
    const Vec2 normal = other.normal(edge), start = other.point(edge);
    const int facing = facing_edge(own, normal), next = (facing + 1) % own.count();
    if (facing != vertex && next != vertex) return;
    const int end = facing == vertex ? next : facing;
    const Vec2 from = own.point(vertex), along = own.point(end) - from;
    if (std::abs(normal.dot(along)) > flush_angle * along.norm()) return;
    const int last = (edge + 1) % other.count();
    const Vec2 side = other.point(last) - start;
    const double s = (from + along - start).dot(side) / side.squaredNorm();
    if (s >= 0 && s <= 1) {
      emit(from + along, normal, normal.dot(from + along - start), own.vertex(end), other.edge(edge),
           own_is_a);
      return;
    }
    // The edge of the other one ends here.
    const int corner = s < 0 ? edge : last;
    const double t = (other.point(corner) - from).dot(along) / along.squaredNorm();
    if (t < 1e-6) return;
    const Vec2 place = from + t * along;
    emit(place, normal, normal.dot(place - start), own.edge(facing), other.vertex(corner), own_is_a);
  }

  /// A contact at a place of the core of a or b, at a distance from the other core; the normal points to this
  /// core.
  void emit(const Vec2& place, const Vec2& normal, double distance, FeatureId own, FeatureId others,
            bool own_is_a) {
    const double gap = distance - radii_;
    if (gap > reach_) return;
    const Vec2 point = place - ((own_is_a ? a_ : b_).shape.radius + 0.5 * gap) * normal;
    if (own_is_a)
      out_.push_back({point, normal, gap, own, others});
    else
      out_.push_back({point, -normal, gap, others, own});
  }

  const Placed2& a_;
  const Placed2& b_;
  double reach_, radii_;
  Contacts<2>& out_;
};

void sharp_contacts(const Placed2& a, const Placed2& b, double reach, Contacts<2>& out) {
  const Separation of_a = separation(a, b.pose, b.shape.points, reach);
  if (of_a.distance > reach) return;
  const Separation of_b = separation(b, a.pose, a.shape.points, reach);
  if (of_b.distance > reach) return;
  // The preference for b keeps the reference edge from flickering when both separations are equal.
  const double slack = 1e-9 * a.shape.points[0].norm();
  const bool a_is_reference = of_a.distance > of_b.distance + slack;
  const Placed2& reference = a_is_reference ? a : b;
  const Placed2& incident = a_is_reference ? b : a;
  const int edge = a_is_reference ? of_a.edge : of_b.edge;
  const Vec2 normal = reference.normal(edge);
  const Vec2 start = reference.point(edge), end = reference.point((edge + 1) % reference.count());
  const Vec2 tangent = (end - start).normalized();
  const double length = (end - start).norm();

  const int facing = facing_edge(incident, normal);
  const int next = (facing + 1) % incident.count();
  const std::array<Vec2, 2> ends{incident.point(facing), incident.point(next)};
  const std::array<int, 2> vertex{facing, next};
  const double s0 = (ends[0] - start).dot(tangent), s1 = (ends[1] - start).dot(tangent);
  for (int k = 0; k < 2; ++k) {
    const double s = k == 0 ? s0 : s1;
    const double clipped = std::clamp(s, 0.0, length);
    Vec2 point = ends[k];
    bool is_vertex = true;
    if (std::abs(clipped - s) > 1e-9 * length) {
      // Cut the incident edge at the side of the strip. The feature there is the vertex of the reference
      // edge.
      if (std::min(s0, s1) >= length || std::max(s0, s1) <= 0) continue;
      point = ends[0] + (clipped - s0) / (s1 - s0) * (ends[1] - ends[0]);
      is_vertex = false;
    }
    const double gap = normal.dot(point - start);
    if (gap > reach) continue;
    const FeatureId incident_id = is_vertex ? incident.vertex(vertex[k]) : incident.edge(facing);
    const int reference_vertex = clipped <= 0 ? edge : (edge + 1) % reference.count();
    const FeatureId reference_id = is_vertex ? reference.edge(edge) : reference.vertex(reference_vertex);
    const Vec2 middle = point - 0.5 * gap * normal;
    if (a_is_reference)
      out.push_back({middle, -normal, gap, reference_id, incident_id});
    else
      out.push_back({middle, normal, gap, incident_id, reference_id});
  }
}

}  // namespace

void ball_contacts(Workspace&, const Placed2& a, const Placed2& b, double reach, double, Contacts<2>& out) {
  const Vec2 away = a.point(0) - b.point(0);
  const double distance = away.norm(), gap = distance - a.shape.radius - b.shape.radius;
  if (gap > reach || a.shape.radius + b.shape.radius == 0) return;  // two points do not meet
  const Vec2 normal = distance > 0 ? Vec2(away / distance) : Vec2::UnitY();
  out.push_back({b.point(0) + (b.shape.radius + 0.5 * gap) * normal, normal, gap, a.vertex(0), b.vertex(0)});
}

void core_contacts(Workspace&, const Placed2& disk, const Placed2& hull, double reach, double,
                   Contacts<2>& out) {
  const double radius = disk.shape.radius, grown = hull.shape.radius;
  const NearestPlace place = nearest_place(hull, disk, 0, reach + radius + grown);
  const double gap = place.distance - radius - grown;
  if (gap > reach) return;
  const Vec2 point = disk.point(0) - (radius + 0.5 * gap) * place.normal;
  out.push_back({point, place.normal, gap, disk.vertex(0), feature_of(place, hull)});
}

void hull_contacts(Workspace&, const Placed2& a, const Placed2& b, double reach, double, Contacts<2>& out) {
  if (a.shape.radius + b.shape.radius > 0)
    GrownContacts(a, b, reach, out).find();
  else
    sharp_contacts(a, b, reach, out);
}

}  // namespace flyrock
