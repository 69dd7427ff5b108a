#pragma once
// Runs that do not go on: time that stands still, and bodies that a driven one jams.

#include <cstdint>
#include <string>
#include <vector>

#include "world/world.h"

namespace flyrock {

/// The work of a world that its time does not repay. Work is counted, never timed, so that results do not
/// depend on the machine. A unit is about 0.04 us of a processor of 2023.
///
/// Time stands still: the work since time last advanced by a step length, or a millisecond. Time crawls: the
/// debt, which each step's work increases. A step and a step length of time repay what a healthy world of as
/// many bodies and contacts may need for them, so that a world of hundreds has no debt.
class ProgressWatch {
 public:
  static constexpr std::uint64_t most_steps = 10'000;      ///< or impacts, without progress
  static constexpr std::uint64_t most_work = 500'000'000;  ///< units; about 20 s
  static constexpr std::uint64_t of_search = 10;           ///< of each iteration for the time of a touch
  static constexpr std::uint64_t of_solve = 50;  ///< of each body and contact, for all around a solve
  static constexpr std::uint64_t in_3d = 4;      ///< times as much

  /// Units of each body and contact that a step and a step length of time repay, at 1000 iterations a solve:
  /// as much as one solve to the last sweep, and as ten. Of piles of 100 bodies that fall, the debt reaches a
  /// tenth of `most_work`.
  static constexpr double repaid_by_step = 2'000, repaid_by_time = 20'000;

  /// Counts from the present work of a world on, which may have run before.
  template <int D>
  void begin(const World<D>& world);
  /// Call after each flight, step and impact. Returns whether the limits are reached.
  template <int D>
  bool stands_still(const World<D>& world);
  /// "no progress in 10000 steps: the contacts of this rock cannot all hold at once"
  std::string fault() const;

 private:
  template <int D>
  double work_since(const World<D>& world);

  std::uint64_t steps_ = 0;  ///< since marked_time_
  double work_ = 0;          ///< the same
  double marked_time_ = 0;   ///< s
  double debt_ = 0;
  std::uint64_t steps_in_debt_ = 0;
  double time_ = 0;  ///< s, of the world, when it was last looked at
  std::uint64_t problems_ = 0, of_solver_ = 0, searches_ = 0;  ///< the same
};

/// Finds bodies that a driven one jams against something, where no self-stress shows it (World::pressed): of
/// the last solves of contacts that a driven body reaches, many missed the motion that it asks for; or a
/// penetration among them is deep and grows step by step.
template <int D>
class JamWatch {
 public:
  static constexpr int most_steps = 10;  ///< steps or impacts that show it
  static constexpr double missed_share =
      0.1;  ///< of the driven speed, that the residual of a solve leaves open
  static constexpr double deep_share = 1e-3;  ///< of the size; a deeper contact is not pushed out

  explicit JamWatch(const World<D>& world);
  /// Call after each step and impact. The bodies that are jammed; empty: none.
  const std::vector<int>& look();

 private:
  void find_reached();
  bool is_reached(int body) const { return body >= 0 && reached_[static_cast<std::size_t>(body)]; }
  double deepest_share() const;

  const World<D>& world_;
  bool any_driven_ = false;
  std::vector<char> reached_;  ///< [body], moves with or touches, over others, a driven body that moves
  std::vector<int> jammed_;
  double fastest_ = 0;  ///< m/s, approach of driven bodies at their contacts
  /// J, of the driven bodies at the contacts of the last solve, and the sum of its sizes: two that move
  /// together and hold a body do no work on it
  double work_ = 0, work_in_all_ = 0;
  double last_deepest_ = 0;     ///< share of the size
  std::uint64_t problems_ = 0;  ///< solves of the world, when it was last looked at
  int missed_ = 0, met_ = 0;    ///< solves that missed the motion since `most_steps` in a row met it
  int grown_ = 0;               ///< steps in a row in which the penetration grew
};

}  // namespace flyrock
