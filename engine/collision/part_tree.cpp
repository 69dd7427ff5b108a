#include "collision/part_tree.h"

#include <algorithm>
#include <numeric>
#include <span>

#include "geometry/ground.h"

namespace flyrock {

namespace {

constexpr double rounding = 1e-9;  // share by which a ball is larger than its content

/// The middle of the box of the points and circles, and the distance of the farthest place from it.
template <int D>
typename PartTree<D>::Ball ball_about(const typename Geometry<D>::Contactor& contactor) {
  if (is_hollow(contactor.form)) return {Vec<D>::Zero(), contactor.bound};
  std::vector<std::pair<Vec<D>, double>> balls;
  for (const Vec<D>& point : contactor.points) balls.emplace_back(point, 0);
  if constexpr (D == 3)
    for (const Contactor3::Circle& circle : contactor.circles)
      balls.emplace_back(circle.centre, circle.radius);
  Box<D> box{balls.front().first, balls.front().first};
  for (const auto& [centre, radius] : balls) box.add(centre);
  typename PartTree<D>::Ball about{0.5 * (box.low + box.high), 0};
  for (const auto& [centre, radius] : balls)
    about.radius = std::max(about.radius, (centre - about.centre).norm() + radius);
  about.radius = (about.radius + contactor.radius) * (1 + rounding);
  return about;
}

template <int D>
typename PartTree<D>::Ball ball_about(const typename PartTree<D>::Ball& a,
                                      const typename PartTree<D>::Ball& b) {
  const Vec<D> between = b.centre - a.centre;
  const double distance = between.norm();
  if (distance + b.radius <= a.radius) return a;
  if (distance + a.radius <= b.radius) return b;
  const double radius = 0.5 * (distance + a.radius + b.radius);
  return {a.centre + (radius - a.radius) / distance * between, radius * (1 + rounding)};
}

bool may_touch(Workspace&, const Vec2& centre, double reach, const Ground2& ground) {
  const auto run = ground.segments_between(centre.x() - reach, centre.x() + reach);
  for (int i = run.first; i <= run.last; ++i)
    if (ground.normal(i).dot(centre - ground.start(i)) <= reach) return true;
  return false;
}

bool may_touch(Workspace& work, const Vec3& centre, double reach, const Ground3& ground) {
  std::vector<Facet>& facets = work.facets;
  facets.clear();
  ground.facets({(centre.array() - reach).matrix(), (centre.array() + reach).matrix()}, facets);
  return std::any_of(facets.begin(), facets.end(),
                     [&](const Facet& f) { return f.distance(centre) <= reach; });
}

}  // namespace

template <int D>
PartTree<D>::PartTree(const std::vector<typename Geometry<D>::Contactor>& parts) {
  std::vector<Ball> balls;
  for (const auto& part : parts) balls.push_back(ball_about<D>(part));
  std::vector<int> order(parts.size());
  std::iota(order.begin(), order.end(), 0);
  // Halves the parts at the middle of their longest side.
  const auto build = [&](const auto& self, std::span<int> some) -> void {
    const std::size_t here = nodes_.size();
    nodes_.emplace_back();
    if (some.size() == 1) {
      nodes_[here] = {balls[some[0]], some[0], 0};
      return;
    }
    Box<D> box{balls[some[0]].centre, balls[some[0]].centre};
    for (const int i : some) box.add(balls[i].centre);
    int longest = 0;
    box.size().maxCoeff(&longest);
    std::sort(some.begin(), some.end(), [&](int i, int j) {
      return std::pair(balls[i].centre[longest], i) < std::pair(balls[j].centre[longest], j);
    });
    self(self, some.first(some.size() / 2));
    const int second = static_cast<int>(nodes_.size());
    self(self, some.subspan(some.size() / 2));
    nodes_[here] = {ball_about<D>(nodes_[here + 1].ball, nodes_[second].ball), -1, second};
  };
  if (!parts.empty()) build(build, order);
}

template <int D>
void near_parts(Workspace& work, const PartTree<D>& body, const typename Geometry<D>::Pose& pose,
                const typename Geometry<D>::Terrain& ground, double reach, std::vector<int>& found) {
  found.clear();
  if (body.parts() <= few_parts) {
    for (int k = 0; k < body.parts(); ++k) found.push_back(k);
    return;
  }
  const auto search = [&](const auto& self, int at) -> void {
    const auto& node = body[at];
    if (!may_touch(work, pose * node.ball.centre, node.ball.radius + reach, ground)) return;
    if (node.is_leaf()) {
      found.push_back(node.part);
      return;
    }
    self(self, at + 1);
    self(self, node.second);
  };
  search(search, 0);
  std::sort(found.begin(), found.end());
}

template <int D>
void near_parts(Workspace&, const PartTree<D>& a, const typename Geometry<D>::Pose& pose_a,
                const PartTree<D>& b, const typename Geometry<D>::Pose& pose_b, double reach,
                std::vector<std::pair<int, int>>& found) {
  found.clear();
  if (a.parts() <= few_parts && b.parts() <= few_parts) {
    for (int k = 0; k < a.parts(); ++k)
      for (int l = 0; l < b.parts(); ++l) found.emplace_back(k, l);
    return;
  }
  // The larger ball is divided, so that both stay of about one size.
  const auto search = [&](const auto& self, int at_a, int at_b) -> void {
    const auto &of_a = a[at_a], &of_b = b[at_b];
    const double near = of_a.ball.radius + of_b.ball.radius + reach;
    if ((pose_a * of_a.ball.centre - pose_b * of_b.ball.centre).norm() > near) return;
    if (of_a.is_leaf() && of_b.is_leaf()) {
      found.emplace_back(of_a.part, of_b.part);
    } else if (of_b.is_leaf() || (!of_a.is_leaf() && of_a.ball.radius >= of_b.ball.radius)) {
      self(self, at_a + 1, at_b);
      self(self, of_a.second, at_b);
    } else {
      self(self, at_a, at_b + 1);
      self(self, at_a, of_b.second);
    }
  };
  search(search, 0, 0);
  std::sort(found.begin(), found.end());
}

#define FLYROCK_INSTANTIATE(D)                                                                           \
  template class PartTree<D>;                                                                            \
  template void near_parts(Workspace&, const PartTree<D>&, const Geometry<D>::Pose&,                     \
                           const Geometry<D>::Terrain&, double, std::vector<int>&);                      \
  template void near_parts(Workspace&, const PartTree<D>&, const Geometry<D>::Pose&, const PartTree<D>&, \
                           const Geometry<D>::Pose&, double, std::vector<std::pair<int, int>>&)
FLYROCK_INSTANTIATE(2);
FLYROCK_INSTANTIATE(3);
#undef FLYROCK_INSTANTIATE

}  // namespace flyrock
