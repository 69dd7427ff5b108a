#pragma once
// Records the history of one point, arc by arc. Instantiated for D = 2, 3.

#include "flight/history_log.h"
#include "flight/point_run.h"

namespace flyrock {

template <int D>
class PointLog {
 public:
  using Terrain = typename Geometry<D>::Terrain;

  /// What it is given outlives it.
  PointLog(const Body<D>& body, const Terrain& terrain, const PointRun<D>& run, BodyHistory& history);

  /// Records that the point followed a curve, which is an Arc or a Parabola, to its parameter `end`, in a
  /// mode: in the air (flight, before its first landing or after it) or on the ground.
  template <class Curve>
  void flew(const Curve& curve, double end) {
    see(curve, end, log_.flies(end * curve.length));
  }
  void slid(const Arc<D>& arc, double end, TravelMode mode);
  /// Records that the point touches the ground now.
  void touches(const Landing<D>& now) { log_.touches(now.position); }
  /// Records that an impact has changed the velocity.
  void struck(const Landing<D>& after);
  /// Records that a barrier or a tree has scaled velocity and spin by `left`.
  void slowed(double time, double left);
  void ended(const Landing<D>& end, StopReason reason);

  /// The kinetic energy at a speed [J].
  double energy(double squared_speed) const {
    return 0.5 * (body_.mass * squared_speed + twice_spin_energy_);
  }
  /// Height above the ground [m]; beyond an end of the terrain, above the ground at that end.
  double height(const Vec<D>& place) const;

 private:
  template <class Curve>
  void see(const Curve& curve, double end, TravelMode mode);
  void follow(const Parabola<D>& path, double end, TravelMode mode);
  void follow(const Arc<D>& arc, double end, TravelMode mode);
  BodyState state(double time, const Vec<D>& position, const Vec<D>& velocity) const;
  template <class Curve>
  BodyState at(const Curve& curve, double s) const {
    return state(curve.time(s), curve.position(s), curve.velocity(s));
  }
  void store(const BodyState& state) { log_.store(state, attitude(state.time)); }
  /// The attitude at a time since the last barrier.
  Attitude<D> attitude(double time) const { return attitude_.turned(spin_ * (time - spin_since_)); }
  template <class Curve>
  void widen(const Curve& curve, double s);
  void include(double time, const Vec<D>& position, const Vec<D>& velocity);
  void apex(const Parabola<D>& path, double end);
  void turns(const Arc<D>& arc, double end);
  void highest(const Arc<D>& arc, double end);
  void bins(const Arc<D>& arc, double end);
  void map(const Arc<D>& arc, double end);

  const Body<D>& body_;
  const Terrain& terrain_;
  const PointRun<D>& run_;
  BodyHistory& history_;
  HistoryLog<D> log_;
  typename Space<D>::Spin spin_;  ///< since the time spin_since_, because barriers change it
  double spin_since_;             ///< s
  Attitude<D> attitude_;          ///< at that time
  double twice_spin_energy_;      ///< J
  double max_squared_speed_ = 0;  ///< m2/s2, without keep_extremes
};

}  // namespace flyrock
