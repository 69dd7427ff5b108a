// Contacts of spheres and pills with the convex edges and peaks of the ground.

#include "collision/ground/ground_contact.h"
#include "collision/pill/closest.h"

namespace flyrock {

namespace {

/// An end of a pill, or the centre of a sphere, has the contacts whose normals lie in the cone of the edge or
/// peak and in its own. The cone of an end ends where the axis has the contact.
class CoreRimContacts {
 public:
  CoreRimContacts(const Placed3& core, double reach, double turn, Contacts<3>& out)
      : core_(core),
        radius_(core.shape.radius),
        reach_(reach),
        slack_(flush_angle + turn),
        is_pill_(core.count() > 1),
        end_{core.point(0), Vec3::Zero()},
        out_(out) {
    if (!is_pill_) return;
    end_[1] = core.point(1);
    axis_ = end_[1] - end_[0];
    length_ = axis_.norm();
  }

  bool near(const Facet&) const { return true; }

  void rim(const Facet& f, int i) {
    for (int end = 0; end <= is_pill_; ++end) {
      const Vec3 from_corner = end_[end] - f.corner[i], along = f.along(i);
      const double share = from_corner.dot(along) / along.squaredNorm();
      const Vec3 away = from_corner - share * along;
      if (is_in(share) && near(away) && rim_cone_contains(f, i, away, 0) && end_contains(end, away, along))
        touch(f.corner[i] + share * along, away, vertex(end), f.edge_feature(i));
    }
    if (is_pill_) across(f, i);
  }

  void peak(const Facet& f, int i, const Ground3& ground, std::vector<Vec3>& edges) {
    const Vec3& top = f.corner[i];
    const double s = is_pill_ ? nearest_of_segments(end_[0], axis_, top, Vec3::Zero()).s : 0;
    const bool on_axis = s > 0 && s < 1;
    const int end = s > 0;
    const Vec3 away = (on_axis ? Vec3(end_[0] + s * axis_) : end_[end]) - top;
    if (near(away) && ground.peak(f.vertex[i], edges) &&
        peak_cone_contains(edges, away, on_axis ? slack_ * away.norm() : 0))
      touch(top, away, on_axis ? axis_feature() : vertex(end), f.vertex_feature(i));
  }

 private:
  FeatureId vertex(int end) const { return core_.id({FeatureKind::vertex, end}); }
  FeatureId axis_feature() const { return core_.id({FeatureKind::edge, 0}); }
  static bool is_in(double share) { return share >= -region_slack && share <= 1 + region_slack; }
  bool near(const Vec3& away) const {
    const double farthest = radius_ + reach_;
    return away.squaredNorm() <= farthest * farthest;
  }

  /// Whether the axis leads away from the ground at an end, or lies flush on the edge.
  bool end_contains(int end, const Vec3& away, const Vec3& along) const {
    if (!is_pill_) return true;
    const double rise = (end ? Vec3(-axis_) : axis_).dot(away);
    return rise >= (parallel(along) ? -flush_angle * length_ * away.norm() : 0);
  }
  bool parallel(const Vec3& along) const {
    return axis_.cross(along).norm() <= flush_angle * along.norm() * length_;
  }

  /// The axis of a pill across an edge. If they are parallel, the ends have the contacts.
  void across(const Facet& f, int i) {
    const Vec3 along = f.along(i), away = end_[0] - f.corner[i];
    Vec3 normal = axis_.cross(along);
    const double length = normal.norm();
    if (parallel(along)) return;
    const double s = along.cross(away).dot(normal) / (length * length);
    const double t = axis_.cross(away).dot(normal) / (length * length);
    if (!is_in(s) || !is_in(t)) return;
    normal /= normal.dot(f.normal + f.beyond[i]) < 0 ? -length : length;
    const double distance = normal.dot(away);
    if (distance <= 0 || distance - radius_ > reach_ || !rim_cone_contains(f, i, normal, slack_)) return;
    touch(f.corner[i] + t * along, distance * normal, axis_feature(), f.edge_feature(i));
  }

  void touch(const Vec3& place, const Vec3& away, FeatureId feature, FeatureId against) {
    const double distance = away.norm(), gap = distance - radius_;
    if (gap > reach_ || !(distance > 0)) return;
    const Vec3 normal = away / distance;
    out_.push_back({place + 0.5 * gap * normal, normal, gap, feature, against});
  }

  const Placed3& core_;
  double radius_, reach_, slack_;
  bool is_pill_;
  Vec3 end_[2], axis_;  ///< of a pill; a sphere is one end
  double length_ = 0;
  Contacts<3>& out_;
};

}  // namespace

void core_on_ground(Workspace& work, const Placed3& core, const Ground3& ground, double reach, double turn,
                    Contacts<3>& out) {
  contacts_on_ground(work, core, ground, reach, out, [&](const GroundNearby& nearby) {
    if (core.count() > 1 || core.shape.radius > 0)
      at_rims_and_peaks(work, nearby, CoreRimContacts(core, reach, turn, out));
  });
}

}  // namespace flyrock
