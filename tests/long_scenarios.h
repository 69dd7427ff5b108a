#pragma once
// The shipped scenarios of which a trial takes seconds.

#include <set>
#include <string>

namespace flyrock {

/// Scenarios of many bodies or nodes, by their names below scenarios/. One trial of them takes as long as
/// many other scenarios together, under sanitizers minutes.
inline const std::set<std::string> long_trials{"course/column_collapse.lua",   "course/drum.lua",
                                               "quarry/bench_failure_2d.yaml", "quarry/block_impact_3d.yaml",
                                               "quarry/joint_blocks_3d.yaml",  "quarry/muck_pile.lua",
                                               "quarry/rock_wall_3d.yaml"};

/// Scenarios whose steps are so short that 0.2 s of motion take seconds; they themselves end sooner.
inline const std::set<std::string> short_steps{"course/bar_on_wall.yaml", "course/brazilian.yaml",
                                               "course/painleve.yaml", "course/restitution_from_waves.yaml",
                                               "course/waves.lua"};

}  // namespace flyrock
