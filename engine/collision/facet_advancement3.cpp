// Time of impact of a moving contactor with a plane.

#include <algorithm>
#include <array>
#include <limits>

#include "collision/advance3.h"
#include "collision/safe_time.h"

namespace flyrock {

namespace {

class PlaneSearch {
 public:
  PlaneSearch(const MovingContactor& c, const Plane& plane, double end, const TouchSearch& search)
      : c_(c), plane_(plane), end_(end), search_(search), scale_(search.size), ball_(c.shape.bound) {}

  /// How long all vertices stay clear of the plane, from t on [s].
  double lasts(double t) const {
    const MovingState s(c_, t, end_);
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < static_cast<int>(c_.shape.points.size()) && least > 0; ++i) {
      const bool held =
          search_.holds(feature_id(c_.index, FeatureKind::vertex, i), feature_id(0, FeatureKind::face, 0));
      if (held && search_.held_are_solved) continue;
      const Vec3 arm = s.arm(c_.shape.points[i]);
      const double gap = plane_.distance(s.x + arm) - c_.shape.radius + search_.slack;
      const double slope = plane_.normal.dot(s.velocity_at(arm));
      const double bend = std::max(0.0, -plane_.normal.dot(c_.motion.a)) + s.bend(arm.norm());
      least = std::min(least, safe_time(gap, slope, bend, scale_, held && t == 0));
    }
    return least;
  }

  /// The height of the contactor's bounding ball over the plane, as a polynomial of t.
  std::array<double, 3> clearance() const {
    return {plane_.distance(c_.motion.x) - ball_ + search_.slack, plane_.normal.dot(c_.motion.v),
            0.5 * plane_.normal.dot(c_.motion.a)};
  }

 private:
  const MovingContactor& c_;
  const Plane& plane_;
  double end_;
  const TouchSearch& search_;
  GapScale scale_;
  double ball_;
};

}  // namespace

std::optional<double> advance_to_plane(const MovingContactor& contactor, const Plane& plane, double end,
                                       const TouchSearch& search) {
  return advance(PlaneSearch(contactor, plane, end, search), end, search.iterations);
}

}  // namespace flyrock
