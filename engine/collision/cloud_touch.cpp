#include "collision/cloud_touch.h"

#include <array>
#include <limits>

#include "collision/advance3.h"
#include "collision/ball_clearance.h"
#include "collision/facet_region.h"

namespace flyrock {

namespace {

constexpr double forever = std::numeric_limits<double>::infinity();

/// A facet as a thin prism below its plane, which the points enter from above. A point stays clear of it as
/// long as it stays above the plane, or beyond one side, or below the prism: the longest of these times.
class CloudSearch {
 public:
  CloudSearch(const MovingContactor& cloud, const Facet& facet, double end, const TouchSearch& search)
      : cloud_(cloud), facet_(facet), end_(end), search_(search), scale_(search.size) {
    for (int i = 0; i < 3; ++i) outward_[i] = -facet.normal.cross(facet.along(i)).normalized();
  }

  double lasts(double t) const {
    const MovingState state(cloud_, t, end_);
    double least = forever;
    for (int i = 0; i < static_cast<int>(cloud_.shape.points.size()) && least > 0; ++i) {
      const bool held =
          search_.holds(feature_id(cloud_.index, FeatureKind::vertex, i), facet_.face_feature());
      if (!held || !search_.held_are_solved)
        least = std::min(least, point_lasts(cloud_.shape.points[i], state, held && t == 0, end_ - t));
    }
    return least;
  }

  /// The height of the cloud's bounding ball over the plane, as a polynomial of t.
  std::array<double, 3> clearance() const {
    const Motion3& motion = cloud_.motion;
    return {facet_.distance(motion.x) - cloud_.shape.bound + search_.slack, facet_.normal.dot(motion.v),
            0.5 * facet_.normal.dot(motion.a)};
  }

 private:
  double point_lasts(const Vec3& point, const MovingState& state, bool just_opened, double left) const {
    const Vec3 arm = state.arm(point), at = state.x + arm, speed = state.velocity_at(arm);
    const double turning = state.bend(arm.norm()), height = facet_.distance(at);
    const auto stays = [&](double gap, const Vec3& away, bool opened) {
      return safe_time(gap, away.dot(speed), std::max(0.0, -away.dot(cloud_.motion.a)) + turning, scale_,
                       opened);
    };
    double most = stays(height + search_.slack, facet_.normal, just_opened);
    const auto try_outside = [&](double gap, const Vec3& away) {
      if (gap > 0 && most < left) most = std::max(most, stays(gap, away, false));
    };
    try_outside(-height - scale_.deep, -facet_.normal);
    for (int i = 0; i < 3; ++i)
      if (facet_.rim[i] != Rim::open)
        try_outside(outward_[i].dot(at - facet_.corner[i]) - strip_margin(facet_, i, at, scale_.deep),
                    outward_[i]);
    return most;
  }

  const MovingContactor& cloud_;
  const Facet& facet_;
  double end_;
  const TouchSearch& search_;
  GapScale scale_;
  std::array<Vec3, 3> outward_;  ///< unit, out of the sides
};

}  // namespace

std::optional<double> advance_cloud_to_facet(const MovingContactor& cloud, const Facet& facet,
                                             const TimeWindow& window, const TouchSearch& search) {
  return advance(CloudSearch(cloud, facet, window.b, search), window, search.iterations);
}

}  // namespace flyrock
