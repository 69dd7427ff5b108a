#pragma once
// Records the history of one body of a world while it runs. Instantiated for D = 2, 3.

#include "flight/history_log.h"
#include "world/world.h"

namespace flyrock {

template <int D>
class BodyLog {
 public:
  using Motion = typename Geometry<D>::Motion;

  /// What it is given outlives it. `cells`: of maps; null: none.
  BodyLog(const World<D>& world, int body, const AnyRun& run, PlanCells* cells, BodyHistory& history);

  /// Records that the body moved along `motion` for dt without contact, in a flight or a step that began at
  /// time `start`.
  void flew(const Motion& motion, double start, double dt);
  /// Records a contact step of length dt in which the body moved along `motion`.
  void stepped(const Motion& motion, double dt, TravelMode mode);
  /// Records an impact of the body. In dense steps a pair that stays together collides in every step: its
  /// impacts of 10 ms are summed, so that the memory does not grow with the number of steps.
  void struck(const Impact& impact);
  /// Records the present state, at the end of a step or an impact.
  void arrived() { include(present()); }
  /// Records that the body touches the terrain now.
  void touches() { log_.touches(body().x); }
  /// Records that the run of the body ends now.
  void ended(StopReason reason);

 private:
  const Body<D>& body() const { return world_.bodies[index_]; }
  BodyState along(const Motion& motion, double t, double time) const;
  BodyState present() const;
  void include(const BodyState& state);
  Impact* summed_with(const Impact& impact);
  using Store = void (HistoryLog<D>::*)(const BodyState&, const Attitude<D>&);
  void store(Store how, const Motion& motion, double t, double time);
  void passes(const Motion& motion, double dt);

  const World<D>& world_;
  int index_;
  bool keep_impacts_;
  HistoryLog<D> log_;
};

}  // namespace flyrock
