#include "geometry/cut_blocks.h"

#include <algorithm>
#include <cmath>

namespace flyrock {

namespace {

constexpr double on_plane = 1e-9;  // share of the region's size

template <int D>
double diagonal_of(const std::vector<Vec<D>>& points) {
  Vec<D> low = points.front(), high = points.front();
  for (const Vec<D>& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).norm();
}

/// The edges of a face as pairs of points: in 3D its loop is closed.
template <int D>
std::size_t edges_of(const std::vector<int>& loop) {
  return D == 2 ? loop.size() - 1 : loop.size();
}

std::uint64_t key_of(int a, int b) {
  return static_cast<std::uint64_t>(std::min(a, b)) << 32 | static_cast<std::uint64_t>(std::max(a, b));
}

/// The face that closes a half: the edges on the plane which its faces leave open, chained in the opposite
/// direction. Empty if they do not make one loop, because the block is thinner than the tolerance there.
template <int D>
std::vector<int> closing_loop(const std::vector<BlockFace<D>>& faces, const std::vector<signed char>& side) {
  std::vector<std::pair<int, int>> open;  // from, to
  if constexpr (D == 2) {
    int first = -1, last = -1;
    for (const BlockFace<2>& face : faces) {
      if (side[face.loop[0]] == 0) first = face.loop[0];
      if (side[face.loop[1]] == 0) last = face.loop[1];
    }
    if (first < 0 || last < 0 || first == last) return {};
    return {last, first};
  } else {
    for (const BlockFace<3>& face : faces)
      for (std::size_t i = 0; i < face.loop.size(); ++i) {
        const int p = face.loop[i], q = face.loop[(i + 1) % face.loop.size()];
        if (side[p] == 0 && side[q] == 0) open.emplace_back(q, p);
      }
    if (open.size() < 3) return {};
    std::vector<int> loop{open.front().first};
    for (int next = open.front().second; next != loop.front();) {
      const auto found =
          std::find_if(open.begin(), open.end(), [&](const auto& edge) { return edge.first == next; });
      if (found == open.end() || loop.size() == open.size()) return {};
      loop.push_back(next);
      next = found->second;
    }
    if (loop.size() != open.size()) return {};
    return loop;
  }
}

}  // namespace

template <int D>
CutBlocks<D>::CutBlocks(std::vector<Vec<D>> points, std::vector<BlockFace<D>> faces)
    : points_(std::move(points)), blocks_{{std::move(faces)}}, size_(diagonal_of<D>(points_)) {}

template <int D>
bool CutBlocks<D>::is_crossed(const Block<D>& block) const {
  bool above = false, below = false;
  for (const BlockFace<D>& face : block.faces)
    for (const int p : face.loop) {
      above = above || side_[p] > 0;
      below = below || side_[p] < 0;
    }
  return above && below;
}

/// The point where the plane cuts the edge between two points on different sides.
template <int D>
int CutBlocks<D>::crossing(int a, int b) {
  const std::uint64_t key = key_of(a, b);
  const auto [found, is_new] = crossings_.try_emplace(key, static_cast<int>(points_.size()));
  if (!is_new) return found->second;
  const int first = std::min(a, b), second = std::max(a, b);  // the same bytes from either side
  const double share = height_[first] / (height_[first] - height_[second]);
  points_.push_back(points_[first] + share * (points_[second] - points_[first]));
  height_.push_back(0);
  side_.push_back(0);
  crossed_edges_.push_back(key);
  return found->second;
}

template <int D>
void CutBlocks<D>::forget_points_from(std::size_t first) {
  for (; points_.size() > first; crossed_edges_.pop_back()) {
    crossings_.erase(crossed_edges_.back());
    points_.pop_back();
    height_.pop_back();
    side_.pop_back();
  }
}

/// Cuts one block in two. Each of its faces is divided into what is above the plane and what is below; one
/// new face closes either half.
template <int D>
bool CutBlocks<D>::split(std::size_t index, const Vec<D>& normal, int joint,
                         const std::function<bool(const Section&)>& wanted) {
  const std::size_t points_before = points_.size();
  Block<D> above, below;
  for (const BlockFace<D>& face : blocks_[index].faces) {
    BlockFace<D> up{face.joint, face.normal, {}}, down = up;
    bool rises = false, falls = false;
    const std::size_t count = face.loop.size();
    for (std::size_t i = 0; i < count; ++i) {
      const int p = face.loop[i], q = face.loop[(i + 1) % count];
      if (side_[p] >= 0) up.loop.push_back(p);
      if (side_[p] <= 0) down.loop.push_back(p);
      rises = rises || side_[p] > 0;
      falls = falls || side_[p] < 0;
      if (i < edges_of<D>(face.loop) && side_[p] * side_[q] < 0) {
        const int cut_at = crossing(p, q);
        up.loop.push_back(cut_at);
        down.loop.push_back(cut_at);
      }
    }
    if (rises) above.faces.push_back(std::move(up));
    if (falls || !rises) below.faces.push_back(std::move(down));
  }
  std::vector<int> loop = closing_loop<D>(above.faces, side_);
  const bool is_sound = !loop.empty() && above.faces.size() >= D && below.faces.size() >= D;
  std::reverse(loop.begin(), loop.end());  // the face of the lower half looks along the normal
  Section section;
  for (const int p : loop) section.push_back(points_[p]);
  if (!is_sound || (wanted && !wanted(section))) {
    forget_points_from(points_before);
    return false;
  }
  below.faces.push_back({joint, normal, loop});
  std::reverse(loop.begin(), loop.end());
  above.faces.push_back({joint, -normal, std::move(loop)});
  blocks_[index] = std::move(above);
  blocks_.push_back(std::move(below));
  return true;
}

template <int D>
int CutBlocks<D>::cut(const Vec<D>& normal, double offset, int joint,
                      const std::function<bool(const Section&)>& wanted) {
  height_.clear();
  side_.clear();
  crossings_.clear();
  crossed_edges_.clear();
  for (const Vec<D>& p : points_) {
    const double height = normal.dot(p) - offset;
    height_.push_back(height);
    side_.push_back(std::abs(height) <= on_plane * size_ ? 0 : height > 0 ? 1 : -1);
  }
  int cuts = 0;
  const std::size_t count = blocks_.size();
  for (std::size_t b = 0; b < count; ++b)
    if (is_crossed(blocks_[b]) && split(b, normal, joint, wanted)) ++cuts;
  return cuts;
}

CutBlocks<2> blocks_of(const std::vector<Vec2>& polygon) {
  std::vector<BlockFace<2>> faces;
  const int count = static_cast<int>(polygon.size());
  for (int i = 0; i < count; ++i) {
    const int next = (i + 1) % count;
    faces.push_back({-1 - i, -perpendicular(polygon[next] - polygon[i]).normalized(), {i, next}});
  }
  return {polygon, std::move(faces)};
}

CutBlocks<3> blocks_of(const Contactor3& polyhedron) {
  std::vector<BlockFace<3>> faces;
  for (const Contactor3::Face& face : polyhedron.faces) {
    BlockFace<3> one{-1 - static_cast<int>(faces.size()), face.normal, {}};
    for (int i = 0; i < face.count; ++i) one.loop.push_back(polyhedron.vertex(face, i));
    faces.push_back(std::move(one));
  }
  return {polyhedron.points, std::move(faces)};
}

template <>
Vec2 area_vector_of<2>(const std::vector<Vec2>& points, const BlockFace<2>& face) {
  return -perpendicular(points[face.loop[1]] - points[face.loop[0]]);
}

template <>
Vec3 area_vector_of<3>(const std::vector<Vec3>& points, const BlockFace<3>& face) {
  const Vec3& first = points[face.loop[0]];
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < face.loop.size(); ++i)
    sum += (points[face.loop[i]] - first).cross(points[face.loop[i + 1]] - first);
  return 0.5 * sum;
}

