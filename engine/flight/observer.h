#pragma once
// Writes the histories of the bodies of a world while it runs. Instantiated for D = 2, 3.

#include <vector>

#include "world/world.h"

namespace flyrock {

template <int D>
class Observer {
 public:
  using Motion = typename Geometry<D>::Motion;

  /// `every`: seconds between stored points of trajectories, 0 for none; the ends of each flight are stored
  /// too. `bin_width`: m, of BodyHistory::path.
  Observer(const World<D>& world, double every, bool keep_impacts, double bin_width,
           std::vector<BodyHistory>& histories);

  /// The world flew, or stepped without contact at `body`, along `motion` for dt; `start` is the time at its
  /// begin.
  void flew(int body, const Motion& motion, double start, double dt);
  /// A contact step of length dt has ended, in which the body moved along `motion`.
  void stepped(int body, const Motion& motion, double dt, TravelMode mode);
  /// A step or an impact has ended: notes its impacts, and where all bodies are now.
  void arrived();
  /// The body touches the terrain at the present time: it has landed, where it had flown.
  void landed(int body);
  /// The run of the body ends now.
  void ended(int body, StopReason reason);

 private:
  static constexpr int up = D - 1;  ///< the vertical axis

  BodyState state(int body, double time, const Vec<D>& x, const Vec<D>& v, const Turned<D>& turned) const;
  BodyState along(int body, const Motion& motion, double t, double time) const;
  BodyState present(int body) const;
  void extremes(int body, const BodyState& state);
  void store(int body, const BodyState& state);
  void clearance(int body, const Path<D>& path, double dt);
  void speeds(int body, const Motion& motion, double dt);

  const World<D>& world_;
  double every_;
  bool keep_impacts_;
  std::vector<BodyHistory>& histories_;
  std::vector<double> next_sample_;
  std::vector<double> first_contact_height_;
  std::vector<bool> has_flown_;
  std::vector<TravelMode> mode_;  ///< of what was moved last
};

}  // namespace flyrock
