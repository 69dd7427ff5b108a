#pragma once
// The blocks that joints have cut, over the trials of one sweep point.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "record/code_counts.h"
#include "record/records.h"
#include "results/statistics/share.h"
#include "scenario/scenario.h"

namespace flyrock {

/// Which blocks are counted.
enum class BlockPart { all, removable, below_1, below_1_3 };
inline constexpr std::array<std::string_view, 4> block_part_names = {"all", "removable", "factor_below_1",
                                                                     "factor_below_1_3"};

/// A mean over trials with its 95 % interval (Student, the trial is the unit); NaN for too few trials.
struct MeanOfTrials {
  double mean = 0;
  Interval interval;
};

/// A point of the curve of sizes: the shares of the blocks, and of their volume, that are at most this large.
struct BlockSize {
  double volume = 0;  ///< m3
  double of_blocks = 0, of_volume = 0;
};

/// The blocks of the first trial, for a picture; no corners where they are too many for one.
struct FirstBlocks {
  std::vector<BlockRow> blocks;
  std::vector<BlockCorner> corners;
};

struct BlockSummary {
  std::uint64_t trials = 0;                     ///< with blocks
  std::array<MeanOfTrials, 4> count, volume;    ///< a trial; indexed by BlockPart; m3
  double region_volume = 0;                     ///< m3 a trial
  double joints = 0, joint_area = 0;            ///< a trial; m2 a m3
  double joint_count = 0;                       ///< Jv [1/m]
  double left_out = 0, left_out_volume = 0;     ///< blocks below `least_volume`, a trial; m3
  double mean_volume = 0, weighted_volume = 0;  ///< m3; sum V / n, sum V^2 / sum V
  FirstBlocks first;
  std::vector<BlockSize> sizes;  ///< ascending
};

/// Summarises the rows of the tables `blocks` and `block_regions` in one pass, in the order of the trials.
class BlockTally {
 public:
  void add(const TrialRecords& chunk);
  bool empty() const { return regions_ == 0; }
  BlockSummary summary() const;

 private:
  struct Sums {
    double sum = 0, squares = 0;
    void add(double x) {
      sum += x;
      squares += x * x;
    }
  };
  void keep_first(const TrialRecords& chunk);
  static MeanOfTrials mean_of(const Sums& sums, std::uint64_t trials);

  std::uint64_t trials_ = 0, regions_ = 0, blocks_ = 0, trial_ = 0;
  std::array<Sums, 4> counts_, volumes_;
  BlockRegionRow regions_sum_;
  FirstBlocks first_;
  Sums volume_of_blocks_;
  CodeCounts sizes_, volume_by_size_;
};

/// The blocks of the first trial in a line, for `flyrock check`; empty where joints cut none. Throws
/// ScenarioError if the trial cannot be built.
std::string blocks_of_first_trial(const Scenario& scenario);

}  // namespace flyrock
