#include "results/measured/block_summary.h"

#include <fmt/format.h>

#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "results/statistics/design_effect.h"
#include "results/statistics/unknown.h"
#include "trial/build_trial.h"

namespace flyrock {

namespace {

/// Sizes to 5 %.
const CodeScale& size_scale() {
  static const CodeScale scale(1.05);
  return scale;
}

bool is_in(BlockPart part, const BlockRow& block) {
  switch (part) {
    case BlockPart::all:
      return true;
    case BlockPart::removable:
      return block.removable;
    case BlockPart::below_1:
      return block.factor < 1;
    case BlockPart::below_1_3:
      return block.factor < 1.3;
  }
  return false;
}

}  // namespace

void BlockTally::keep_first(const TrialRecords& chunk) {
  constexpr std::size_t most_corners = 40000;
  if (!first_.blocks.empty() || chunk.blocks.empty()) return;
  for (const auto& [trial, block] : chunk.blocks)
    if (trial == chunk.blocks.front().trial) first_.blocks.push_back(block);
  for (const auto& [trial, corner] : chunk.block_corners)
    if (trial == chunk.blocks.front().trial) first_.corners.push_back(corner);
  if (first_.corners.size() > most_corners) first_.corners.clear();
}

void BlockTally::add(const TrialRecords& chunk) {
  keep_first(chunk);
  for (const auto& [trial, region] : chunk.block_regions) {
    if (regions_++ == 0 || trial != trial_) {
      trial_ = trial;
      ++trials_;
    }
    regions_sum_.volume += region.volume;
    regions_sum_.left_out += region.left_out;
    regions_sum_.left_out_volume += region.left_out_volume;
    regions_sum_.joints += region.joints;
    regions_sum_.joint_area += region.joint_area;
    regions_sum_.joint_count += region.joint_count;
  }
  std::array<double, 4> count{}, volume{};
  const auto end_trial = [&] {
    for (std::size_t part = 0; part < count.size(); ++part) {
      counts_[part].add(count[part]);
      volumes_[part].add(volume[part]);
    }
    count = volume = {};
  };
  for (std::size_t i = 0; i < chunk.blocks.size(); ++i) {  // a chunk has whole trials
    const BlockRow& block = chunk.blocks[i].row;
    for (std::size_t part = 0; part < count.size(); ++part) {
      if (!is_in(static_cast<BlockPart>(part), block)) continue;
      count[part] += 1;
      volume[part] += block.volume;
    }
    ++blocks_;
    volume_of_blocks_.add(block.volume);
    const std::uint32_t code = size_scale().code(block.volume);
    add_code(sizes_, code);
    add_code(volume_by_size_, code, block.volume);
    if (i + 1 == chunk.blocks.size() || chunk.blocks[i + 1].trial != chunk.blocks[i].trial) end_trial();
  }
}

MeanOfTrials BlockTally::mean_of(const Sums& sums, std::uint64_t trials) {
  const auto n = static_cast<double>(trials);
  MeanOfTrials result{sums.sum / n, {unknown, unknown}};
  if (trials < least_trials) return result;
  const double variance = std::max(0.0, (sums.squares - sums.sum * sums.sum / n) / (n - 1));
  const double half =
      boost::math::quantile(boost::math::students_t_distribution<>(n - 1), 0.975) * std::sqrt(variance / n);
  result.interval = {result.mean - half, result.mean + half};
  return result;
}

BlockSummary BlockTally::summary() const {
  const auto n = static_cast<double>(trials_), regions = static_cast<double>(regions_);
  BlockSummary summary;
  summary.trials = trials_;
  summary.first = first_;
  for (std::size_t part = 0; part < counts_.size(); ++part) {
    summary.count[part] = mean_of(counts_[part], trials_);
    summary.volume[part] = mean_of(volumes_[part], trials_);
  }
  summary.region_volume = regions_sum_.volume / n;
  summary.joints = regions_sum_.joints / n;
  summary.joint_area = regions_sum_.joint_area / regions_sum_.volume;
  summary.joint_count = regions_sum_.joint_count / regions;
  summary.left_out = regions_sum_.left_out / n;
  summary.left_out_volume = regions_sum_.left_out_volume / n;
  summary.mean_volume = volume_of_blocks_.sum / static_cast<double>(blocks_);
  summary.weighted_volume = volume_of_blocks_.squares / volume_of_blocks_.sum;
  double blocks = 0, volume = 0;
  for (std::size_t i = 0; i < sizes_.size(); ++i) {
    blocks += sizes_[i].rocks;
    volume += volume_by_size_[i].rocks;
    summary.sizes.push_back({size_scale().value(sizes_[i].code), blocks / static_cast<double>(blocks_),
                             volume / volume_of_blocks_.sum});
  }
  return summary;
}

namespace {

template <int D>
TrialRecords first_blocks(const Scenario& scenario) {
  const Trial<D> trial = TrialBuilder<D>(scenario).build(0);
  TrialRecords records;
  for (const BlockRow& block : trial.blocks) records.blocks.push_back({0, block});
  for (const BlockRegionRow& region : trial.block_regions) records.block_regions.push_back({0, region});
  return records;
}

}  // namespace

std::string blocks_of_first_trial(const Scenario& scenario) {
  if (!scenario.rock_contacts) return {};
  BlockTally tally;
  tally.add(scenario.dimension == 2 ? first_blocks<2>(scenario) : first_blocks<3>(scenario));
  if (tally.empty()) return {};
  const BlockSummary blocks = tally.summary();
  const auto part = [&](BlockPart which) {
    const auto i = static_cast<std::size_t>(which);
    return fmt::format("{:g} ({:.3g} m3)", blocks.count[i].mean, blocks.volume[i].mean);
  };
  std::string text = fmt::format(
      "blocks of trial 0: {} from {:g} joints, Jv {:.3g} joints/m, mean {:.3g} m3, by volume {:.3g} m3; "
      "removable {}, factor below 1 {}, below 1.3 {}",
      part(BlockPart::all), blocks.joints, blocks.joint_count, blocks.mean_volume, blocks.weighted_volume,
      part(BlockPart::removable), part(BlockPart::below_1), part(BlockPart::below_1_3));
  if (blocks.left_out > 0)
    text += fmt::format("; below least_volume and left out {:g} ({:.3g} m3)", blocks.left_out,
                        blocks.left_out_volume);
  return text;
}

}  // namespace flyrock
