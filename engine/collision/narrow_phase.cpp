#include "collision/narrow_phase.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace flyrock {

namespace {

using Contacts = std::vector<ContactPoint<2>>;

/// The edge of `polygon` that separates the points of `other` most, and its separation [m]. The search ends
/// at an edge that separates by more than `reach`.
struct Separation {
  int edge = 0;
  double distance = -1e300;
};
Separation separation(const Placed2& polygon, const Placed2& other, double reach) {
  Separation best;
  const Vec2 away = polygon.pose.r.inverse(other.pose.x - polygon.pose.x);
  for (int e = 0; e < polygon.count() && best.distance <= reach; ++e) {
    const Vec2& normal = polygon.shape.normals[e];
    const Vec2 turned = other.pose.r.inverse(polygon.pose.r * normal);  // the normal in the frame of `other`
    double nearest = 1e300;
    for (const Vec2& point : other.shape.points) nearest = std::min(nearest, turned.dot(point));
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

void disk_disk(const Placed2& a, int ia, const Placed2& b, int ib, double reach, Contacts& out) {
  const Vec2 away = a.point(0) - b.point(0);
  const double distance = away.norm(), gap = distance - a.shape.radius - b.shape.radius;
  if (gap > reach) return;
  const Vec2 normal = distance > 0 ? Vec2(away / distance) : Vec2::UnitY();
  out.push_back(
      {b.point(0) + (b.shape.radius + 0.5 * gap) * normal, normal, gap, vertex_id(ia, 0), vertex_id(ib, 0)});
}

/// The contact of a disk with a polygon. The normal points to the disk.
bool disk_polygon(const Placed2& disk, const Placed2& polygon, double reach, ContactPoint<2>& contact,
                  int& feature, bool& on_edge) {
  const Vec2 centre = disk.point(0);
  const double radius = disk.shape.radius;
  const Separation face = separation(polygon, disk, reach + radius);
  if (face.distance - radius > reach) return false;
  const Vec2 p = polygon.point(face.edge), q = polygon.point((face.edge + 1) % polygon.count());
  const Vec2 along = q - p;
  const double s = (centre - p).dot(along) / along.squaredNorm();
  on_edge = face.distance <= 0 || (s >= 0 && s <= 1);
  feature = on_edge ? face.edge : s < 0 ? face.edge : (face.edge + 1) % polygon.count();
  double distance = face.distance;
  contact.normal = polygon.normal(face.edge);
  if (!on_edge) {
    const Vec2 away = centre - polygon.point(feature);
    distance = away.norm();
    contact.normal = away / distance;
  }
  contact.gap = distance - radius;
  contact.point = centre - (radius + 0.5 * contact.gap) * contact.normal;
  return contact.gap <= reach;
}

void polygon_polygon(const Placed2& a, int ia, const Placed2& b, int ib, double reach, Contacts& out) {
  const Separation of_a = separation(a, b, reach);
  if (of_a.distance > reach) return;
  const Separation of_b = separation(b, a, reach);
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
    const FeatureId incident_id = is_vertex ? vertex_id(a_is_reference ? ib : ia, vertex[k])
                                            : edge_id(a_is_reference ? ib : ia, facing);
    const int reference_vertex = clipped <= 0 ? edge : (edge + 1) % reference.count();
    const FeatureId reference_id = is_vertex ? edge_id(a_is_reference ? ia : ib, edge)
                                             : vertex_id(a_is_reference ? ia : ib, reference_vertex);
    const Vec2 middle = point - 0.5 * gap * normal;
    if (a_is_reference)
      out.push_back({middle, -normal, gap, reference_id, incident_id});
    else
      out.push_back({middle, normal, gap, incident_id, reference_id});
  }
}

}  // namespace

void body_contacts(const Placed2& candidate, int ic, const Placed2& antagonist, int ia, double reach,
                   Contacts& out) {
  const bool round_candidate = candidate.count() == 1, round_antagonist = antagonist.count() == 1;
  if (round_candidate && round_antagonist) return disk_disk(candidate, ic, antagonist, ia, reach, out);
  if (!round_candidate && !round_antagonist)
    return polygon_polygon(candidate, ic, antagonist, ia, reach, out);
  ContactPoint<2> contact;
  int feature = 0;
  bool on_edge = false;
  const Placed2& disk = round_candidate ? candidate : antagonist;
  const Placed2& polygon = round_candidate ? antagonist : candidate;
  if (!disk_polygon(disk, polygon, reach, contact, feature, on_edge)) return;
  const int polygon_index = round_candidate ? ia : ic;
  const FeatureId polygon_id = on_edge ? edge_id(polygon_index, feature) : vertex_id(polygon_index, feature);
  contact.feature = round_candidate ? vertex_id(ic, 0) : polygon_id;
  contact.against = round_candidate ? polygon_id : vertex_id(ia, 0);
  if (!round_candidate) contact.normal = -contact.normal;
  out.push_back(contact);
}

}  // namespace flyrock
