// Contact points of two convex polyhedra.

#include <algorithm>
#include <boost/container/static_vector.hpp>

#include "collision/hull/separating_axis.h"
#include "collision/manifold_reduction.h"
#include "collision/rules.h"

namespace flyrock {

namespace {

/// One contact, at the middle of the shortest line between the two edges.
void edge_edge(const Placed3& a, const Placed3& b, const EdgeAxis& axis, Contacts<3>& out) {
  const Contactor3::Edge &ea = a.shape.edges[axis.of_a], &eb = b.shape.edges[axis.of_b];
  const Vec3 pa = a.point(ea.start), pb = b.point(eb.start);
  const Vec3 da = a.point(ea.end) - pa, db = b.point(eb.end) - pb, away = pa - pb;
  const double aa = da.squaredNorm(), bb = db.squaredNorm(), ab = da.dot(db);
  const double s = std::clamp((ab * db.dot(away) - bb * da.dot(away)) / (aa * bb - ab * ab), 0.0, 1.0);
  const double t = std::clamp((ab * s + db.dot(away)) / bb, 0.0, 1.0);
  out.push_back({0.5 * (pa + s * da + pb + t * db), -axis.normal, axis.separation,
                 a.id({FeatureKind::edge, axis.of_a}), b.id({FeatureKind::edge, axis.of_b})});
}

/// A corner of the incident face while it is clipped: the features that define it, and the line to the next
/// corner.
struct Corner {
  Vec3 point;
  FeatureKind of_reference = FeatureKind::face;  ///< face: the corner is a vertex of the incident face
  int reference = 0;                             ///< the face, edge or vertex
  int incident = 0;                              ///< the vertex, edge or face
  int line = 0;  ///< edge of the incident shape, or -1 - k on side k of the reference
};
using Polygon = boost::container::static_vector<Corner, 2 * Contactor3::most_face_vertices + 8>;

/// The corner that results where side k of the reference face cuts the line that starts at `from`.
Corner cut(const Corner& from, const Vec3& point, const Contactor3& reference, const Contactor3::Face& face,
           int k, int incident_face) {
  if (from.line >= 0) return {point, FeatureKind::edge, reference.loop_edge[face.first + k], from.line, 0};
  const int side = -1 - from.line;
  const int corner = (k + 1) % face.count == side ? side : k;
  return {point, FeatureKind::vertex, reference.vertex(face, corner), incident_face, 0};
}

Polygon clipped_face(const Placed3& reference, int face_index, const Placed3& incident, int incident_face) {
  const Contactor3::Face &face = reference.shape.faces[face_index],
                         &other = incident.shape.faces[incident_face];
  Polygon polygon;
  for (int i = 0; i < other.count; ++i)
    polygon.push_back({incident.corner(incident_face, i), FeatureKind::face, face_index,
                       incident.shape.vertex(other, i), incident.shape.loop_edge[other.first + i]});
  const Vec3 normal = reference.normal(face_index);
  for (int k = 0; k < face.count && !polygon.empty(); ++k) {
    const Vec3 start = reference.corner(face_index, k);
    const Vec3 along = reference.corner(face_index, (k + 1) % face.count) - start;
    const Vec3 outward = along.cross(normal) / along.norm();
    const double slack = 1e-9 * along.norm();  // a vertex on the side stays a vertex
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Corner &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
      const double d = outward.dot(from.point - start), e = outward.dot(to.point - start);
      const bool from_inside = d <= slack, to_inside = e <= slack;
      if (from_inside) kept.push_back(from);
      if (from_inside == to_inside) continue;
      Corner corner = cut(from, from.point + (d - slack) / (d - e) * (to.point - from.point), reference.shape,
                          face, k, incident_face);
      corner.line = from_inside ? -1 - k : from.line;
      kept.push_back(corner);
    }
    polygon = kept;
  }
  return polygon;
}

/// The incident face, which faces a reference face with normal n. Among the faces at the vertex that reaches
/// furthest against n, it is the one whose normal is most opposite to n.
int incident_face_of(const Placed3& incident, const Vec3& normal) {
  const Contactor3& shape = incident.shape;
  const Vec3 local = incident.pose.r.inverse(normal);
  int nearest = 0;
  for (int i = 1; i < incident.count(); ++i)
    if (local.dot(shape.points[i]) < local.dot(shape.points[nearest])) nearest = i;
  int best = 0;
  double least = 2;
  for (int f = 0; f < incident.faces(); ++f) {
    const double along = local.dot(shape.faces[f].normal);
    if (along >= least) continue;
    const auto* loop = &shape.loop[shape.faces[f].first];
    if (std::find(loop, loop + shape.faces[f].count, nearest) != loop + shape.faces[f].count)
      least = along, best = f;
  }
  return best;
}

/// Whether the common normal of an edge of the reference and an edge of the incident shape is far from the
/// normal of the reference face: the two pass each other along the side of the face, and where they cross
/// says little about where the bodies meet.
bool pass_along(const Placed3& reference, int edge, const Placed3& incident, int incident_edge,
                const Vec3& normal) {
  constexpr double cos_15_degrees = 0.9659258262890683;
  const auto along = [](const Placed3& shape, int e) {
    return Vec3(shape.point(shape.shape.edges[e].end) - shape.point(shape.shape.edges[e].start));
  };
  const Vec3 across = along(reference, edge).cross(along(incident, incident_edge));
  return std::abs(across.dot(normal)) < cos_15_degrees * across.norm();
}

void face_face(const Placed3& reference, int face, const Placed3& incident, bool reference_is_candidate,
               double reach, Contacts<3>& out) {
  const Vec3 normal = reference.normal(face), start = reference.corner(face, 0);
  const Polygon corners = clipped_face(reference, face, incident, incident_face_of(incident, normal));
  const auto gap_of = [&](const Corner& corner) { return normal.dot(corner.point - start); };
  const auto passes = [&](const Corner& corner) {
    return corner.of_reference == FeatureKind::edge &&
           pass_along(reference, corner.reference, incident, corner.incident, normal);
  };
  double deepest = reach;
  for (const Corner& corner : corners)
    if (const double gap = gap_of(corner); gap < deepest && !passes(corner)) deepest = gap;
  const std::size_t begin = out.size();
  for (const Corner& corner : corners) {
    const double gap = gap_of(corner);
    if (gap > reach || (gap >= deepest && passes(corner))) continue;
    const FeatureKind of_incident = corner.of_reference == FeatureKind::face   ? FeatureKind::vertex
                                    : corner.of_reference == FeatureKind::edge ? FeatureKind::edge
                                                                               : FeatureKind::face;
    const FeatureId of_r = reference.id({corner.of_reference, corner.reference});
    const FeatureId of_i = incident.id({of_incident, corner.incident});
    const Vec3 middle = corner.point - 0.5 * gap * normal;
    if (reference_is_candidate)
      out.push_back({middle, -normal, gap, of_r, of_i});
    else
      out.push_back({middle, normal, gap, of_i, of_r});
  }
  keep_four(out, begin);
}

}  // namespace

void hull_contacts(Workspace&, const Placed3& a, const Placed3& b, double reach, double, Contacts<3>& out) {
  const FaceAxis of_a = best_face_axis(a, b);
  if (of_a.separation > reach) return;
  const FaceAxis of_b = best_face_axis(b, a);
  if (of_b.separation > reach) return;
  const double of_faces = std::max(of_a.separation, of_b.separation);
  const EdgeAxis edges = best_edge_axis(a, b, of_faces);
  if (edges.separation > reach) return;
  const double slack = flush_angle * std::min(a.shape.bound, b.shape.bound);
  const std::size_t begin = out.size();
  if (edges.separation <= of_faces + slack) {
    if (of_b.separation > of_a.separation + slack)
      face_face(b, of_b.face, a, false, reach, out);
    else
      face_face(a, of_a.face, b, true, reach, out);
  }
  // A face with nearly the same separation may give no contact point, because the two edges cross outside it.
  if (out.size() == begin && edges.separation > of_faces) edge_edge(a, b, edges, out);
}

}  // namespace flyrock
