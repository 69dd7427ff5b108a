// Skirts: upright strips that hang below the edges of tiles, as programs for maps add them to close gaps in
// pictures.

#include <fmt/format.h>

#include <numeric>

#include "survey/mesh_draft.h"

namespace flyrock {

namespace {

/// Upright triangles that hang together by edges of their own.
class Strips {
 public:
  explicit Strips(std::vector<bool> upright) : upright_(std::move(upright)), root_(upright_.size()) {
    std::iota(root_.begin(), root_.end(), 0);
    hangs_wrong_.assign(upright_.size(), false);
    holds_ = hangs_wrong_;
  }

  bool is_upright(int t) const { return upright_[t]; }
  void join(int a, int b) { root_[root(a)] = root(b); }
  void set_hangs_wrong(int t) { hangs_wrong_[root(t)] = true; }
  void set_holds(int t) { holds_[root(t)] = true; }
  bool is_skirt(int t) { return upright_[t] && hangs_wrong_[root(t)] && !holds_[root(t)]; }

 private:
  int root(int t) {
    while (root_[t] != t) t = root_[t] = root_[root_[t]];
    return t;
  }

  std::vector<bool> upright_;
  std::vector<int> root_;
  std::vector<bool> hangs_wrong_;  ///< from a faulty edge
  std::vector<bool> holds_;        ///< has a low edge that the rest meets: it is a face
};

}  // namespace

void MeshDraft::drop_skirts() {
  const std::vector<MeshSide> sides = sorted_sides(mesh_.triangles);
  Strips strips(upright_triangles());
  for_edges(sides, [&](std::size_t begin, std::size_t end) {
    if (end - begin == 2 && strips.is_upright(sides[begin].triangle) &&
        strips.is_upright(sides[begin + 1].triangle))
      strips.join(sides[begin].triangle, sides[begin + 1].triangle);
  });
  for_edges(sides, [&](std::size_t begin, std::size_t end) {
    std::size_t others = 0;
    for (std::size_t i = begin; i < end; ++i) others += !strips.is_upright(sides[i].triangle);
    if (others == 0) return;
    const bool is_faulty =
        end - begin > 2 || (end - begin == 2 && sides[begin].forward == sides[begin + 1].forward);
    for (std::size_t i = begin; i < end; ++i) {
      if (!strips.is_upright(sides[i].triangle)) continue;
      if (is_faulty) strips.set_hangs_wrong(sides[i].triangle);
      if (is_below_rest(sides[i])) strips.set_holds(sides[i].triangle);
    }
  });
  std::vector<int> skirts;
  for (int t = 0; t < triangles(); ++t)
    if (strips.is_skirt(t)) skirts.push_back(t);
  if (skirts.empty()) return;
  drop(skirts, fmt::format("dropped skirts of {} that hang from the edges of tiles{}",
                           counted(skirts.size(), "triangle", "triangles"), lines_of(skirts)));
}

std::vector<bool> MeshDraft::upright_triangles() const {
  std::vector<bool> upright(mesh_.triangles.size());
  for (int t = 0; t < triangles(); ++t) {
    const Vec3 normal = twice_area(t);
    upright[t] = std::abs(normal.z()) < 1e-3 * normal.norm();
  }
  return upright;
}

bool MeshDraft::is_below_rest(const MeshSide& side) const {
  const std::array<int, 3>& corners = mesh_.triangles[side.triangle];
  const int third = corners[0] + corners[1] + corners[2] - side.low - side.high;
  return at(third).z() > std::max(at(side.low).z(), at(side.high).z());
}

}  // namespace flyrock
