// Contacts of a sphere or a pill with a ball, a pill or a polyhedron.

#include <algorithm>
#include <array>
#include <cmath>

#include "collision/pill/closest.h"
#include "collision/rules.h"

namespace flyrock {

namespace {

/// Normals point to the core.
class CoreContacts {
 public:
  CoreContacts(const Placed3& core, const Placed3& other, double reach, Contacts<3>& out)
      : core_(core), other_(other), reach_(reach), out_(out) {}

  void find() {
    const Closest nearest = closest(core_, other_);
    if (nearest.distance - core_.shape.radius - other_.shape.radius > reach_) return;
    if (core_.count() > 1 && lies_flush(nearest)) return;
    emit(nearest.on_a, nearest.normal, nearest.distance, nearest.of_a, nearest.of_b);
  }

 private:
  /// A part of the axis of the pill, with the features of both contactors at its two ends.
  struct Span {
    double low = 0, high = 1;
    ShapeFeature of_core[2] = {{FeatureKind::vertex, 0}, {FeatureKind::vertex, 1}};
    ShapeFeature of_other[2];

    /// Cuts at the place s, where a feature of the other contactor ends.
    void cut(bool at_high, double s, const ShapeFeature& by) {
      if (at_high ? s >= high : s <= low) return;
      (at_high ? high : low) = s;
      of_core[at_high] = {FeatureKind::edge, 0};
      of_other[at_high] = by;
    }
    bool is_short() const { return high - low < 1e-6; }
  };

  bool lies_flush(const Closest& nearest) {
    start_ = core_.point(0);
    axis_ = core_.point(1) - start_;
    length_ = axis_.norm();
    if (std::abs(nearest.normal.dot(axis_)) > flush_angle * length_) return false;
    if (other_.shape.faces.empty())
      return other_.count() > 1 && along_edge(0, {0, 1}) && nearest.distance > 0;
    for (int f = 0; f < other_.faces(); ++f)
      if ((other_.normal(f) - nearest.normal).squaredNorm() < flush_angle * flush_angle && on_face(f))
        return true;
    for (int e = 0; e < static_cast<int>(other_.shape.edges.size()); ++e)
      if (belongs(nearest.of_b, e) && nearest.distance > 0 &&
          along_edge(e, {other_.shape.edges[e].start, other_.shape.edges[e].end}))
        return true;
    return false;
  }

  bool belongs(const ShapeFeature& feature, int e) const {
    const Contactor3::Edge& edge = other_.shape.edges[e];
    return feature.kind == FeatureKind::edge ? feature.index == e
                                             : feature.index == edge.start || feature.index == edge.end;
  }

  /// Two contacts at the ends of what is common to the axis and a parallel edge of the other contactor.
  bool along_edge(int edge, const std::array<int, 2>& ends) {
    const Vec3 from = other_.point(ends[0]), along = other_.point(ends[1]) - from;
    if (axis_.cross(along).norm() > flush_angle * length_ * along.norm()) return false;
    const double square = length_ * length_;
    const double s[2] = {(from - start_).dot(axis_) / square, (from + along - start_).dot(axis_) / square};
    const bool turned = s[0] > s[1];
    Span span;
    span.of_other[0] = span.of_other[1] = {FeatureKind::edge, edge};
    span.cut(false, s[turned], {FeatureKind::vertex, ends[turned]});
    span.cut(true, s[!turned], {FeatureKind::vertex, ends[!turned]});
    if (span.is_short()) return false;
    for (int k = 0; k < 2; ++k) {
      const Vec3 place = at(span, k);
      const double t = std::clamp((place - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
      const Vec3 away = place - (from + t * along);
      const double distance = away.norm();
      if (distance > 0) emit(place, away / distance, distance, span.of_core[k], span.of_other[k]);
    }
    return true;
  }

  /// Two contacts at the ends of the part of the axis that is over a face.
  bool on_face(int f) {
    const Contactor3::Face& face = other_.shape.faces[f];
    const Vec3 normal = other_.normal(f);
    Span span;
    span.of_other[0] = span.of_other[1] = {FeatureKind::face, f};
    for (int k = 0; k < face.count; ++k) {
      const Vec3 corner = other_.corner(f, k);
      const Vec3 along = other_.corner(f, (k + 1) % face.count) - corner;
      const Vec3 outward = along.cross(normal) / along.norm();
      const double out = outward.dot(start_ - corner), rise = outward.dot(axis_);
      const ShapeFeature side{FeatureKind::edge, other_.shape.loop_edge[face.first + k]};
      const double slack = 1e-9 * along.norm();  // an end on the side stays an end
      if (std::max(out, out + rise) <= slack) continue;
      if (std::min(out, out + rise) > slack) return false;
      span.cut(rise > 0, -out / rise, side);
    }
    if (span.is_short()) return false;
    for (int k = 0; k < 2; ++k) {
      const Vec3 place = at(span, k);
      emit(place, normal, normal.dot(place - other_.corner(f, 0)), span.of_core[k], span.of_other[k]);
    }
    return true;
  }

  Vec3 at(const Span& span, int end) const { return start_ + (end ? span.high : span.low) * axis_; }

  /// A contact at a place of the core, whose distance from the other core is `distance`.
  void emit(const Vec3& place, const Vec3& normal, double distance, const ShapeFeature& of_core,
            const ShapeFeature& of_other) {
    const double gap = distance - core_.shape.radius - other_.shape.radius;
    if (gap > reach_) return;
    const Vec3 middle = place - (core_.shape.radius + 0.5 * gap) * normal;
    out_.push_back({middle, normal, gap, core_.id(of_core), other_.id(of_other)});
  }

  const Placed3& core_;
  const Placed3& other_;
  double reach_;
  Contacts<3>& out_;
  Vec3 start_ = Vec3::Zero(), axis_ = Vec3::Zero();  ///< of a pill
  double length_ = 0;
};

}  // namespace

void core_contacts(Workspace&, const Placed3& core, const Placed3& other, double reach, double,
                   Contacts<3>& out) {
  CoreContacts(core, other, reach, out).find();
}

}  // namespace flyrock
