// Time of impact of contactors with circles.

#include <algorithm>

#include "collision/pair_search.h"
#include "collision/rules.h"
#include "collision/safe_root.h"
#include "collision/smooth/axis_state.h"
#include "collision/smooth/facing_pair.h"
#include "collision/smooth/piece_heights.h"

namespace flyrock {

namespace {

class CircleSearch {
 public:
  CircleSearch(Workspace& work, const Moving3& a, const Moving3& b, double end, const TouchSearch& search)
      : a_(a),
        b_(b),
        end_(end),
        search_(search),
        scale_(search.size),
        axis_a_(a),
        axis_b_(b),
        of_a_(work.heights_a),
        of_b_(work.heights_b) {}

  std::array<double, 5> clearance() const { return ball_clearance(a_, b_, search_); }

  /// How long the direction that separates longest does so [s]; 0 if none separates the pair.
  double lasts(double t) {
    const MovingState body_a(a_, t, end_), body_b(b_, t, end_);
    const MovingState sa = axis_a_.of(body_a, t, end_), sb = axis_b_.of(body_b, t, end_);
    const double left = end_ - t;
    double best = 0;
    const auto attempt = [&](const Direction& d) {
      if (best < left) best = std::max(best, separates(d, sa, sb, t));
    };
    if (b_.facet) attempt(with_b(b_.facet->normal, sb));
    if (best >= left || (b_.facet && b_.facet->unbounded)) return best;
    const Placed3 a{a_.shape, {sa.x, sa.turn.rotation}}, b{b_.shape, {sb.x, sb.turn.rotation}};
    const FacingPair pair = facing_pair(a, b);
    nearest_ = pair.normal;
    const Patch &of_a = pair.of_a, &of_b = pair.of_b;
    if (of_b.is_plane()) attempt(with_b(of_b.normal, sb));
    if (of_a.is_plane()) attempt(with_a(-of_a.normal, sa));
    if (of_a.kind == Patch::Kind::segment && of_b.kind == Patch::Kind::segment)
      attempt(across(of_a.places[1].at - of_a.places[0].at, sa, of_b.places[1].at - of_b.places[0].at, sb));
    attempt(with_b(nearest_, sb));
    attempt(with_a(nearest_, sa));
    if (pair.apart.normal != nearest_) {
      attempt(with_b(pair.apart.normal, sb));
      attempt(with_a(pair.apart.normal, sa));
    }
    return best;
  }

 private:
  /// A normal from b to a.
  struct Direction : TurningNormal {
    enum class Turns { with_a, with_b, with_both } turns;
  };

  static Direction with_a(const Vec3& normal, const MovingState& sa) {
    return {TurningNormal::with(sa, normal), Direction::Turns::with_a};
  }
  static Direction with_b(const Vec3& normal, const MovingState& sb) {
    return {TurningNormal::with(sb, normal), Direction::Turns::with_b};
  }

  /// The cross product of a line of each contactor.
  Direction across(const Vec3& line_a, const MovingState& sa, const Vec3& line_b,
                   const MovingState& sb) const {
    const Vec3 e = line_a.normalized(), f = line_b.normalized(), product = e.cross(f);
    const double sign = product.dot(nearest_) < 0 ? -1 : 1;
    return {TurningNormal::across(e, sa, f, sb, sign, product.norm()), Direction::Turns::with_both};
  }

  /// The least height of the pieces after a time.
  static double lowest(const std::vector<PieceHeight>& pieces, double time) {
    double low = forever;
    for (const PieceHeight& piece : pieces) low = std::min(low, piece.at(time));
    return low;
  }

  /// How fast the lowest pieces rise.
  double slope_of(const std::vector<PieceHeight>& pieces) const {
    const double low = lowest(pieces, 0) + 1e-12 * search_.size;
    double slope = forever;
    for (const PieceHeight& piece : pieces)
      if (piece.at(0) <= low) slope = std::min(slope, piece.slope());
    return slope;
  }

  /// How long a direction separates the pair from t on [s]. `sa`, `sb`: as AxisState gives them.
  double separates(const Direction& d, const MovingState& sa, const MovingState& sb, double t) {
    const double left = end_ - t, turn = d.turn;
    const bool a_moves = d.turns != Direction::Turns::with_a, b_moves = d.turns != Direction::Turns::with_b;
    const double size_a = a_moves ? a_.shape.bound : 0, size_b = b_moves ? b_.shape.bound : 0;
    const Vec3 pull = a_.motion.a - b_.motion.a;
    // Of the difference of two places that the turning normal sees, and its rates
    const double lever = (sa.x - sb.x).norm() + size_a + size_b;
    const double speed = (sa.v - sb.v).norm() + pull.norm() * left + sa.w_max * size_a + sb.w_max * size_b;
    const double acceleration =
        sa.bend(size_a) + sb.bend(size_b) + (turn > 0 ? pull.norm() : std::max(0.0, -d.normal.dot(pull)));
    double horizon = std::min(d.horizon, left);
    if (turn > 0 && speed > 0) horizon = std::min(horizon, (lever + search_.size) / speed);
    const double bend = d.turn_rate * (lever + speed * horizon) + 2 * turn * speed + acceleration;
    const Heights heights_a(d.normal, d.rate, sa, sb.x, sb.v), heights_b(-d.normal, -d.rate, sb, sb.x, sb.v);
    piece_heights(a_.shape, heights_a, of_a_);
    piece_heights(b_.shape, heights_b, of_b_);
    const double offset = search_.slack - a_.shape.radius - b_.shape.radius;
    const auto gap = [&](double time) {
      return lowest(of_a_, time) + lowest(of_b_, time) + offset - 0.5 * bend * time * time;
    };
    const double slope = slope_of(of_a_) + slope_of(of_b_);
    return within(horizon, left, safe_root(gap, slope, horizon, scale_, Counts::fully));
  }

  const Moving3& a_;
  const Moving3& b_;
  double end_;
  const TouchSearch& search_;
  GapScale scale_;
  AxisState axis_a_, axis_b_;
  Vec3 nearest_ = Vec3::Zero();            ///< the normal of contacts of the pair
  std::vector<PieceHeight>&of_a_, &of_b_;  ///< along the direction at hand
};

}  // namespace

std::optional<double> advance_with_circles(Workspace& work, const Moving3& a, const Moving3& b,
                                           const TimeWindow& window, const TouchSearch& search) {
  return advance(CircleSearch(work, a, b, window.b, search), window, search.iterations);
}

std::optional<double> smooth_touch(Workspace& work, const Moving3& a, const Moving3& b, double t_max,
                                   const TouchSearch& search) {
  return advance_with_circles(work, a, b, {0, t_max}, search);
}

}  // namespace flyrock
