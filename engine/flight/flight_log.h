#pragma once
// Writes the history of one ballistic flight, arc by arc.

#include "flight/ballistic_run.h"

namespace flyrock {

template <int D, class Ground>
class FlightLog {
 public:
  /// Body, ground and run outlive the log.
  FlightLog(const Body<D>& body, const Ground& ground, const BallisticRun<D>& run);

  /// Records that the flight followed `arc` to s = end in [0, 1].
  void see(const Arc<D>& arc, double end);
  /// The state in which the flight arrives at a barrier at a place in plan.
  Arrival arrival(const Approach::Arrival& at, const Landing<D>& now) const;
  /// Records that a barrier has acted and scaled velocity and spin by `left`.
  void met(const BarrierHit& hit, double left);
  BodyHistory finish(const Landing<D>& end, StopReason reason);

 private:
  BodyState state(double time, const Vec<D>& position, const Vec<D>& velocity) const;
  BodyState at(const Arc<D>& arc, double s) const;
  /// The attitude at a time since the last barrier.
  Attitude<D> attitude(double time) const { return attitude_.turned(spin_ * (time - spin_since_)); }
  void store(const BodyState& s);
  void widen(const BodyState& s);
  double energy(double squared_speed) const {
    return 0.5 * (body_.mass * squared_speed + twice_spin_energy_);
  }
  double height(const Vec<D>& p) const;
  void pass_gates(const Arc<D>& arc, double end);
  void highest(const Arc<D>& arc, double end);
  void bins(const Arc<D>& arc, double end);

  const Body<D>& body_;
  const Ground& ground_;
  const BallisticRun<D>& run_;
  BodyHistory history_;
  typename Space<D>::Spin spin_;  ///< since the time spin_since_, because barriers change it
  double spin_since_;             ///< s
  Attitude<D> attitude_;          ///< at that time
  double twice_spin_energy_;      ///< J
  double next_sample_;
  std::vector<Approach> to_gates_;
};

}  // namespace flyrock
