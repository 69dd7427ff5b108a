// Contacts of spheres, the ends of pills and the vertices of polyhedra with the ground, and the choice among
// all contacts.

#include <algorithm>
#include <cmath>

#include "collision/contact_patch.h"
#include "collision/facet_region.h"
#include "collision/facing.h"
#include "collision/rim_contact.h"
#include "collision/terrain_contact.h"

namespace flyrock {

namespace {

using Contacts = std::vector<ContactPoint<3>>;

/// Contact points with facets, for a point grown by a radius: the centre of a sphere, or a vertex with radius
/// 0. A point below the plane of a facet is either in the ground, or above another part of it and free.
void point_contacts(const Vec3& p, double radius, FeatureId feature, const Ground3& ground,
                    std::span<const Facet> facets, double reach, double shallow, Contacts& out) {
  // On the side of a convex rim, a sphere has the contact of the edge, and a vertex has no other.
  const double slack = radius > 0 ? 1e-12 : region_slack;
  double depth = 0;
  for (const Facet& f : facets) {
    const double height = f.distance(p), gap = height - radius;
    if (gap > reach || !strip_contains(f, p, shallow, slack)) continue;
    if (!f.unbounded && height < 0 && nearer_beyond(f, p, height)) continue;
    if (!f.unbounded && height < -reach) {
      const double below = ground.depth(p);
      if (below <= 0) continue;
      if (height < -shallow) {
        depth = std::max(depth, below);
        continue;
      }
    }
    out.push_back({p - (radius + 0.5 * gap) * f.normal, f.normal, gap, feature, f.face_feature()});
  }
  if (depth == 0) return;
  const auto nearest = ground.nearest(p, depth * (1 + region_slack));
  if (!nearest || nearest->distance < shallow) return;  // it has this contact
  const Facet f = ground.facet(nearest->facet);
  const double gap = -nearest->distance - radius;
  out.push_back({p - (radius + 0.5 * gap) * f.normal, f.normal, gap, feature, f.face_feature()});
}

/// Drops contacts that an earlier one repeats: at the same place, or of the same vertex, with the same
/// normal. Facets of one plane give them at their common edges, and a vertex that stands on an edge does.
void drop_repeated(Contacts& contacts, std::size_t begin, double size) {
  const auto repeats = [&](const ContactPoint<3>& a, const ContactPoint<3>& b) {
    const double turned = (a.normal - b.normal).squaredNorm();
    if (a.feature == b.feature && kind_of(a.feature) == FeatureKind::vertex && turned < 1e-16) return true;
    return turned < 1e-12 && (a.point - b.point).squaredNorm() < 1e-14 * size * size;
  };
  std::size_t to = begin;
  for (std::size_t from = begin; from < contacts.size(); ++from) {
    const bool known = std::any_of(contacts.begin() + begin, contacts.begin() + to,
                                   [&](const ContactPoint<3>& c) { return repeats(c, contacts[from]); });
    if (!known) contacts[to++] = contacts[from];
  }
  contacts.resize(to);
}

/// Keeps four contacts of each plane, in the order in which the planes were found.
void keep_four_of_each_plane(Contacts& contacts, std::size_t begin, double size) {
  if (contacts.size() - begin <= 4) return;
  const auto one_plane = [&](const ContactPoint<3>& a, const ContactPoint<3>& b) {
    return (a.normal - b.normal).squaredNorm() < 1e-12 &&
           std::abs(a.normal.dot(a.point - b.point)) < 1e-6 * size;
  };
  thread_local Contacts rest, others, kept;  // keep their memory between calls
  rest.assign(contacts.begin() + begin, contacts.end());
  kept.clear();
  while (!rest.empty()) {
    others.clear();
    const std::size_t plane = kept.size();
    for (const ContactPoint<3>& contact : rest)
      (one_plane(rest.front(), contact) ? kept : others).push_back(contact);
    keep_four(kept, plane);
    rest.swap(others);
  }
  contacts.resize(begin);
  contacts.insert(contacts.end(), kept.begin(), kept.end());
}

}  // namespace

namespace {

Box3 box_of_core(const Placed3& contactor) {
  if (contactor.shape.has_circles()) return core_box(contactor);
  Box3 box{contactor.point(0), contactor.point(0)};
  for (int i = 1; i < contactor.count(); ++i) {
    const Vec3 p = contactor.point(i);
    box = {box.low.cwiseMin(p), box.high.cwiseMax(p)};
  }
  return box;
}

/// The places of the rims that are lowest over each facet, and turned from these: where a cap is level, all
/// of them are near.
void rim_contacts_with_facets(const Placed3& shape, int index, const Ground3& ground,
                              std::span<const Facet> facets, double reach, double shallow, Contacts& out) {
  for (const Facet& f : facets)
    for (int k = 0; k < static_cast<int>(shape.shape.circles.size()); ++k)
      for (int i = 0; i < rim_places; ++i) {
        const Vec3 place = rim_place(shape, rim_index(k, i), -f.normal);
        if (f.distance(place) - shape.shape.radius > reach) {
          if (i == 0) break;  // the lowest one
          continue;
        }
        point_contacts(place, shape.shape.radius, feature_id(index, FeatureKind::edge, rim_index(k, i)),
                       ground, {&f, 1}, reach, shallow, out);
      }
}

}  // namespace

void terrain_contacts(const Placed3& contactor, int contactor_index, const Ground3& ground, double reach,
                      double turn, std::vector<ContactPoint<3>>& out) {
  const Contactor3& shape = contactor.shape;
  if (shape.is_room()) return;
  Box3 box = box_of_core(contactor);
  const double grow = shape.radius + reach;
  box.low.array() -= grow;
  box.high.array() += grow;
  thread_local std::vector<Facet> facets;  // keeps its memory between calls
  facets.clear();
  ground.facets(box, facets);
  const bool only_points = shape.only_points();
  const double size = shape.has_faces() || shape.has_circles() || only_points ? shape.bound : shape.radius;
  const std::size_t begin = out.size();
  for (int i = 0; i < contactor.count(); ++i) {
    const FeatureId vertex = feature_id(contactor_index, FeatureKind::vertex, i);
    point_contacts(contactor.point(i), shape.radius, vertex, ground, facets, reach, shallow_share * size,
                   out);
  }
  if (shape.has_circles())
    rim_contacts_with_facets(contactor, contactor_index, ground, facets, reach, shallow_share * size, out);
  if (!facets.empty() && !facets.front().unbounded) {
    if (shape.has_circles())
      circle_rim_contacts(contactor, contactor_index, ground, facets, reach, turn, out);
    else if (!shape.has_faces() && !only_points)
      core_rim_contacts(contactor, contactor_index, ground, facets, reach, turn, out);
    else if (!only_points)
      rim_contacts(contactor, contactor_index, ground, facets, box, reach, turn, out);
    drop_repeated(out, begin, size);
  }
  keep_four_of_each_plane(out, begin, size);
}

}  // namespace flyrock
