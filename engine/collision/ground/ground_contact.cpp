// Contacts of spheres, the ends of pills and the vertices of polyhedra with the ground, and the choice among
// all contacts.

#include "collision/ground/ground_contact.h"

#include <algorithm>
#include <cmath>

#include "collision/manifold_reduction.h"

namespace flyrock {

namespace {

/// Drops contacts that an earlier one repeats: at the same place, or of the same vertex, with the same
/// normal. Facets of one plane give them at their common edges, and a vertex that stands on an edge does.
void drop_repeated(Contacts<3>& contacts, std::size_t begin, double size) {
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
void keep_four_of_each_plane(Workspace& work, Contacts<3>& contacts, std::size_t begin, double size) {
  if (contacts.size() - begin <= 4) return;
  const auto one_plane = [&](const ContactPoint<3>& a, const ContactPoint<3>& b) {
    return (a.normal - b.normal).squaredNorm() < 1e-12 &&
           std::abs(a.normal.dot(a.point - b.point)) < 1e-6 * size;
  };
  Contacts<3>&rest = work.rest, &others = work.of_other_planes, &kept = work.kept;
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

void point_contacts(const Vec3& p, double radius, FeatureId feature, const Ground3& ground,
                    std::span<const Facet> facets, double reach, double shallow, Contacts<3>& out) {
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

void drop_unsupported(const Placed3& contactor, double reach, double turn, double shallow, std::size_t begin,
                      Contacts<3>& contacts) {
  const double lower = reach + turn * 2 * contactor.shape.bound;
  const auto is_above_others = [&](const ContactPoint<3>& c) {
    const double height = c.normal.dot(c.point) + contactor.shape.radius + 0.5 * c.gap;
    return c.gap >= -shallow && height - c.normal.dot(contactor.support(-c.normal)) > lower;
  };
  contacts.erase(std::remove_if(contacts.begin() + begin, contacts.end(), is_above_others), contacts.end());
}

void reduce_contacts(Workspace& work, Contacts<3>& contacts, std::size_t begin, double size, bool has_rims) {
  if (has_rims) drop_repeated(contacts, begin, size);
  keep_four_of_each_plane(work, contacts, begin, size);
}

void cloud_on_ground(Workspace& work, const Placed3& cloud, const Ground3& ground, double reach, double,
                     Contacts<3>& out) {
  contacts_on_ground(work, cloud, ground, reach, out, [](const GroundNearby&) {});
}

}  // namespace flyrock
