#pragma once
// What the forms share when they touch the ground in 3D: points on facets, one loop over edges and peaks, and
// the choice among all contacts.

#include <algorithm>
#include <span>
#include <vector>

#include "collision/ground/facet_region.h"
#include "collision/rules.h"
#include "geometry/ground.h"

namespace flyrock {

/// Two edges, or an edge and a rim, that penetrate by more than this share of the size are not the nearest
/// features any more.
inline constexpr double deepest_share = 0.05;

/// The facets near a contactor. The box is that of the contactor and its reach.
struct GroundNearby {
  const Ground3& ground;
  Box3 box;
  std::span<const Facet> facets;
  double shallow;  ///< m, see shallow_share
};

/// Appends the contacts with facets of a point grown by a radius: the centre of a sphere, or a vertex with
/// radius 0. A point below the plane of a facet is either in the ground, or above another part of it and
/// free.
void point_contacts(const Vec3& p, double radius, FeatureId feature, const Ground3& ground,
                    std::span<const Facet> facets, double reach, double shallow, Contacts<3>& out);

/// Drops the contacts from `begin` on of places with facets along whose normal the convex contactor comes
/// lower by more than `reach` [m], also when it has turned by `turn` [rad]. A facet cannot hold such a place:
/// it is on a convex edge, within reach of both facets there. One that has sunk deeper than `shallow` [m] has
/// the contact of the nearest facet.
void drop_unsupported(const Placed3& contactor, double reach, double turn, double shallow, std::size_t begin,
                      Contacts<3>& contacts);

/// Drops what is there twice, if edges and peaks were met, and keeps four contacts of each plane.
void reduce_contacts(Workspace& work, Contacts<3>& contacts, std::size_t begin, double size, bool has_rims);

/// Calls finder.rim(facet, i) for the convex edges of the facets that are near, and finder.peak(facet, i,
/// ground, edges) for each of their vertices once; peak() fills `edges` with those that leave it.
template <class Finder>
void at_rims_and_peaks(Workspace& work, const GroundNearby& nearby, Finder&& finder) {
  std::vector<std::uint64_t>& seen = work.vertices;
  std::vector<Vec3>& edges = work.edges;
  seen.clear();
  for (const Facet& f : nearby.facets) {
    if (!finder.near(f)) continue;
    for (int i = 0; i < 3; ++i) {
      if (f.rim[i] == Rim::convex && f.names_edge(i)) finder.rim(f, i);
      if (std::find(seen.begin(), seen.end(), f.vertex[i]) != seen.end()) continue;
      seen.push_back(f.vertex[i]);
      edges.clear();
      finder.peak(f, i, nearby.ground, edges);
    }
  }
}

/// Appends the contacts of a contactor with the ground: those of its points with facets, those that
/// more_on_facets(nearby) and, unless the ground is one plane, at_rims(nearby) append.
template <class AtRims, class MoreOnFacets = void (*)(const GroundNearby&)>
void contacts_on_ground(
    Workspace& work, const Placed3& contactor, const Ground3& ground, double reach, Contacts<3>& out,
    const AtRims& at_rims, const MoreOnFacets& more_on_facets = [](const GroundNearby&) {}) {
  const double radius = contactor.shape.radius, size = radius > 0 ? radius : contactor.shape.bound;
  std::vector<Facet>& facets = work.facets;
  Box3 box = core_box(contactor);
  box.low.array() -= radius + reach;
  box.high.array() += radius + reach;
  facets.clear();
  ground.facets(box, facets);
  const GroundNearby nearby{ground, box, facets, shallow_share * size};
  const std::size_t begin = out.size();
  for (int i = 0; i < contactor.count(); ++i)
    point_contacts(contactor.point(i), radius, contactor.id({FeatureKind::vertex, i}), ground, facets, reach,
                   nearby.shallow, out);
  more_on_facets(nearby);
  const bool has_rims = !facets.empty() && !facets.front().unbounded;
  if (has_rims) at_rims(nearby);
  reduce_contacts(work, out, begin, size, has_rims);
}

}  // namespace flyrock
