#include "flight/point_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "flight/crossing.h"
#include "flight/faults.h"
#include "flight/ground.h"
#include "flight/point_log.h"
#include "flight/point_support.h"
#include "flight/rest.h"

namespace flyrock {

namespace {

constexpr double idle_time = 1e-3;    // s
constexpr double varying_leg = 0.01;  // s, after which a law that varies is asked again

/// The energy of a point, and what it may have at most [J/kg].
template <int D>
class EnergyAudit {
 public:
  EnergyAudit(const Body<D>& body, const Vec<D>& gravity)
      : mass_(body.mass), gravity_(gravity), start_(body.x), size_(body.size) {
    allowed_ = energy(body.x, body.v);
  }
  double energy(const Vec<D>& x, const Vec<D>& v) const {
    return 0.5 * v.squaredNorm() - gravity_.dot(x - start_);
  }
  /// Energy came from outside: the work of the air, a gain of an impact.
  void give(double energy) { allowed_ += energy; }
  std::optional<std::string> fault(const Vec<D>& x, const Vec<D>& v) const {
    const double excess = energy(x, v) - allowed_;
    if (excess <= 0) return std::nullopt;
    const double scale = 0.5 * v.squaredNorm() + gravity_.norm() * ((x - start_).norm() + size_);
    if (!(excess > 1e-6 * scale)) return std::nullopt;
    return energy_from_nowhere_text(mass_ * excess);
  }

 private:
  double mass_;
  Vec<D> gravity_;
  Vec<D> start_;
  double size_;
  double allowed_ = 0;
};

/// Keeps its memory between rocks.
template <int D>
std::vector<Face<D>>& kept_faces() {
  thread_local std::vector<Face<D>> faces;
  faces.clear();
  return faces;
}

template <int D>
class PointRunner {
 public:
  using Terrain = typename Geometry<D>::Terrain;

  PointRunner(const Body<D>& body, const Terrain& terrain, const PointRun<D>& run)
      : terrain_(terrain),
        run_(run),
        body_(body),
        now_{false, false, run.start_time, body.x, body.v},
        log_(body, terrain, run, history_),
        rest_(RestWatch::Kind::point, run.stop_speed, history_),
        contact_(body, terrain, run.origin, run.laws),
        audit_(body, run.forces.gravity),
        slow_(std::max(0.05 * run.rest_speed, 1e-9)),
        crossing_(run, terrain, body.x, body.volume, run.key, history_) {}

  BodyHistory run() {
    if (run_.ends_at_touch) return fly_to_touch();
    start_on_ground();
    double marked = now_.time;
    for (int events = 1;; ++events) {
      if (now_.time >= run_.stop_time) return end(StopReason::timed_out);
      if (events % 64 == 0 && run_.interrupted()) throw Interrupted();
      if (events % most_idle == 0) {
        if (now_.time - marked < idle_time)
          return diverged(std::to_string(most_idle) + " events without progress");
        marked = now_.time;
      }
      const bool caught = settle() ? fly() : slide_or_fly();
      if (caught) return end(StopReason::caught);
      if (const auto fault = find_fault()) return diverged(*fault);
      if (now_.left) return left();
      if (is_at_rest()) return end(StopReason::stopped);
    }
  }

 private:
  /// The method `ballistic`.
  BodyHistory fly_to_touch() {
    while (true) {
      const bool caught = fly_by_arcs(ground_of(terrain_));
      if (caught) return finish(StopReason::caught);
      if (now_.on_ground) return finish(StopReason::stopped);
      if (now_.left) return finish(StopReason::left_domain);
      if (now_.time >= run_.stop_time) return finish(StopReason::timed_out);
    }
  }

  /// Flies to the ground, an end, a barrier or a tree. Returns whether a barrier or a tree has caught the
  /// point.
  template <class Ground>
  bool fly_by_arcs(const Ground& ground) {
    Obstacle obstacle;
    now_ = land(BallisticFlight<D>(run_.forces, now_.position, now_.velocity, now_.time), ground,
                run_.stop_time, [&](const Arc<D>& arc, ArcEnd& end) {
                  obstacle = first_obstacle(arc, end);
                  near_ = end.segment;
                  follow(arc, end.s);
                });
    return stops_at(obstacle);
  }

