// Contacts of contactors with circles with the convex edges and peaks of the ground.

#include <algorithm>

#include "collision/core_contact.h"
#include "collision/facet_region.h"
#include "collision/facing.h"
#include "collision/ground_piece.h"
#include "collision/patch_contact.h"
#include "collision/rim_contact.h"

namespace flyrock {

void circle_rim_contacts(const Placed3& shape, int index, const Ground3& ground,
                         std::span<const Facet> facets, double reach, double turn,
                         std::vector<ContactPoint<3>>& out) {
  constexpr double deepest_share = 0.05;  // as in rim_contact.cpp
  const double slack = flush_angle + turn;
  thread_local std::vector<ContactPoint<3>> found;  // keep their memory between calls
  thread_local std::vector<std::uint64_t> seen;     // peaks, each of which many facets share
  thread_local std::vector<Vec3> edges;
  seen.clear();
  const auto is_deep = [&](const ContactPoint<3>& c) { return c.gap < -deepest_share * shape.shape.bound; };
  for (const Facet& f : facets) {
    if (f.normal.dot(shape.support(-f.normal) - f.corner[0]) - shape.shape.radius > reach) continue;
    for (int i = 0; i < 3; ++i) {
      if (f.rim[i] == Rim::convex && f.names_edge(i)) {
        found.clear();
        patch_contacts(shape, index, edge_piece(f, i), 0, reach, found);
        for (ContactPoint<3>& c : found) {
          // The end of an edge is a peak; two contacts lie along the edge.
          if (found.size() == 1 && kind_of(c.against) == FeatureKind::vertex) continue;
          if (is_deep(c) || !rim_cone_contains(f, i, c.normal, slack)) continue;
          c.against = f.edge_feature(i);
          out.push_back(c);
        }
      }
      if (std::find(seen.begin(), seen.end(), f.vertex[i]) != seen.end()) continue;
      seen.push_back(f.vertex[i]);
      edges.clear();
      if (!ground.peak(f.vertex[i], edges)) continue;
      found.clear();
      patch_contacts(shape, index, vertex_piece(f.corner[i]), 0, reach, found);
      for (ContactPoint<3>& c : found) {
        if (is_deep(c) || !peak_cone_contains(edges, c.normal, slack)) continue;
        c.against = f.vertex_feature(i);
        out.push_back(c);
      }
    }
  }
}

}  // namespace flyrock