namespace {

/// Calls `see(volume, centroid)` for each simplex between a point of the block and its faces.
template <int D, class See>
void for_each_simplex(const std::vector<Vec<D>>& points, const Block<D>& block, const See& see) {
  const Vec<D>& apex = points[block.faces.front().loop[0]];
  for (const BlockFace<D>& face : block.faces) {
    const Vec<D> a = points[face.loop[0]] - apex;
    for (std::size_t i = 1; i + (D == 2 ? 0 : 1) < face.loop.size(); ++i) {
      const Vec<D> b = points[face.loop[i]] - apex;
      if constexpr (D == 2) {
        see(cross(a, b) / 2, Vec2(apex + (a + b) / 3));
      } else {
        const Vec3 c = points[face.loop[i + 1]] - apex;
        see(a.dot(b.cross(c)) / 6, Vec3(apex + (a + b + c) / 4));
      }
    }
  }
}

}  // namespace

template <int D>
double volume_of(const std::vector<Vec<D>>& points, const Block<D>& block) {
  double volume = 0;
  for_each_simplex<D>(points, block, [&](double v, const Vec<D>&) { volume += v; });
  return volume;
}

template <int D>
Vec<D> centroid_of(const std::vector<Vec<D>>& points, const Block<D>& block) {
  const Vec<D>& apex = points[block.faces.front().loop[0]];
  double volume = 0;
  Vec<D> moment = Vec<D>::Zero();
  for_each_simplex<D>(points, block, [&](double v, const Vec<D>& centre) {
    volume += v;
    moment += v * (centre - apex);
  });
  return apex + moment / volume;
}

#define FLYROCK_INSTANTIATE(D)                                               \
  template class CutBlocks<D>;                                               \
  template double volume_of<D>(const std::vector<Vec<D>>&, const Block<D>&); \
  template Vec<D> centroid_of<D>(const std::vector<Vec<D>>&, const Block<D>&)
FLYROCK_INSTANTIATE(2);
FLYROCK_INSTANTIATE(3);
#undef FLYROCK_INSTANTIATE

}  // namespace flyrock
