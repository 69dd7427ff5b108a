#pragma once
// Writes the history of one point, arc by arc.

#include "flight/point_run.h"

namespace flyrock {

template <int D>
class FlightLog {
 public:
  using Terrain = typename Geometry<D>::Terrain;

  /// Body, terrain and run outlive the log.
  FlightLog(const Body<D>& body, const Terrain& terrain, const PointRun<D>& run);

  /// Records that the point followed a curve, which is an Arc or a Parabola, to its parameter `end`, in a
  /// mode: in the air (flight, before its first landing or after it) or on the ground.
  template <class Curve>
  void flew(const Curve& curve, double end);
  void slid(const Arc<D>& arc, double end, TravelMode mode);
  /// The point touches the ground now. This is a landing if it has flown.
  void landed(const Landing<D>& now) {
    if (!history_.landed && has_flown_) land(now);
  }
  /// An impact has changed the velocity. Its record is kept only if the run keeps impacts.
  void struck(const Landing<D>& after);
  void keep(const Impact& impact) { history_.impacts.push_back(impact); }
  /// The state in which the flight arrives at a barrier at a place in plan.
  Arrival arrival(const Approach::Arrival& at, const Landing<D>& now) const;
  /// Records that a barrier or a tree has acted and scaled velocity and spin by `left`.
  void met(const BarrierHit& hit, double left);
  void met(const TreeHit& hit, double left);
  BodyHistory finish(const Landing<D>& end, StopReason reason);

  BodyHistory& history() { return history_; }
  /// The kinetic energy at a speed [J].
  double energy(double squared_speed) const {
    return 0.5 * (body_.mass * squared_speed + twice_spin_energy_);
  }

 private:
  void slow(double time, double left);
  void land(const Landing<D>& now);
  template <class Curve>
  void see(const Curve& curve, double end, TravelMode mode);
  template <class Curve>
  void sample(const Curve& curve, double end);
  void follow(const Parabola<D>& path, double end);
  void follow(const Arc<D>& arc, double end);
  BodyState state(double time, const Vec<D>& position, const Vec<D>& velocity) const;
  template <class Curve>
  BodyState at(const Curve& curve, double s) const;
  /// The attitude at a time since the last barrier.
  Attitude<D> attitude(double time) const { return attitude_.turned(spin_ * (time - spin_since_)); }
  void store(const BodyState& s);
  template <class Curve>
  void widen(const Curve& curve, double s);
  void include(double time, const Vec<D>& position, const Vec<D>& velocity);
  double height(const Vec<D>& p) const;
  template <class Curve>
  void pass_gates(const Curve& curve, double end);
  void apex(const Parabola<D>& path, double end);
  void turns(const Arc<D>& arc, double end);
  void highest(const Arc<D>& arc, double end);
  void bins(const Arc<D>& arc, double end);
  void over_ground(const Path<D>& path, double dt);
  void map(const Path<D>& path, double dt);
  void map(const Arc<D>& arc, double end);

  const Body<D>& body_;
  const Terrain& terrain_;
  const PointRun<D>& run_;
  BodyHistory history_;
  typename Space<D>::Spin spin_;  ///< since the time spin_since_, because barriers change it
  double spin_since_;             ///< s
  Attitude<D> attitude_;          ///< at that time
  double twice_spin_energy_;      ///< J
  double next_sample_;
  TravelMode mode_ = TravelMode::flight;  ///< of the last arc
  bool has_flown_ = false;
  int near_ = -1;                    ///< the segment below the end of the last arc, in 2D; -1: not known
  double first_contact_height_ = 0;  ///< m
  double max_squared_speed_ = 0;     ///< m2/s2, without keep_extremes
  std::vector<Approach> to_gates_;
};

}  // namespace flyrock
