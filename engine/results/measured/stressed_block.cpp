#include "results/measured/stressed_block.h"

#include <algorithm>

namespace flyrock {

std::vector<StressedBlock> most_stressed(const TrialRecords& chunk) {
  std::vector<StressedBlock> blocks;
  for (const auto& [trial, row] : chunk.series_stress) {
    if (trial != chunk.series_stress.front().trial) continue;
    const auto known = std::find_if(blocks.begin(), blocks.end(),
                                    [&](const StressedBlock& block) { return block.at.body == row.body; });
    if (known == blocks.end())
      blocks.push_back({row, {}, {}});
    else if (is_stressed_more(row, known->at))
      known->at = row;
  }
  for (StressedBlock& block : blocks) {
    const auto is_of_block = [&](std::uint64_t trial, const auto& row) {
      return trial == chunk.series_stress.front().trial && row.time == block.at.time &&
             row.body == block.at.body;
    };
    for (const auto& [trial, row] : chunk.series_nodes)
      if (is_of_block(trial, row)) block.nodes.push_back(row);
    for (const auto& [trial, row] : chunk.series_cells)
      if (is_of_block(trial, row)) block.cells.push_back(row);
  }
  return blocks;
}

}  // namespace flyrock
