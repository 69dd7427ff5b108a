// Contacts of contactors with circles with the ground: places of rims with facets, and the part that faces a
// convex edge or a peak.
#include "collision/ground/ground_contact.h"
#include "collision/smooth/support_feature.h"

namespace flyrock {

namespace {

class CircleRimContacts {
 public:
  CircleRimContacts(Workspace& work, const Placed3& shape, double reach, double turn, Contacts<3>& out)
      : work_(work), shape_(shape), reach_(reach), slack_(flush_angle + turn), out_(out) {}

  bool near(const Facet& f) const {
    return f.normal.dot(shape_.support(-f.normal) - f.corner[0]) - shape_.shape.radius <= reach_;
  }

  void rim(const Facet& f, int i) {
    meet(edge_piece(work_, f, i), f.edge_feature(i), [&](const ContactPoint<3>& c, std::size_t count) {
      // The end of an edge is a peak; two contacts lie along the edge.
      return !(count == 1 && kind_of(c.against) == FeatureKind::vertex) &&
             rim_cone_contains(f, i, c.normal, slack_);
    });
  }

  void peak(const Facet& f, int i, const Ground3& ground, std::vector<Vec3>& edges) {
    if (ground.peak(f.vertex[i], edges))
      meet(vertex_piece(f.corner[i]), f.vertex_feature(i), [&](const ContactPoint<3>& c, std::size_t) {
        return peak_cone_contains(edges, c.normal, slack_);
      });
  }

 private:
  /// Keeps the contacts with a piece of the ground whose normals are in its cone.
  template <class InCone>
  void meet(const Placed3& piece, FeatureId against, const InCone& in_cone) {
    Contacts<3>& found = work_.found;
    found.clear();
    smooth_contacts(work_, shape_, piece, reach_, 0, found);
    for (ContactPoint<3>& c : found) {
      if (c.gap < -deepest_share * shape_.shape.bound || !in_cone(c, found.size())) continue;
      c.against = against;
      out_.push_back(c);
    }
  }

  Workspace& work_;
  const Placed3& shape_;
  double reach_, slack_;
  Contacts<3>& out_;
};

/// The places of the rims that are lowest over each facet, and turned from these: where a cap is level, all
/// of them are near.
void rim_places_on_facets(const Placed3& shape, const GroundNearby& nearby, double reach, Contacts<3>& out) {
  for (const Facet& f : nearby.facets)
    for (int k = 0; k < static_cast<int>(shape.shape.circles.size()); ++k)
      for (int i = 0; i < rim_places; ++i) {
        const Vec3 place = rim_place(shape, rim_index(k, i), -f.normal);
        if (f.distance(place) - shape.shape.radius > reach) {
          if (i == 0) break;  // the lowest one
          continue;
        }
        point_contacts(place, shape.shape.radius, shape.id({FeatureKind::edge, rim_index(k, i)}),
                       nearby.ground, {&f, 1}, reach, nearby.shallow, out);
      }
}

}  // namespace

void smooth_on_ground(Workspace& work, const Placed3& shape, const Ground3& ground, double reach, double turn,
                      Contacts<3>& out) {
  const std::size_t begin = out.size();
  contacts_on_ground(
      work, shape, ground, reach, out,
      [&](const GroundNearby& nearby) {
        drop_unsupported(shape, reach, flush_angle + turn, nearby.shallow, begin, out);
        at_rims_and_peaks(work, nearby, CircleRimContacts(work, shape, reach, turn, out));
      },
      [&](const GroundNearby& nearby) { rim_places_on_facets(shape, nearby, reach, out); });
}

}  // namespace flyrock
