#pragma once
// What no body can do, whatever the cause: lie below the ground, or have energy from nowhere.

#include <optional>
#include <string>
#include <vector>

#include "world/world.h"

namespace flyrock {

/// Watches a world while it runs. A fault is an error of the program or of a law, never a result.
/// Instantiated for D = 2, 3.
template <int D>
class Faults {
 public:
  /// `exact_flight`: false where fixed steps may carry a body into the ground before it is pushed out.
  Faults(const World<D>& world, bool exact_flight);

  /// Whether the centre of mass lies below the ground: a vertical line up from it meets a facet from behind.
  /// A centre that is deeper than a step may bring it is meant; in words, with the depth.
  std::optional<std::string> below_ground(int body) const;

  /// Whether the energy of the world exceeds what it may be; in words, with both:
  ///   kinetic + potential + springs <= that of the start + World::energy_given + 1e-6 of the greatest,
  /// the greatest that the bodies ever had as speed, as height above or below their start and as height over
  /// their own size. To be asked after each flight and step.
  std::optional<std::string> energy_from_nowhere();

 private:
  double energy_of(const Body<D>& body) const;

  const World<D>& world_;
  bool exact_flight_;
  std::vector<Vec<D>> starts_;
  std::vector<double> last_;  ///< J, of each body that is still present
  double allowed_ = 0;        ///< J
  double greatest_ = 0;       ///< J
};

}  // namespace flyrock