  /// The same without air, in closed form.
  bool fly_parabola() {
    const Parabola<D> path{
        {now_.position, now_.velocity, run_.forces.gravity}, now_.time, run_.stop_time - now_.time};
    ArcEnd end = end_of(path, PointGround<D>{terrain_, near_});
    const Obstacle obstacle = first_obstacle(path, end);
    near_ = end.segment;
    follow(path, end.s);
    now_ = {end.on_ground, end.left, path.time(end.s), path.position(end.s), path.velocity(end.s)};
    return stops_at(obstacle);
  }

  template <class Curve>
  void follow(const Curve& curve, double end) {
    log_.flew(curve, end);
    pass_gates(curve, end);
  }

  bool fly() {
    const double start = now_.time;
    if (run_.quality) ++run_.quality->flights;
    bool caught = false;
    if (run_.forces.air.drag > 0) {
      const double energy = audit_.energy(now_.position, now_.velocity);
      caught = fly_by_arcs(PointGround<D>{terrain_, near_});
      audit_.give(audit_.energy(now_.position, now_.velocity) - energy);
    } else {
      caught = fly_parabola();
    }
    // a resting point may lose contact for a shorter time
    if (now_.time - start > idle_time) rest_.moves();
    return caught;
  }

  /// A point that starts in the ground by rounding starts on it.
  void start_on_ground() {
    const double depth = depth_below_ground(terrain_, now_.position);
    if (depth > 0 && depth <= 1e-6 * body_.size) now_.position[D - 1] += depth;
  }

  /// Solves the impacts at this place, the greatest approach first, until the point approaches no face.
  /// Returns whether it then rises from all faces on which it is.
  bool settle() {
    constexpr int most_impacts = 100;  // at one place, before restitution and roughness end
    faces_at(terrain_, now_.position, near_, faces_);
    if (faces_.empty()) return true;
    for (int i = 0;; ++i) {
      const Vec<D>& v = now_.velocity;
      const Face<D>* first = nullptr;
      double approach = -infinite;
      for (const Face<D>& face : faces_)
        if (const double of_face = -v.dot(face.normal); of_face > approach) first = &face, approach = of_face;
      const double rounding = rounding_of_speed(v.norm());
      if (!(approach > rounding)) return approach < -rounding;
      log_.touches(now_);
      if (approach > run_.rest_speed && i < most_impacts)
        collide(*first);
      else
        close(*first, approach);
    }
  }

  void collide(const Face<D>& face) {
    const auto bounce = contact_.strike(face, now_.time, now_.position, now_.velocity);
    log_.struck(now_);
    if (run_.keep_impacts)
      history_.impacts.push_back(contact_.record(face, now_.time, now_.position, bounce));
    if (run_.quality) ++run_.quality->impact_problems;
    const double gain = contact_.energy_change(bounce);
    if (gain <= 0) return;
    audit_.give(gain / body_.mass);
    const double vn = bounce.before[0];
    const double rounding = 1e-12 * std::abs(body_.mass * (bounce.after[0] - vn) * vn);
    if (!run_.quality || gain <= rounding) return;
    ++run_.quality->energy_gains;
    run_.quality->energy_gained += gain;
  }

  /// An approach without restitution: friction takes at most mu times the normal velocity.
  void close(const Face<D>& face, double approach) {
    Vec<D>& v = now_.velocity;
    v += approach * face.normal;
    const auto grip = contact_.grip_at_touch(face, now_.time, now_.position, v, approach);
    const double slip = v.norm();
    if (slip > 0) v *= std::max(0.0, 1 - grip.slides / slip);
  }

  bool slide_or_fly() {
    const Support<D> support = find_support();
    return support.face ? slide_on(support) : fly();
  }

