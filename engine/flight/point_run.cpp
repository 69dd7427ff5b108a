#include "flight/point_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "flight/faults.h"
#include "flight/flight_log.h"
#include "flight/ground.h"
#include "flight/point_support.h"
#include "flight/rest.h"
#include "flight/run.h"

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
    return fmt::format("it has {:.3g} J more than gravity, air and impacts gave it", mass_ * excess);
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
        log_(body, terrain, run),
        rest_(RestWatch::Kind::point, run.stop_speed, log_.history()),
        contact_(body, terrain, run.origin, run.surfaces),
        audit_(body, run.forces.gravity),
        slow_(std::max(0.05 * run.rest_speed, 1e-9)),
        to_barriers_(approaches(run.barriers, in_plan(body.x))),
        trees_(run.forest, terrain, body.volume, run.key) {}

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
      if (caught) return log_.finish(now_, StopReason::caught);
      if (now_.on_ground) return log_.finish(now_, StopReason::stopped);
      if (now_.left) return log_.finish(now_, StopReason::left_domain);
      if (now_.time >= run_.stop_time) return log_.finish(now_, StopReason::timed_out);
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
                  log_.flew(arc, end.s);
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
    log_.flew(path, end.s);
    now_ = {end.on_ground, end.left, path.time(end.s), path.position(end.s), path.velocity(end.s)};
    return stops_at(obstacle);
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
      double approach = -std::numeric_limits<double>::infinity();
      for (const Face<D>& face : faces_)
        if (const double of_face = -v.dot(face.normal); of_face > approach) first = &face, approach = of_face;
      const double rounding = rounding_of_speed(v.norm());
      if (!(approach > rounding)) return approach < -rounding;
      log_.landed(now_);
      if (approach > run_.rest_speed && i < most_impacts)
        collide(*first);
      else
        close(*first, approach);
    }
  }

  void collide(const Face<D>& face) {
    const auto bounce = contact_.strike(face, now_.time, now_.position, now_.velocity);
    log_.struck(now_);
    if (run_.keep_impacts) log_.keep(contact_.record(face, now_.time, now_.position, bounce));
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
    const auto grip = contact_.grip(face, now_.time, now_.position, v, approach);
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
    log_.landed(now_);
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
    const Travel before = log_.history().travel;
    log_.slid(arc, end.s, support.rolls ? TravelMode::roll : TravelMode::slide);
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
  bool is_at_rest() { return !std::isnan(log_.history().stop_time); }

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

  BodyHistory diverged(const std::string& why) {
    log_.history().fault = why;
    const BodyState last = log_.history().last;
    BodyHistory history = log_.finish(now_, StopReason::diverged);
    if (!now_.position.allFinite() || !now_.velocity.allFinite()) history.last = last;
    return history;
  }
  BodyHistory left() {
    log_.history().fault = left_text(domain_of(terrain_), now_.position);
    return log_.finish(now_, StopReason::left_domain);
  }
  BodyHistory end(StopReason reason) {
    if (is_at_rest()) {
      reason = StopReason::stopped;
      log_.history().travel = rest_.travel();
    }
    return log_.finish(now_, reason);
  }

  /// What ends a curve before its end: a barrier, a tree, or nothing.
  struct Obstacle {
    int barrier = -1, tree = -1;
  };
  template <class Curve>
  Obstacle first_obstacle(const Curve& curve, ArcEnd& end) {
    Obstacle first;
    if (trees_.any() && !trees_.passive())
      if (const auto touch = trees_.first(curve, end.s)) {
        end = {touch->time, false, false, true};
        first.tree = touch->tree;
      }
    if (!to_barriers_.empty()) first.barrier = first_barrier(curve, end);
    if (first.barrier >= 0) first.tree = -1;
    if (trees_.any() && trees_.passive()) count_trees(curve, end.s);
    return first;
  }
  bool stops_at(const Obstacle& obstacle) {
    if (obstacle.barrier >= 0) return catches(obstacle.barrier);
    return obstacle.tree >= 0 && caught_by_tree(obstacle.tree);
  }
  bool caught_by_tree(int tree) {
    double left = 1;
    const double energy = log_.energy(now_.velocity.squaredNorm());
    const TreeHit hit = trees_.hit(tree, now_.time, energy, now_.position, now_.velocity, left);
    log_.met(hit, left);
    return left == 0;
  }
  /// Trees that change nothing: the path goes on through them.
  template <class Curve>
  void count_trees(const Curve& curve, double end) {
    while (const auto touch = trees_.first(curve, end)) {
      Vec<D> velocity = curve.velocity(touch->time);
      double left = 1;
      log_.met(trees_.hit(touch->tree, curve.time(touch->time), log_.energy(velocity.squaredNorm()),
                          curve.position(touch->time), velocity, left),
               left);
    }
  }

  /// The first barrier that the curve meets before its end; it then ends there. -1: none.
  template <class Curve>
  int first_barrier(const Curve& curve, ArcEnd& end) {
    int first = -1;
    for (std::size_t b = 0; b < to_barriers_.size(); ++b) {
      const auto arrival = to_barriers_[b].arrival(in_plan(curve), end.s);
      if (!arrival || (first >= 0 && arrival->time >= end.s)) continue;
      end = {arrival->time, false, false, true};
      first = static_cast<int>(b);
      at_ = *arrival;
    }
    for (Approach& to_barrier : to_barriers_) to_barrier.move_to(in_plan(curve.position(end.s)));
    return first;
  }

  /// Whether the barrier catches the rock. Otherwise the rock goes on, slower if it went through the barrier.
  bool catches(int barrier) {
    const Barrier& fence = run_.barriers[barrier];
    to_barriers_[barrier].arrive();
    const BarrierHit hit = meet(fence, barrier, log_.arrival(at_, now_), body_.volume);
    const double left = velocity_left(fence, hit);
    now_.velocity *= left;
    log_.met(hit, left);
    return hit.outcome == BarrierOutcome::caught;
  }

  const Terrain& terrain_;
  const PointRun<D>& run_;
  const Body<D>& body_;
  Landing<D> now_;
  FlightLog<D> log_;
  RestWatch rest_;
  PointContact<D> contact_;
  EnergyAudit<D> audit_;
  double slow_;  ///< m/s
  std::vector<Approach> to_barriers_;
  TreeWatch<D> trees_;
  Approach::Arrival at_;                           ///< where the path met the last barrier
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
