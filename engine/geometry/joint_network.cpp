#include "geometry/joint_network.h"

#include <algorithm>
#include <cmath>

#include "geometry/directions.h"
#include "geometry/disc_overlap.h"
#include "geometry/plan_zone.h"
#include "random/spacings.h"

namespace flyrock {

namespace {

/// A ball about the corners of a region: its centre and radius.
template <int D>
std::pair<Vec<D>, double> ball_about(const std::vector<Vec<D>>& corners) {
  Vec<D> low = corners.front(), high = corners.front();
  for (const Vec<D>& p : corners) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vec<D> centre = 0.5 * (low + high);
  double radius = 0;
  for (const Vec<D>& p : corners) radius = std::max(radius, (p - centre).norm());
  return {centre, radius};
}

template <int D>
Vec<D> normal_of(const JointSet<D>& set, RandomStream& rng) {
  return set.fisher_k > 0 ? fisher_direction(set.normal, set.fisher_k, rng) : set.normal;
}

/// The range of normal . (x - origin) over the region.
template <int D>
std::pair<double, double> reach_of(const JointSet<D>& set, const std::vector<Vec<D>>& corners,
                                   const Vec<D>& origin) {
  double low = infinite, high = -infinite, farthest = 0;
  for (const Vec<D>& p : corners) {
    const double at = set.normal.dot(p - origin);
    low = std::min(low, at);
    high = std::max(high, at);
    farthest = std::max(farthest, (p - origin).norm());
  }
  // With scatter a plane of any d up to the farthest corner may meet the region.
  return set.fisher_k > 0 ? std::pair(-farthest, farthest) : std::pair(low, high);
}

template <int D>
std::vector<Joint<D>> draw_planes(const JointSet<D>& set, int index, const std::vector<Vec<D>>& corners,
                                  RandomStream& rng) {
  const Vec<D> origin = set.origin ? *set.origin : ball_about<D>(corners).first;
  const auto [low, high] = reach_of<D>(set, corners, origin);
  const std::optional<double> first = set.origin ? std::optional(0.0) : std::nullopt;
  std::vector<Joint<D>> joints;
  for (const double d : places_with_spacing(*set.spacing, first, low, high, rng)) {
    const Vec<D> normal = normal_of(set, rng);
    joints.push_back(
        {.set = index, .normal = normal, .offset = normal.dot(origin) + d, .persistence = set.persistence});
  }
  return joints;
}

/// The measure of a disc: its area, in 2D the length of a segment.
template <int D>
double disc_size(double radius) {
  return D == 2 ? 2 * radius : pi * radius * radius;
}

/// Radii with a probability in proportion to the size of a disc whose radius is greater by `more`.
template <int D>
class RadiiBySize {
 public:
  RadiiBySize(const Distribution& law, double more) : law_(law) {
    for (int i = 0; i < steps; ++i) {
      const double radius = law.quantile((i + 0.5) / steps);
      mean_size_ += disc_size<D>(radius) / steps;
      mean_reached_ += disc_size<D>(radius + more) / steps;
      sums_.push_back(mean_reached_);
    }
  }
  double mean_size() const { return mean_size_; }
  double mean_reached() const { return mean_reached_; }
  double draw(RandomStream& rng) const {
    const auto bin = std::lower_bound(sums_.begin(), sums_.end(), rng.uniform() * sums_.back());
    const auto i = std::min<std::ptrdiff_t>(bin - sums_.begin(), steps - 1);
    return law_.quantile((static_cast<double>(i) + rng.uniform()) / steps);
  }

