// Time of impact of contactors with circles.

#include <algorithm>
#include <boost/container/small_vector.hpp>

#include "collision/held_3d.h"
#include "collision/pair_search.h"
#include "collision/rules.h"
#include "collision/safe_root.h"
#include "collision/smooth/axis_state.h"
#include "collision/smooth/facing_pair.h"
#include "collision/smooth/piece_heights.h"

namespace flyrock {

namespace {

constexpr double closed = 1e-6;  // of the size: greater gaps are of no contact that exists
// Of the size: by how much pieces that contacts hold may sink in a step. A rim is held at some places only,
// and sinks with others where they come down.
constexpr double rim_sinking = 1e-5;

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
        held_(a, b, search),
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
      if (best < left) best = std::max(best, separates(d, sa, sb, body_a, body_b, t));
    };
    if (b_.facet) attempt(with_b(b_.facet->normal, sb, 0));
    if (best >= left || (b_.facet && b_.facet->unbounded)) return best;
    const Placed3 a{a_.shape, {sa.x, sa.turn.rotation}}, b{b_.shape, {sb.x, sb.turn.rotation}};
    const FacingPair pair = facing_pair(a, b);
    nearest_ = pair.normal;
    touches_ = pair.apart.distance - a_.shape.radius - b_.shape.radius < closed * search_.size;
    const Patch &of_a = pair.of_a, &of_b = pair.of_b;
    if (of_b.is_plane()) attempt(with_b(of_b.normal, sb, of_b.feature.index));
    if (of_a.is_plane()) attempt(with_a(-of_a.normal, sa, of_a.feature.index));
    if (of_a.kind == Patch::Kind::segment && of_b.kind == Patch::Kind::segment)
      attempt(across(of_a.places[1].at - of_a.places[0].at, sa, of_b.places[1].at - of_b.places[0].at, sb));
    attempt(with_b(nearest_, sb));
    attempt(with_a(nearest_, sa));
    if (pair.apart.normal != nearest_) {
      attempt(with_b(pair.apart.normal, sb));
      attempt(with_a(pair.apart.normal, sa));
    }
    if (b_.facet)
      for (const HeldOnGround& h : b_.held_on_ground)
        if (kind_of(h.against) == FeatureKind::face) attempt(with_b(h.upward, sb));
    return best;
  }

 private:
  /// Towards the highest place of each rim at the start; unit.
  using FirstPlaces = boost::container::small_vector<Vec3, 2>;

  /// A normal from b to a.
  struct Direction : TurningNormal {
    enum class Turns { with_a, with_b, with_both } turns;
    int face =
        -1;  ///< of the contactor with which it turns: the face or cap that it is the normal of; -1: none
  };

  static Direction with_a(const Vec3& normal, const MovingState& sa, int face = -1) {
    return {TurningNormal::with(sa, normal), Direction::Turns::with_a, face};
  }
  static Direction with_b(const Vec3& normal, const MovingState& sb, int face = -1) {
    return {TurningNormal::with(sb, normal), Direction::Turns::with_b, face};
  }

  /// The cross product of a line of each contactor.
  Direction across(const Vec3& line_a, const MovingState& sa, const Vec3& line_b,
                   const MovingState& sb) const {
    const Vec3 e = line_a.normalized(), f = line_b.normalized(), product = e.cross(f);
    const double sign = product.dot(nearest_) < 0 ? -1 : 1;
    return {TurningNormal::across(e, sa, f, sb, sign, product.norm()), Direction::Turns::with_both};
  }

  /// The least height of some pieces after a time.
  template <class Some>
  static double lowest(const std::vector<PieceHeight>& pieces, const Some& some, double time) {
    double low = forever;
    for (int i = 0; i < static_cast<int>(pieces.size()); ++i)
      if (some(i)) low = std::min(low, pieces[i].at(time));
    return low;
  }

  /// How deep held pieces may sink, of which the lowest has this gap along the direction at hand: no deeper
  /// than where they were when the search first met them held, and a little.
  double may_sink(double gap, double t) {
    if (!sunk_since_) sunk_since_ = t;
    if (t == *sunk_since_) sunk_ = std::min(sunk_, std::max(0.0, -gap));
    return sunk_ + rim_sinking * search_.size;
  }

  /// How long a direction separates the pair from t on [s]. `sa`, `sb`: as AxisState gives them.
  double separates(const Direction& d, const MovingState& sa, const MovingState& sb,
                   const MovingState& body_a, const MovingState& body_b, double t) {
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
    double least = within(horizon, left, forever);

    /// The pairs of some pieces of a with some of b.
    const auto see = [&](const auto& some_a, const auto& some_b, Counts counts, double sinking = 0) {
      if (least <= 0) return;
      const auto slope_of = [&](const std::vector<PieceHeight>& pieces, const auto& some) {
        const double low = lowest(pieces, some, 0) + 1e-12 * search_.size;
        double slope = forever;
        for (int i = 0; i < static_cast<int>(pieces.size()); ++i)
          if (some(i) && pieces[i].at(0) <= low) slope = std::min(slope, pieces[i].slope());
        return slope;
      };
      const auto gap = [&](double time) {
        return lowest(of_a_, some_a, time) + lowest(of_b_, some_b, time) + offset + sinking -
               0.5 * bend * time * time;
      };
      if (gap(0) == forever) return;
      const double time =
          safe_root(gap, slope_of(of_a_, some_a) + slope_of(of_b_, some_b), horizon, scale_, counts);
      least = std::min(least, within(horizon, left, time));
    };
    const auto all = [](int) { return true; };
    const bool turns_with_b = d.turns == Direction::Turns::with_b;
    const Hold hold = held_.hold(d.normal, {turns_with_b, d.face}, nearest_, touches_);
    if (hold == Hold::no) {
      see(all, all, Counts::fully);
      return least;
    }
    const auto held_a = [&](int i) { return held_.of_a().has(i); };
    const auto held_b = [&](int i) { return held_.of_b().has(i); };
    see([&](int i) { return !held_a(i); }, all, Counts::fully);
    see(
        held_a, [&](int i) { return !held_b(i); }, Counts::fully);
    if (const Counts counts = held_.counts(t); counts != Counts::never) {
      see(held_a, held_b, counts);
      return least;
    }
    if (!held_.yields())
      see(held_a, held_b, Counts::fully,
          may_sink(lowest(of_a_, held_a, 0) + lowest(of_b_, held_b, 0) + offset, t));
    if (hold == Hold::for_now) {
      const double rate = sa.w_max + sb.w_max + speed / std::min(search_.size, a_.shape.bound);
      if (rate > 0) least = std::min(least, within(drift_angle / rate, left, forever));
    }
    // These follow places of the rims, which turn with the bodies.
    const double w = body_a.w_max + body_b.w_max + turn;
    const double turning = w * w + body_a.w_rate + body_b.w_rate + d.turn_rate;
    const Heights rims_a(d.normal, d.rate, body_a, sb.x, sb.v),
        rims_b(-d.normal, -d.rate, body_b, sb.x, sb.v);
    if (a_moves || d.face < 0)
      quarter_turns(held_.of_a(), first_a_, a_.shape, rims_a, turning, horizon, left, least);
    if (b_moves || d.face < 0)
      quarter_turns(held_.of_b(), first_b_, b_.shape, rims_b, turning, horizon, left, least);
    return least;
  }

  /// Limits a time to the one at which the lowest place of a rim that is held there only has walked a quarter
  /// of a turn around it; then the cap is level, or nearly so, and another place touches. `turning` is a
  /// bound on the second rate of the normal, as the contactor sees it. Over the plane of its own cap, no
  /// place of a rim is lowest.
  void quarter_turns(const HeldPieces& held, FirstPlaces& first, const Contactor3& shape,
                     const Heights& heights, double turning, double horizon, double left,
                     double& least) const {
    constexpr double level = 1e-9;  // share of the size
    for (std::size_t i = 0; i < shape.circles.size(); ++i) {
      const Contactor3::Circle& circle = shape.circles[i];
      if (!held.has_in_part(static_cast<int>(shape.points.size() + i))) continue;
      if (first.size() <= i) first.resize(i + 1, Vec3::Zero());
      if (first[i].isZero(0)) first[i] = circle.towards(heights.rise());
      const Vec3 arm = circle.radius * first[i];
      const double time = safe_time(arm.dot(heights.rise()) - level * search_.size, arm.dot(heights.change()),
                                    circle.radius * turning, scale_, Counts::fully);
      least = std::min(least, within(horizon, left, time));
    }
  }

  const Moving3& a_;
  const Moving3& b_;
  double end_;
  const TouchSearch& search_;
  GapScale scale_;
  AxisState axis_a_, axis_b_;
  HeldPair held_;
  Vec3 nearest_ = Vec3::Zero();            ///< the normal of contacts of the pair
  bool touches_ = false;                   ///< along the normal that separates the cores most
  std::optional<double> sunk_since_;       ///< s, when held pieces were first met,
  double sunk_ = forever;                  ///< m, and how deep they lay then along the best direction
  std::vector<PieceHeight>&of_a_, &of_b_;  ///< along the direction at hand
  FirstPlaces first_a_, first_b_;
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
