// Contacts of polyhedra with the ground: edges with convex edges of the ground, faces with its peaks.

#include <algorithm>
#include <cmath>

#include "collision/ground/ground_contact.h"
#include "collision/rules.h"

namespace flyrock {

namespace {

class RimContacts {
 public:
  RimContacts(Workspace& work, const Placed3& polyhedron, const Box3& box, double reach, double slack,
              Contacts<3>& out)
      : p_(polyhedron), box_(box), reach_(reach), slack_(slack), out_(out), rise_(work.rises) {}

  /// Whether the polyhedron comes within reach of the plane of a facet. Otherwise nothing of the facet can
  /// touch it.
  bool near(const Facet& f) const { return lowest_along(f.normal, f.corner[0]) <= reach_; }

  /// All edges of the polyhedron with rim i of a facet.
  void rim(const Facet& f, int i) {
    const Vec3 &from = f.corner[i], &to = f.corner[Facet::next(i)], along = to - from;
    const Box3 box{from.cwiseMin(to), from.cwiseMax(to)};
    if (!box_.overlaps(box) || lowest_along(f.beyond[i], from) > reach_) return;
    const Contactor3& shape = p_.shape;
    const Vec3 upward = p_.pose.r.inverse(f.normal + f.beyond[i]), local = p_.pose.r.inverse(along);
    rise_.clear();
    for (const Contactor3::Face& face : shape.faces) rise_.push_back(local.dot(face.normal));
    const double level = slack_ * along.norm();
    for (int e = 0; e < static_cast<int>(shape.edges.size()); ++e) {
      const Contactor3::Edge& edge = shape.edges[e];
      // The normal across both edges lies between those of the two faces only if the rim enters one and
      // leaves the other.
      const double left = rise_[edge.left], right = rise_[edge.right];
      if (std::min(left, right) > level || std::max(left, right) < -level) continue;
      const Vec3 direction = shape.points[edge.end] - shape.points[edge.start];
      Vec3 normal = local.cross(direction);
      const double length = normal.norm(), scale = direction.norm();
      if (length <= parallel_sine * along.norm() * scale) continue;
      normal /= normal.dot(upward) < 0 ? -length : length;
      // The outward directions of the polyhedron at this edge contain -normal: both faces fall away from it.
      const double most = slack_ * scale;
      if (-normal.dot(shape.faces[edge.left].normal.cross(direction)) > most ||
          -normal.dot(direction.cross(shape.faces[edge.right].normal)) > most)
        continue;
      const Vec3 world = p_.pose.r * normal;
      if (!rim_cone_contains(f, i, world, slack_)) continue;
      cross(f, i, e, world);
    }
  }

  /// The faces of the polyhedron with a peak.
  void peak(const Facet& f, int i, const Ground3& ground, std::vector<Vec3>& edges) {
    const Vec3& top = f.corner[i];
    if (((top - box_.low).array() < 0).any() || ((box_.high - top).array() < 0).any()) return;
    int face = 0;
    double gap = -1e300;
    for (int k = 0; k < p_.faces() && gap <= reach_; ++k)
      if (const double outside = p_.outside(k, top); outside > gap) gap = outside, face = k;
    if (gap > reach_ || !is_over(face, top, gap)) return;
    const Vec3 normal = -p_.normal(face);
    if (!ground.peak(f.vertex[i], edges) || !peak_cone_contains(edges, normal, slack_)) return;
    out_.push_back(
        {top + 0.5 * gap * normal, normal, gap, p_.id({FeatureKind::face, face}), f.vertex_feature(i)});
  }

 private:
  // Edges whose angle has a smaller sine than this are parallel; vertices then give the contacts.
  static constexpr double parallel_sine = 1e-6;
  // Of the size: an edge in a notch of a ridge touches both of its legs. While it slides along one of them,
  // its place on the other is so little beyond the end.
  static constexpr double notch_share = 1e-5;

  /// How far the polyhedron lies above the plane through `on` [m].
  double lowest_along(const Vec3& normal, const Vec3& on) const {
    const Vec3 local = p_.pose.r.inverse(normal);
    double least = 1e300;
    for (const Vec3& point : p_.shape.points) least = std::min(least, local.dot(point));
    return least + normal.dot(p_.pose.x - on);
  }

  /// Whether a place faces a face at a distance, and not the edge or vertex beside it. A place in the
  /// polyhedron always does.
  bool is_over(int face, const Vec3& place, double distance) const {
    if (distance <= 0) return true;
    const Vec3 foot = place - distance * p_.normal(face);
    for (int k = 0; k < p_.faces(); ++k)
      if (p_.outside(k, foot) > region_slack * p_.shape.bound) return false;
    return true;
  }

  /// One contact where two edges cross, at the middle of the shortest line between them.
  void cross(const Facet& f, int i, int e, const Vec3& normal) {
    const Contactor3::Edge& edge = p_.shape.edges[e];
    const Vec3 a = p_.point(edge.start), da = p_.point(edge.end) - a;
    const Vec3 &b = f.corner[i], db = f.along(i), away = a - b;
    const double gap = normal.dot(away);
    if (gap > reach_ || gap < -deepest_share * p_.shape.bound) return;
    const double aa = da.squaredNorm(), bb = db.squaredNorm(), ab = da.dot(db);
    const double s = (ab * db.dot(away) - bb * da.dot(away)) / (aa * bb - ab * ab);
    const double t = (ab * s + db.dot(away)) / bb;
    const double beyond = notch_share * p_.shape.bound / std::sqrt(bb);
    if (s < -region_slack || s > 1 + region_slack || t < -beyond || t > 1 + beyond) return;
    out_.push_back(
        {0.5 * (a + s * da + b + t * db), normal, gap, p_.id({FeatureKind::edge, e}), f.edge_feature(i)});
  }

  const Placed3& p_;
  const Box3& box_;
  double reach_, slack_;
  Contacts<3>& out_;
  std::vector<double>& rise_;  ///< of each face along the rim
};

}  // namespace

void hull_on_ground(Workspace& work, const Placed3& polyhedron, const Ground3& ground, double reach,
                    double turn, Contacts<3>& out) {
  const double slack = flush_angle + turn;
  const std::size_t begin = out.size();
  contacts_on_ground(work, polyhedron, ground, reach, out, [&](const GroundNearby& nearby) {
    drop_unsupported(polyhedron, reach, slack, nearby.shallow, begin, out);
    at_rims_and_peaks(work, nearby, RimContacts(work, polyhedron, nearby.box, reach, slack, out));
  });
}

}  // namespace flyrock
