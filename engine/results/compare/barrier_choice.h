#pragma once
// Which barriers of a sweep hold enough: at each place the smallest one.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "results/results.h"

namespace flyrock {

struct Plan;

/// What the share that a barrier must hold is a share of.
enum class HeldSense { per_trial, of_arriving, of_all };
/// Their keys in summary.json.
inline constexpr std::array<std::string_view, 3> held_sense_names = {"per_trial", "of_arriving", "of_all"};
/// The shares that a reader of the page may choose.
inline constexpr std::array<double, 5> held_shares = {0.8, 0.9, 0.95, 0.99, 0.999};
/// The choice of the first sentence.
inline constexpr double usual_held_share = 0.95;

struct BarrierChoice {
  std::size_t barrier = 0, group = 0;  ///< of the scenario; of PointResult::crossings
  HeldSense sense = HeldSense::per_trial;
  double held = usual_held_share;
  std::vector<std::size_t> holding = {};   ///< the points at which the barrier is shown to hold
  std::vector<std::size_t> smallest = {};  ///< those of which none at the same place holds with less
  std::string text = {};  ///< by place: "x 11 m: 2 m high with 50 kJ. x 13 m: none of the sweep"
};

/// Whether enough trials have a rock that arrives at the barrier: at least 10.
bool is_tried(const PointResult& point, std::size_t barrier, std::size_t group);

/// The barriers of which a height or a capacity is swept.
std::vector<std::size_t> swept_barriers(const Plan& plan);

/// A point holds a share if the upper end of the 95 % interval of what gets past is at most the rest. Of two
/// that hold at one place (of all axes but height and capacity) the one with less height or capacity, and not
/// more of the other, is the smaller.
BarrierChoice choose_barrier(const Plan& plan, const std::vector<PointResult>& points, std::size_t barrier,
                             std::size_t group, HeldSense sense, double held);

/// All choices of the page: every swept barrier, group, sense and share.
std::vector<BarrierChoice> barrier_choices(const Plan& plan, const std::vector<PointResult>& points);

/// "Smallest fence of the sweep that no rock of blocks gets past in 95 % of the trials, with 95 % confidence:
/// x 11 m: 2 m high with 50 kJ. x 13 m: none of the sweep." of each swept barrier, for the group
/// that goes farthest; empty without one.
std::string barrier_choice_text(const Plan& plan, const Results& results);

}  // namespace flyrock