  Support<D> find_support() {
    force_ = run_.forces.gravity;
    if (run_.forces.air.drag > 0) {
      leg_ = leg_length(run_.forces.air, now_.velocity, run_.forces.gravity);
      force_ += mean_acceleration(run_.forces.air, now_.velocity, run_.forces.gravity, leg_);
    }
    return support_of(contact_, faces_, now_.time, now_.position, now_.velocity, force_, slow_);
  }

  /// Slides until the point leaves the face, stops, or its friction may change. Returns whether a barrier or
  /// a tree has caught the point.
  bool slide_on(const Support<D>& support) {
    log_.touches(now_);
    const Sliding<D>& sliding = support.sliding;
    const double speed = sliding.velocity.norm(), slow = run_.stop_speed;
    double longest = run_.stop_time - now_.time;
    if (run_.forces.air.drag > 0) longest = std::min(longest, leg_);
    if (!support.constant) longest = std::min(longest, varying_leg);
    if (slow > 0 && speed <= slow * (1 + 1e-9)) longest = std::min({longest, rest_time, time_to_rest()});
    bool stops = false;
    Arc<D> arc;
    if (support.stays) {
      arc = parabola(now_.time, longest, FlightState<D>{now_.position, Vec<D>::Zero(), Vec<D>::Zero()});
    } else {
      arc = slide(now_.time, longest, now_.position, sliding, slow, stops);
    }
    ArcEnd end;
    if (!support.stays) {
      if (const auto rim = end_on(arc, *support.face)) end.s = *rim;
      if (support.other)
        if (const auto rim = end_on(arc, *support.other); rim && *rim < end.s) end.s = *rim;
      if (const auto exit = first_exit(arc, ground_of(terrain_)); exit && *exit <= end.s)
        end = {*exit, false, true};
    }
    const Obstacle obstacle = first_obstacle(arc, end);
    const Travel before = history_.travel;
    log_.slid(arc, end.s, support.rolls ? TravelMode::roll : TravelMode::slide);
    pass_gates(arc, end.s);
    const bool whole = end.s == 1;
    const double energy = run_.forces.air.drag > 0 ? audit_.energy(now_.position, now_.velocity) : 0;
    const double start = now_.time;
    now_ = {false, end.left, start + end.s * arc.length, arc.position(end.s), arc.velocity(end.s)};
    if (whole && (stops || support.stays)) now_.velocity.setZero();
    if (run_.forces.air.drag > 0)
      audit_.give(std::max(0.0, audit_.energy(now_.position, now_.velocity) - energy));
    rest_.rests(start, now_.time, Pace::without_pivot(speed), Pace::without_pivot(now_.velocity.norm()),
                before);
    return stops_at(obstacle);
  }

  double time_to_rest() const {
    const double left = rest_.time_to_rest(now_.time);
    return std::isinf(left) ? left : std::max(0.0, left) * (1 + 1e-12) + 1e-12;
  }
  bool is_at_rest() { return !std::isnan(history_.stop_time); }

  std::optional<std::string> find_fault() {
    if (!std::isfinite(now_.position.squaredNorm()) ||
        !(now_.velocity.squaredNorm() <= greatest_speed * greatest_speed))
      return "its state is not finite, or it is faster than 100 km/s";
    if (now_.left) return std::nullopt;
    const double depth = depth_below_ground(terrain_, now_.position, near_);
    if (depth > 1e-6) {
      faces_at(terrain_, now_.position, near_,
               faces_);  // an upright face has its top above each of its points
      if (faces_.empty()) return fmt::format("its centre of mass lies {:.2g} m below the ground", depth);
    }
    return audit_.fault(now_.position, now_.velocity);
  }

  BodyHistory finish(StopReason reason) {
    log_.ended(now_, reason);
    return std::move(history_);
  }
  BodyHistory diverged(const std::string& why) {
    history_.fault = why;
    const BodyState last = history_.last;
    log_.ended(now_, StopReason::diverged);
    if (!now_.position.allFinite() || !now_.velocity.allFinite()) history_.last = last;
    return std::move(history_);
  }
  BodyHistory left() {
    history_.fault = left_text(domain_of(terrain_), now_.position);
    return finish(StopReason::left_domain);
  }
  BodyHistory end(StopReason reason) {
    if (is_at_rest()) {
      reason = StopReason::stopped;
      history_.travel = rest_.travel();
    }
    return finish(reason);
  }

