#pragma once
// Records the histories of the bodies of a world while it runs. Instantiated for D = 2, 3.

#include <span>
#include <vector>

#include "record/plan_cells.h"
#include "world/world.h"

namespace flyrock {

template <int D>
class Observer {
 public:
  using Motion = typename Geometry<D>::Motion;

  /// `every`: seconds between stored trajectory points, 0 for none; the ends of each flight are stored as
  /// well. `bin_width`: m, of BodyHistory::path. `cells`: of each body, for maps; empty: none.
  Observer(const World<D>& world, double every, bool keep_impacts, double bin_width,
           std::span<PlanCells> cells, std::vector<BodyHistory>& histories);

  /// Records that `body` moved along `motion` for dt without contact, in a flight or a step that began at
  /// time `start`.
  void flew(int body, const Motion& motion, double start, double dt);
  /// Records a contact step of length dt in which the body moved along `motion`.
  void stepped(int body, const Motion& motion, double dt, TravelMode mode);
  /// Records the end of a step or an impact: its impacts and the present state of all bodies.
  void arrived();
  /// Records that the body touches the terrain now. This is a landing if the body has flown.
  void landed(int body);
  /// Records that the run of the body ends now.
  void ended(int body, StopReason reason);

 private:
  static constexpr int up = D - 1;  ///< the vertical axis

  BodyState along(int body, const Motion& motion, double t, double time) const;
  BodyState present(int body) const;
  void extremes(int body, const BodyState& state);
  void store(int body, const BodyState& state, const Attitude<D>& attitude);
  void store(int body, const Motion& motion, double t, double time);
  void clearance(int body, const Path<D>& path, double dt);
  void speeds(int body, const Motion& motion, double dt);
  template <class SquaredSpeed>
  void map(int body, const Path<D>& path, double dt, SquaredSpeed squared_speed);

  const World<D>& world_;
  double every_;
  bool keep_impacts_;
  std::span<PlanCells> cells_;
  std::vector<BodyHistory>& histories_;
  std::vector<double> next_sample_;
  std::vector<double> first_contact_height_;
  std::vector<bool> has_flown_;
  std::vector<TravelMode> mode_;  ///< mode of the last motion
};

}  // namespace flyrock
