// Time of impact with the wall of a hollow contactor or a half space (hollow_wall.h).
//
// In a frame that follows the hollow one but does not turn about its axis, a place q of the other contactor
// is at q0 + q' t + e with |e| <= M t^2/2. The gap is a concave function of the place and changes no faster
// than the place moves, so
//   gap(q0 + q' t) - M t^2/2
// is a concave lower bound of the gap (safe_root.h). Of a rim, it is the least over its places, all of which
// are linear in t.
// Features that are deep in the wall have come from outside, which the wall does not touch: they count once
// they are inside. One that steps have let sink a little counts from there.

#include <algorithm>
#include <array>
#include <cmath>

#include "collision/hollow/hollow_wall.h"
#include "collision/rules.h"
#include "collision/safe_root.h"
#include "collision/smooth/axis_state.h"
#include "collision/smooth/support_feature.h"

namespace flyrock {

namespace {

/// A feature that is deeper in the wall has come from outside: share of the size.
constexpr double outside_share = 1e-3;

/// How a gap counts that is `gap` at the start.
Counts of_sunk(double gap, const GapScale& scale) {
  return gap < -scale.deep ? Counts::from_zero : Counts::fully;
}

/// How long a place stays out of a hollow region [s]: it is `away` from it, and moves with `speed` at most.
/// The steps are no shorter than a small share of the size.
double outside_for(double away, double speed, double size, double left) {
  constexpr double least_share = 1e-4;
  if (!(speed > 0)) return forever;
  return within(left, left, std::max(away, least_share * size) / speed);
}

/// The search with a hollow disk. It turns about its centre, which does not move its wall.
class HollowSearch2 {
 public:
  HollowSearch2(const Moving2& other, const Moving2& hollow, double end, const TouchSearch& search)
      : other_(other), hollow_(hollow), end_(end), search_(search), scale_(search.size) {}

  std::array<double, 5> clearance() const { return {-1, 0, 0, 0, 0}; }

  double lasts(double t) const {
    const Swell &of_hollow = hollow_.motion.swell, &of_other = other_.motion.swell;
    const HollowWall2 wall({hollow_.shape, {}}, of_hollow.at(t));
    // What the radii change of the gap
    const double opens = of_hollow.rate_at(t) - of_other.rate_at(t);
    const double closing = std::max(0.0, of_other.growth - of_hollow.growth);
    const Rotation2 r = Rotation2::from_angle(other_.motion.angle_at(t));
    const double w = other_.motion.spin(t), left = end_ - t;
    const double w_max = std::max(std::abs(w), std::abs(other_.motion.spin(end_)));
    const Vec2 away = other_.motion.position(t) - hollow_.motion.position(t);
    const Vec2 velocity = other_.motion.velocity(t) - hollow_.motion.velocity(t);
    const double pull = (other_.motion.a - hollow_.motion.a).norm();
    const Vec2 middle = middle_of(other_.shape);
    const double fastest = std::abs(opens) + std::abs(of_hollow.growth - of_other.growth) * left;
    if (const Vec2 at = away + r * middle; !wall.contains(at))
      return outside_for(-wall.gap(at), velocity.norm() + pull * left + w_max * middle.norm() + fastest,
                         search_.size, left);
    double least = forever;
    for (int i = 0; i < static_cast<int>(other_.shape.points.size()); ++i) {
      const Vec2 arm = r * other_.shape.points[i], place = away + arm, rate = velocity + cross(w, arm);
      const double bend = closing + pull + (w_max * w_max + std::abs(other_.motion.alpha)) * arm.norm();
      const auto gap = [&](double time) {
        return wall.gap(place + time * rate) - (other_.shape.radius + of_other.at(t)) + time * opens +
               search_.slack - 0.5 * time * time * bend;
      };
      if (gap(0.0) < -outside_share * search_.size) {
        const double fast = velocity.norm() + pull * left + w_max * arm.norm() + fastest;
        least = std::min(least, outside_for(-gap(0.0), fast, search_.size, left));
        continue;
      }
      const double slope = (place.norm() > 0 ? wall.normal(place).dot(rate) : -rate.norm()) + opens;
      const Counts now = of_sunk(gap(0.0), scale_);
      least = std::min(least, within(left, left, safe_root(gap, slope, left, scale_, now)));
    }
    return least;
  }

 private:
  const Moving2 &other_, &hollow_;
  double end_;
  const TouchSearch& search_;
  GapScale scale_;
};

/// The search with a hollow cylinder or a half space.
class HollowSearch3 {
 public:
  HollowSearch3(const Moving3& other, const Moving3& hollow, double end, const TouchSearch& search)
      : other_(other),
        hollow_(hollow),
        end_(end),
        search_(search),
        scale_(search.size),
        axis_of_hollow_(hollow),
        axis_of_other_(other) {}

  std::array<double, 5> clearance() const { return {-1, 0, 0, 0, 0}; }

