#pragma once
// Checks for impossible states: a body below the ground, or energy from nowhere.

#include <optional>
#include <string>
#include <vector>

#include "world/world.h"

namespace flyrock {

/// A run has diverged that is faster [m/s], or, of a point, has so many events in a row that together advance
/// time by less than a millisecond. Other bodies: ProgressWatch (jam.h).
inline constexpr double greatest_speed = 1e5;
inline constexpr int most_idle = 10'000;

/// The text of a fault: more energy [J] than a body may have.
std::string energy_from_nowhere_text(double excess);
/// The text of a fault: an impact that gained this share of the kinetic energy.
std::string energy_of_impact_text(double share);

/// Checks a world while it runs. A fault is an error of the program or of a law, never a result. Instantiated
/// for D = 2, 3.
template <int D>
class Faults {
 public:
  /// `exact_flight`: false if fixed steps may move a body into the ground before it is pushed out.
  Faults(const World<D>& world, bool exact_flight);

  /// Whether a place of the centre of mass lies below the ground, deeper than one step can push it. The test
  /// is that a vertical line up from it meets a facet from below, and that it is not on the surface: an
  /// upright wall has its top above each of its places. A compound, or the points of a mesh, may straddle a
  /// peak: then all its points and rims must be below, too. The text of the fault gives the depth.
  std::optional<std::string> below_ground(int body, const Vec<D>& place) const;

  /// Whether the energy of the world exceeds its limit. The text of the fault gives the excess [J]. The
  /// condition for a correct world is
  ///   kinetic + potential + springs
  ///     <= start energy + World::energy_given + World::energy_in_doubt + 1e-6 x greatest energy.
  /// The greatest energy is the largest value so far of the sum over the bodies of kinetic energy and
  /// (m g + given force) (distance from the start + size). Call this function after each flight and step.
  std::optional<std::string> energy_from_nowhere();

  /// The kinetic and potential energy of a body now [J]; 0 of one that has left.
  double energy_of(int body) const;
  /// A body has left, or a barrier or a tree has slowed it: this energy [J] is no longer the world's. It is
  /// that of the instant, because air, driven bodies and contacts have changed it since the last check.
  void take(double energy) { allowed_ -= energy; }
  /// A body with a fault has left. How much of its energy came from nowhere is unknown, so the balance begins
  /// anew with the others.
  void begin_anew() { allowed_ = world_.total_energy() - world_.energy_given(); }

 private:
  bool straddles(const Body<D>& body, const Vec<D>& place) const;

  const World<D>& world_;
  bool exact_flight_;
  std::vector<Vec<D>> starts_;
  double allowed_ = 0;   ///< J
  double greatest_ = 0;  ///< J
};

}  // namespace flyrock