 private:
  static constexpr int steps = 4096;
  const Distribution& law_;
  double mean_size_ = 0, mean_reached_ = 0;
  std::vector<double> sums_;
};

/// The discs that may meet the ball about the region: at a distance along their normal of at most its radius,
/// and across it of at most its radius and their own.
template <int D>
std::vector<Joint<D>> draw_discs(const JointSet<D>& set, int index, const std::vector<Vec<D>>& corners,
                                 RandomStream& rng) {
  const auto [origin, reach] = ball_about<D>(corners);
  const RadiiBySize<D> radii(*set.radius, reach);
  Distribution gap;
  gap.kind = DistributionKind::exponential;
  gap.a = mean_of(*set.spacing) * radii.mean_size() / radii.mean_reached();
  std::vector<Joint<D>> joints;
  for (const double d : places_with_spacing(gap, std::nullopt, -reach, reach, rng)) {
    Joint<D> joint{.set = index, .normal = normal_of(set, rng), .persistence = set.persistence};
    joint.radius = radii.draw(rng);
    joint.offset = joint.normal.dot(origin) + d;
    const auto frame = contact_frame(joint.normal);
    joint.centre = origin + d * joint.normal;
    if constexpr (D == 2) {
      joint.centre += (2 * rng.uniform() - 1) * (reach + joint.radius) * frame.col(1);
    } else {
      const double out = (reach + joint.radius) * std::sqrt(rng.uniform()), around = 2 * pi * rng.uniform();
      joint.centre += out * (std::cos(around) * frame.col(1) + std::sin(around) * frame.col(2));
    }
    joints.push_back(joint);
  }
  std::stable_sort(joints.begin(), joints.end(),
                   [](const Joint<D>& a, const Joint<D>& b) { return a.radius > b.radius; });
  return joints;
}

/// Whether a disc cuts the block that has this section with its plane.
bool covers(const Joint<3>& joint, const CutBlocks<3>::Section& section) {
  const Eigen::Matrix3d frame = contact_frame(joint.normal);
  std::vector<Vec2> polygon;  // along s and t, because s x t = n
  double doubled = 0;
  for (const Vec3& p : section) {
    const Vec3 from_centre = p - joint.centre;
    polygon.emplace_back(frame.col(2).dot(from_centre), frame.col(1).dot(from_centre));
  }
  for (std::size_t i = 0; i < polygon.size(); ++i)
    doubled += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return is_inside(polygon, Vec2::Zero()) ||
         disc_overlap(polygon, Vec2::Zero(), joint.radius) > 0.25 * doubled;
}

bool covers(const Joint<2>& joint, const CutBlocks<2>::Section& section) {
  const Vec2 along = contact_frame(joint.normal).col(1);
  double low = along.dot(section[0] - joint.centre), high = along.dot(section[1] - joint.centre);
  if (low > high) std::swap(low, high);
  const double covered = std::min(high, joint.radius) - std::max(low, -joint.radius);
  return (low <= 0 && high >= 0) || covered > 0.5 * (high - low);
}

}  // namespace

template <int D>
std::vector<Joint<D>> draw_joints(const JointSet<D>& set, int index, const std::vector<Vec<D>>& corners,
                                  RandomStream& rng) {
  return set.radius ? draw_discs<D>(set, index, corners, rng) : draw_planes<D>(set, index, corners, rng);
}

template <int D>
int cut_by(CutBlocks<D>& blocks, const Joint<D>& joint, int index, RandomStream& rng) {
  if (joint.radius < infinite)
    return blocks.cut(joint.normal, joint.offset, index,
                      [&](const auto& section) { return covers(joint, section); });
  if (joint.persistence < 1)
    return blocks.cut(joint.normal, joint.offset, index,
                      [&](const auto&) { return rng.uniform() < joint.persistence; });
  return blocks.cut(joint.normal, joint.offset, index);
}

#define FLYROCK_INSTANTIATE(D)                                                                       \
  template std::vector<Joint<D>> draw_joints<D>(const JointSet<D>&, int, const std::vector<Vec<D>>&, \
                                                RandomStream&);                                      \
  template int cut_by<D>(CutBlocks<D>&, const Joint<D>&, int, RandomStream&)
FLYROCK_INSTANTIATE(2);
FLYROCK_INSTANTIATE(3);
#undef FLYROCK_INSTANTIATE

}  // namespace flyrock
