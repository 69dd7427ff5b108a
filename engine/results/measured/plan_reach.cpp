#include "results/measured/plan_reach.h"

#include <algorithm>

namespace flyrock {

void PlanReach::add(const TrialRecords& chunk) {
  for (const RockRecord& rock : chunk.rocks) {
    if (is_fault(rock.reason)) continue;
    const Vec2 release(rock.start_x, rock.start_y), end(rock.stop_x, rock.stop_y);
    if (count_++ == 0) first_ = release;
    releases_ += release - first_;  // from a place nearby, because national coordinates lose digits in a sum
    ends_ += end - first_;
    box_.extend(Vec3(release.x(), release.y(), rock.stop_z));
    box_.extend(Vec3(end.x(), end.y(), rock.stop_z));
  }
  for (const TrajectoryRecord& row : chunk.trajectories)
    if (count_ > 0) box_.extend(row.point.state.position);
}

Eigen::AlignedBox2d PlanReach::window() const {
  if (empty()) return {};
  constexpr double share = 0.1, least = 0.01;  // m, for a body that does not move
  const Vec2 margin = Vec2::Constant(std::max(share * box_.sizes().maxCoeff(), least));
  return {box_.min().head<2>() - margin, box_.max().head<2>() + margin};
}

PlanReach::Line PlanReach::mean_line() const {
  const auto n = static_cast<double>(std::max<std::uint64_t>(count_, 1));
  Line line{first_ + releases_ / n, (ends_ - releases_) / n, 0, 0};
  const Eigen::AlignedBox2d box = window();
  const double length = line.direction.norm();
  line.direction = length > 1e-6 * box.diagonal().norm() ? Vec2(line.direction / length) : Vec2::UnitX();
  for (const auto corner : {Eigen::AlignedBox2d::BottomLeft, Eigen::AlignedBox2d::BottomRight,
                            Eigen::AlignedBox2d::TopLeft, Eigen::AlignedBox2d::TopRight}) {
    const double along = (box.corner(corner) - line.release).dot(line.direction);
    line.from = std::min(line.from, along);
    line.to = std::max(line.to, along);
  }
  return line;
}

}  // namespace flyrock