  double lasts(double t) const {
    const MovingState sr = axis_of_hollow_.of(MovingState(hollow_, t, end_), t, end_);
    const MovingState so = axis_of_other_.of(MovingState(other_, t, end_), t, end_);
    const HollowWall3 wall({hollow_.shape, {sr.x, sr.turn.rotation}});
    const double left = end_ - t;
    const Vec3 away = so.x - sr.x, velocity = so.v - sr.v, pull = other_.motion.a - hollow_.motion.a;
    // Of a place at an arm of the other body, seen from the hollow contactor: where it is, and how it moves.
    const auto place_of = [&](const Vec3& arm) -> Vec3 { return away + arm; };
    const auto rate_of = [&](const Vec3& arm) -> Vec3 {
      return velocity + so.turn.spin.cross(arm) - sr.turn.spin.cross(place_of(arm));
    };
    const double speed = velocity.norm() + left * pull.norm();
    const Vec3 middle = so.arm(middle_of(other_.shape));
    if (const Vec3 at = place_of(middle); !wall.contains(at)) {
      const double beyond = std::abs(wall.axis().dot(at)) - wall.half_length();
      const double turning = sr.w_max * (at.norm() + left * speed);
      return outside_for(std::max(beyond, -wall.gap(at)), speed + so.w_max * middle.norm() + turning,
                         search_.size, left);
    }
    double least = forever;
    /// One piece, whose greatest arm is `arm`, with its gap as a function of the places' motion.
    const auto see = [&](double arm, double lever, double slope, const auto& gap_at) {
      const double fast = speed + so.w_max * arm;
      double horizon = left, acceleration = so.bend(arm);
      acceleration += sr.turns() || !wall.is_plane() ? pull.norm() : std::max(0.0, -wall.axis().dot(pull));
      if (sr.turns() && fast > 0) horizon = std::min(left, (lever + search_.size) / fast);
      const double bend =
          (sr.w_max * sr.w_max + sr.w_rate) * (lever + fast * horizon) + 2 * sr.w_max * fast + acceleration;
      const double offset = search_.slack - other_.shape.radius;
      const auto gap = [&](double time) { return gap_at(time) + offset - 0.5 * time * time * bend; };
      if (!wall.is_plane() && gap(0.0) < -outside_share * search_.size) {
        least = std::min(least, outside_for(-gap(0.0), fast + sr.w_max * lever, search_.size, left));
        return;
      }
      const Counts now = wall.is_plane() ? Counts::fully : of_sunk(gap(0.0), scale_);
      least = std::min(least, within(horizon, left, safe_root(gap, slope, horizon, scale_, now)));
    };
    const auto slope_at = [&](const Vec3& place, const Vec3& rate) {
      const Vec3 normal = wall.normal(place);
      return wall.gap(place) < wall.greatest_gap() ? normal.dot(rate) : -rate.norm();
    };
    const auto& points = other_.shape.points;
    for (std::size_t i = 0; i < points.size() && least > 0; ++i) {
      const Vec3 arm = so.arm(points[i]), place = place_of(arm), rate = rate_of(arm);
      see(arm.norm(), place.norm(), slope_at(place, rate),
          [&](double time) { return wall.gap(place + time * rate); });
    }
    for (std::size_t k = 0; k < other_.shape.circles.size() && least > 0; ++k) {
      const Contactor3::Circle& circle = other_.shape.circles[k];
      const Ring now = ring_of({other_.shape, {so.x, so.turn.rotation}}, circle, sr.x);
      const auto turned = [&](const Vec3& v) -> Vec3 {
        return so.turn.spin.cross(v) - sr.turn.spin.cross(v);
      };
      const Ring change{rate_of(now.centre - away), turned(now.a), turned(now.b)};
      const auto ring_at = [&](double time) -> Ring {
        return {now.centre + time * change.centre, now.a + time * change.a, now.b + time * change.b};
      };
      const auto nearest = wall.nearest(now);
      const double arm = (now.centre - away).norm() + circle.radius,
                   lever = now.centre.norm() + circle.radius;
      const auto slope_of = [&](double angle) { return slope_at(now.at(angle), change.at(angle)); };
      double slope = forever;
      for (const double angle : nearest)
        if (wall.gap(now.at(angle)) <= wall.gap(now.at(nearest[0])) + 1e-12 * search_.size)
          slope = std::min(slope, slope_of(angle));
      see(arm, lever, slope, [&](double time) { return wall.least_gap(ring_at(time)); });
    }
    return least;
  }

 private:
  const Moving3 &other_, &hollow_;
  double end_;
  const TouchSearch& search_;
  GapScale scale_;
  AxisState axis_of_hollow_, axis_of_other_;
};

}  // namespace

std::optional<double> hollow_touch(Workspace&, const Moving2& other, const Moving2& hollow, double t_max,
                                   const TouchSearch& search) {
  return advance(HollowSearch2(other, hollow, t_max, search), {0, t_max}, search.iterations);
}

std::optional<double> hollow_touch(Workspace&, const Moving3& other, const Moving3& hollow, double t_max,
                                   const TouchSearch& search) {
  return advance(HollowSearch3(other, hollow, t_max, search), {0, t_max}, search.iterations);
}

}  // namespace flyrock