  /// What is recorded of an arrival at a gate or barrier.
  Arrival arrival(const Approach::Arrival& at, double time, const Vec<D>& position,
                  const Vec<D>& velocity) const {
    return {time, velocity.norm(), log_.energy(velocity.squaredNorm()),
            log_.height(moved_to<D>(position, at.place)), at.along};
  }
  template <class Curve>
  void pass_gates(const Curve& curve, double end) {
    // Slightly beyond the end, because a path that ends at a barrier may end before a gate there by rounding.
    const double until = std::min(curve.end(), end + 1e-12 * curve.end());
    crossing_.pass_gates(curve, end, until, [&](const Approach::Arrival& at) {
      return arrival(at, curve.time(at.time), curve.position(at.time), curve.velocity(at.time));
    });
  }

  /// What ends a curve before its end: a barrier, a tree, or nothing.
  struct Obstacle {
    std::optional<typename Crossing<D>::AtBarrier> barrier;
    int tree = -1;
  };
  template <class Curve>
  Obstacle first_obstacle(const Curve& curve, ArcEnd& end) {
    Obstacle first;
    const auto cut = [&](double s) { end = {s, false, false, true}; };
    if (crossing_.has_trees())
      if (const auto touch = crossing_.first_tree(curve, end.s)) {
        cut(touch->time);
        first.tree = touch->tree;
      }
    if (crossing_.has_barriers()) first.barrier = crossing_.first_barrier(curve, end.s);
    if (first.barrier) {
      cut(first.barrier->at.time);
      first.tree = -1;
    }
    crossing_.pass_trees(
        curve, end.s, [&](double s) { return log_.energy(curve.velocity(s).squaredNorm()); },
        [&](double s) { return curve.time(s); });
    return first;
  }
  /// Whether a barrier or a tree catches the rock. Otherwise it goes on, slower if it went through.
  bool stops_at(const Obstacle& obstacle) {
    typename Crossing<D>::Effect effect;
    if (obstacle.barrier) {
      const auto& [barrier, at] = *obstacle.barrier;
      effect = crossing_.meets_barrier(barrier, arrival(at, now_.time, now_.position, now_.velocity));
      now_.velocity *= effect.left;
      log_.slowed(now_.time, effect.left);
    } else if (obstacle.tree >= 0) {
      const double energy = log_.energy(now_.velocity.squaredNorm());
      effect = crossing_.hits_tree(obstacle.tree, now_.time, energy, now_.position, now_.velocity);
      if (effect.left != 1) log_.slowed(now_.time, effect.left);
    }
    return effect.caught;
  }

  const Terrain& terrain_;
  const PointRun<D>& run_;
  const Body<D>& body_;
  Landing<D> now_;
  BodyHistory history_;
  PointLog<D> log_;
  RestWatch rest_;
  PointContact<D> contact_;
  EnergyAudit<D> audit_;
  double slow_;  ///< m/s
  Crossing<D> crossing_;
  std::vector<Face<D>>& faces_ = kept_faces<D>();  ///< on which the point is
  int near_ = -1;                                  ///< the segment of its last touch, in 2D; -1: not known
  Vec<D> force_ = Vec<D>::Zero();                  ///< m/s2, gravity and the push of the air in the next leg
  double leg_ = 0;                                 ///< s, its longest duration in air
};

}  // namespace

template <int D>
BodyHistory run_point(const Body<D>& body, const typename Geometry<D>::Terrain& terrain,
                      const PointRun<D>& run) {
  return PointRunner<D>(body, terrain, run).run();
}

template BodyHistory run_point(const Body<2>&, const Terrain2&, const PointRun<2>&);
template BodyHistory run_point(const Body<3>&, const Terrain3&, const PointRun<3>&);

}  // namespace flyrock
