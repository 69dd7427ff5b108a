#include "flight/ballistic_run.h"

#include <algorithm>

#include "flight/flight_log.h"

namespace flyrock {

namespace {

/// A flight with the barriers on its path.
template <int D, class Ground>
class BarrierFlight {
 public:
  BarrierFlight(const Body<D>& body, const Ground& ground, const BallisticRun<D>& run)
      : ground_(ground),
        run_(run),
        body_(body),
        log_(body, ground, run),
        sides_(sides_of(run.barriers, body.x.x())) {}

  BodyHistory fly() {
    Landing<D> now{false, false, run_.start_time, body_.x, body_.v};
    while (true) {
      int barrier = -1;
      now = land(BallisticFlight<D>(run_.forces, now.position, now.velocity, now.time), ground_,
                 run_.stop_time, [&](const Arc<D>& arc, ArcEnd& end) {
                   barrier = first_barrier(arc, end);
                   log_.see(arc, end.s);
                 });
      if (barrier < 0) return log_.finish(now, reason_of(now));
      if (catches(barrier, now)) return log_.finish(now, StopReason::caught);
    }
  }

 private:
  static StopReason reason_of(const Landing<D>& end) {
    if (end.on_ground) return StopReason::stopped;
    return end.left ? StopReason::left_domain : StopReason::timed_out;
  }

  /// The first barrier that the arc meets before its end; the arc then ends there. -1: none.
  int first_barrier(const Arc<D>& arc, ArcEnd& end) const {
    int first = -1;
    for (std::size_t b = 0; b < sides_.size(); ++b) {
      if (sides_[b] == 0) continue;
      const auto s = first_arrival(arc, run_.barriers[b].x, sides_[b], end.s);
      if (s && (first < 0 || *s < end.s)) end = {*s, false, false, true}, first = static_cast<int>(b);
    }
    return first;
  }

  /// Whether the barrier catches the rock. Otherwise the rock flies on, slower if it went through the
  /// barrier.
  bool catches(int barrier, Landing<D>& now) {
    const Barrier& fence = run_.barriers[barrier];
    sides_[barrier] = 0;
    const BarrierHit hit = meet(fence, barrier, log_.arrival(fence.x, now));
    const double left = velocity_left(fence, hit);
    now.velocity *= left;
    log_.met(hit, left);
    return hit.outcome == BarrierOutcome::caught;
  }

  const Ground& ground_;
  const BallisticRun<D>& run_;
  const Body<D>& body_;
  FlightLog<D, Ground> log_;
  Sides sides_;
};

}  // namespace

template <int D, class Ground>
BodyHistory run_ballistic(const Body<D>& body, const Ground& ground, const BallisticRun<D>& run) {
  return BarrierFlight<D, Ground>(body, ground, run).fly();
}

template BodyHistory run_ballistic(const Body<2>&, const Profile&, const BallisticRun<2>&);
template BodyHistory run_ballistic(const Body<3>&, const Ground3&, const BallisticRun<3>&);

}  // namespace flyrock
