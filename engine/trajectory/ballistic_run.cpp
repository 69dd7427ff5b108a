#include "trajectory/ballistic_run.h"

#include <algorithm>

#include "trajectory/flight_log.h"

namespace flyrock {

namespace {

/// A flight with the barriers on its way.
template <int D, class Ground>
class BarrierFlight {
 public:
  BarrierFlight(const Body<D>& body, const Ground& ground, const BallisticRun<D>& run)
      : ground_(ground),
        run_(run),
        log_(body, ground, run),
        flight_(run.forces, body.x, body.v, run.start_time),
        sides_(sides_of(run.barriers, body.x.x())) {}

  BodyHistory fly() {
    Landing<D> now;
    now.time = run_.start_time;
    StopReason reason = StopReason::timed_out;
    while (reason == StopReason::timed_out && now.time < run_.stop_time) {
      const Arc<D> arc = flight_.next(run_.stop_time - now.time);
      ArcEnd end = end_of(arc, ground_);
      const int barrier = first_barrier(arc, end);
      log_.see(arc, end.s);
      now = {end.on_ground, end.left, arc.start + end.s * arc.length, arc.position(end.s), arc.velocity(end.s)};
      if (barrier >= 0)
        reason = meet(barrier, now);
      else if (end.on_ground)
        reason = StopReason::stopped;
      else if (end.left)
        reason = StopReason::left_domain;
    }
    return log_.finish(now, reason);
  }

 private:
  /// The barrier that the arc meets before it ends, which then ends it; -1: none.
  int first_barrier(const Arc<D>& arc, ArcEnd& end) const {
    int first = -1;
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      if (sides_[b] == 0) continue;
      const auto s = first_arrival(arc, run_.barriers[b].x, sides_[b], end.s);
      if (s && (first < 0 || *s < end.s)) end = {*s, false, false}, first = static_cast<int>(b);
    }
    return first;
  }

  /// Whether the barrier catches the rock; else it flies on, slower where it went through.
  StopReason meet(int barrier, Landing<D>& now) {
    const Barrier& fence = run_.barriers[barrier];
    sides_[barrier] = 0;
    BarrierHit hit = log_.at_barrier(barrier, fence.x, now);
    hit.outcome = outcome_of(fence, hit);
    now.velocity *= velocity_left(fence, hit);
    log_.met(hit, velocity_left(fence, hit));
    flight_ = BallisticFlight<D>(run_.forces, now.position, now.velocity, now.time);
    return hit.outcome == BarrierOutcome::caught ? StopReason::caught : StopReason::timed_out;
  }

  const Ground& ground_;
  const BallisticRun<D>& run_;
  FlightLog<D, Ground> log_;
  BallisticFlight<D> flight_;
  Sides sides_;
};

}  // namespace

template <int D, class Ground>
BodyHistory run_ballistic(const Body<D>& body, const Ground& ground, const BallisticRun<D>& run) {
  return BarrierFlight<D, Ground>(body, ground, run).fly();
}

template BodyHistory run_ballistic(const Body<2>&, const Profile&, const BallisticRun<2>&);
template BodyHistory run_ballistic(const Body<3>&, const Plane&, const BallisticRun<3>&);

}  // namespace flyrock
