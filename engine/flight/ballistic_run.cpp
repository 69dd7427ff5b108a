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
        to_barriers_(approaches(run.barriers, in_plan(body.x))) {}

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
  int first_barrier(const Arc<D>& arc, ArcEnd& end) {
    int first = -1;
    for (std::size_t b = 0; b < to_barriers_.size(); ++b) {
      const auto arrival = to_barriers_[b].arrival(arc.in_plan(), end.s);
      if (!arrival || (first >= 0 && arrival->time >= end.s)) continue;
      end = {arrival->time, false, false, true};
      first = static_cast<int>(b);
      at_ = *arrival;
    }
    for (Approach& to_barrier : to_barriers_) to_barrier.move_to(in_plan(arc.position(end.s)));
    return first;
  }

  /// Whether the barrier catches the rock. Otherwise the rock flies on, slower if it went through the
  /// barrier.
  bool catches(int barrier, Landing<D>& now) {
    const Barrier& fence = run_.barriers[barrier];
    to_barriers_[barrier].arrive();
    const BarrierHit hit = meet(fence, barrier, log_.arrival(at_, now), body_.volume);
    const double left = velocity_left(fence, hit);
    now.velocity *= left;
    log_.met(hit, left);
    return hit.outcome == BarrierOutcome::caught;
  }

  const Ground& ground_;
  const BallisticRun<D>& run_;
  const Body<D>& body_;
  FlightLog<D, Ground> log_;
  std::vector<Approach> to_barriers_;
  Approach::Arrival at_;  ///< where the flight met the last barrier
};

}  // namespace

template <int D, class Ground>
BodyHistory run_ballistic(const Body<D>& body, const Ground& ground, const BallisticRun<D>& run) {
  return BarrierFlight<D, Ground>(body, ground, run).fly();
}

template BodyHistory run_ballistic(const Body<2>&, const Profile&, const BallisticRun<2>&);
template BodyHistory run_ballistic(const Body<3>&, const Ground3&, const BallisticRun<3>&);

}  // namespace flyrock
