#include "geometry/mesh_ground.h"

#include <algorithm>

#include "geometry/mesh_edges.h"

namespace flyrock {

namespace {

constexpr std::uint32_t leaf_size = 4;

/// Whether a segment in plan meets a box in plan.
class PlanSegment {
 public:
  PlanSegment(const Vec2& a, const Vec2& b)
      : a_(a), low_(a.cwiseMin(b)), high_(a.cwiseMax(b)), across_(perpendicular(b - a)) {}

  bool operator()(const Box3& box) const {
    if ((low_.array() > box.high.head<2>().array()).any() ||
        (high_.array() < box.low.head<2>().array()).any())
      return false;
    const Vec2 centre = 0.5 * (box.low + box.high).head<2>(), half = 0.5 * (box.high - box.low).head<2>();
    return std::abs(across_.dot(centre - a_)) <= across_.cwiseAbs().dot(half) * (1 + 1e-12) + 1e-300;
  }

 private:
  Vec2 a_, low_, high_, across_;
};

/// The edges of two triangles count twice.
double median_edge(const Mesh& mesh) {
  std::vector<double> lengths;
  lengths.reserve(3 * mesh.triangles.size());
  for (const auto& triangle : mesh.triangles)
    for (int i = 0; i < 3; ++i)
      lengths.push_back((mesh.vertices[triangle[Facet::next(i)]] - mesh.vertices[triangle[i]]).norm());
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

}  // namespace

MeshGround::MeshGround(Mesh mesh) : Ground3(mesh.parts), mesh_(std::move(mesh)) {
  measure();
  find_neighbours();
  find_peaks();
  order_.resize(mesh_.triangles.size());
  for (std::uint32_t i = 0; i < order_.size(); ++i) order_[i] = i;
  split(0, static_cast<std::uint32_t>(order_.size()));
  for (const std::uint32_t triangle : order_) boxes_.push_back(box_of(triangle));
}

void MeshGround::measure() {
  extent_ = Box3::around(mesh_.vertices);
  double in_plan = 0;  // area; facets that face down count negative
  for (const auto& [a, b, c] : mesh_.triangles) {
    const Vec3& start = mesh_.vertices[a];
    const Vec3 twice_area = (mesh_.vertices[b] - start).cross(mesh_.vertices[c] - start);
    normal_.push_back(twice_area.normalized());
    in_plan += 0.5 * twice_area.z();
    overhangs_ = overhangs_ || twice_area.z() < 0;
  }
  cell_ = median_edge(mesh_);
  const Vec3 size = extent_.size();
  whole_ = in_plan >= (1 - 1e-9) * size.x() * size.y();
}

/// Sorts the rims by their two vertices. Two rims with the same vertices are one edge.
void MeshGround::find_neighbours() {
  const std::vector<MeshSide> sides = sorted_sides(mesh_.triangles);
  const double noise =
      8e-16 * std::max(extent_.low.cwiseAbs().maxCoeff(), extent_.high.cwiseAbs().maxCoeff());
  around_.resize(mesh_.triangles.size());
  for (const MeshSide& s : sides) around_[s.triangle].edge[s.side] = 3 * std::uint64_t(s.triangle) + s.side;
  for (std::size_t k = 0; k + 1 < sides.size(); ++k) {
    const MeshSide &a = sides[k], &b = sides[k + 1];
    if (!a.same_edge(b)) continue;
    const auto corner = [&](const MeshSide& s, int i) {
      return mesh_.vertices[mesh_.triangles[s.triangle][i % 3]];
    };
    const Rim rim = rim_between(normal_[a.triangle], corner(a, a.side + 2), normal_[b.triangle],
                                corner(b, b.side + 2), corner(a, a.side), noise);
    around_[a.triangle].facet[a.side] = b.triangle;
    around_[b.triangle].facet[b.side] = a.triangle;
    around_[a.triangle].rim[a.side] = around_[b.triangle].rim[b.side] = rim;
    around_[b.triangle].edge[b.side] = around_[a.triangle].edge[a.side];
  }
}

void MeshGround::find_peaks() {
  std::vector<int> convex(mesh_.vertices.size(), 0);  // convex rims, each counted from both facets
  std::vector<bool> border(mesh_.vertices.size(), false);
  for (std::size_t f = 0; f < mesh_.triangles.size(); ++f)
    for (int i = 0; i < 3; ++i)
      for (const int end : {i, Facet::next(i)}) {
        convex[mesh_.triangles[f][end]] += around_[f].rim[i] == Rim::convex;
        if (around_[f].rim[i] == Rim::open) border[mesh_.triangles[f][end]] = true;
      }
  const auto is_peak = [&](int v) { return convex[v] >= 6 && !border[v]; };
  fan_start_.assign(mesh_.vertices.size() + 1, 0);
  for (const auto& triangle : mesh_.triangles)
    for (const int v : triangle) fan_start_[v + 1] += is_peak(v);
  for (std::size_t v = 0; v < mesh_.vertices.size(); ++v) fan_start_[v + 1] += fan_start_[v];
  fan_.resize(fan_start_.back());
  std::vector<std::uint32_t> next(fan_start_.begin(), fan_start_.end() - 1);
  for (std::uint32_t f = 0; f < mesh_.triangles.size(); ++f)
    for (const int v : mesh_.triangles[f])
      if (is_peak(v)) fan_[next[v]++] = f;
}

Box3 MeshGround::box_of(std::uint32_t triangle) const {
  const auto& [a, b, c] = mesh_.triangles[triangle];
  const Vec3 &p = mesh_.vertices[a], &q = mesh_.vertices[b], &r = mesh_.vertices[c];
  return {p.cwiseMin(q).cwiseMin(r), p.cwiseMax(q).cwiseMax(r)};
}

void MeshGround::split(std::uint32_t first, std::uint32_t count) {
  const std::size_t node = nodes_.size();
  nodes_.emplace_back();
  Box3 box = box_of(order_[first]);
  const auto twice_centre = [&](std::uint32_t triangle) -> Vec3 {
    const Box3 b = box_of(triangle);
    return b.low + b.high;
  };
  Box3 centres{twice_centre(order_[first]), twice_centre(order_[first])};
  for (std::uint32_t i = first; i < first + count; ++i) {
    const Box3 b = box_of(order_[i]);
    box.add(b);
    centres.add(b.low + b.high);
  }
  if (count <= leaf_size) {
    nodes_[node].first = first;
    nodes_[node].count = count;
  } else {
    int axis = 0;
    centres.size().maxCoeff(&axis);
    const std::uint32_t half = count / 2;
    std::nth_element(order_.begin() + first, order_.begin() + first + half, order_.begin() + first + count,
                     [&](std::uint32_t a, std::uint32_t b) {
                       return std::pair(twice_centre(a)[axis], a) < std::pair(twice_centre(b)[axis], b);
                     });
    split(first, half);
    split(first + half, count - half);
  }
  nodes_[node].box = box;
  nodes_[node].end = static_cast<std::uint32_t>(nodes_.size());
}

template <class Meets>
const std::vector<std::uint32_t>& MeshGround::collect(const Meets& meets, std::size_t limit) const {
  thread_local std::vector<std::uint32_t> found;  // keeps its memory between queries
  found.clear();
  for (std::uint32_t i = 0; i < nodes_.size() && found.size() < limit;) {
    const Node& node = nodes_[i];
    if (!meets(node.box)) {
      i = node.end;
      continue;
    }
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k)
      if (meets(boxes_[k])) found.push_back(order_[k]);
    ++i;
  }
  std::sort(found.begin(), found.end());
  return found;
}

void MeshGround::facets(const Box3& box, std::vector<Facet>& out) const {
  for (const std::uint32_t id : collect([&](const Box3& b) { return b.overlaps(box); }, order_.size()))
    out.push_back(facet(id));
}

void MeshGround::triangles(const Box3& box, std::vector<Facet>& out) const {
  for (const std::uint32_t id : collect([&](const Box3& b) { return b.overlaps(box); }, order_.size()))
    out.push_back(triangle(id));
}

int MeshGround::count(const Box3& box, int limit) const {
  const std::size_t most = static_cast<std::size_t>(limit);
  return static_cast<int>(
      std::min(most, collect([&](const Box3& b) { return b.overlaps(box); }, most).size()));
}

void MeshGround::triangles_under(const Vec2& a, const Vec2& b, std::vector<Facet>& out) const {
  for (const std::uint32_t id : collect(PlanSegment(a, b), order_.size())) out.push_back(triangle(id));
}

Facet MeshGround::triangle(std::uint32_t id) const {
  Facet facet;
  facet.id = id;
  facet.normal = normal_[id];
  for (int i = 0; i < 3; ++i) {
    facet.vertex[i] = static_cast<std::uint64_t>(mesh_.triangles[id][i]);
    facet.corner[i] = mesh_.vertices[facet.vertex[i]];
  }
  return facet;
}

Facet MeshGround::facet(std::uint32_t id) const {
  Facet facet = triangle(id);
  facet.rim = around_[id].rim;
  facet.edge = around_[id].edge;
  for (int i = 0; i < 3; ++i) {
    if (facet.rim[i] == Rim::convex) facet.beyond[i] = normal_[around_[id].facet[i]];
  }
  return facet;
}

/// Only peaks are features; any other vertex has no fan, and its facet is not asked for.
std::uint32_t MeshGround::facet_at(std::uint64_t vertex) const {
  return fan_start_[vertex] < fan_start_[vertex + 1] ? fan_[fan_start_[vertex]] : 0;
}

bool MeshGround::peak(std::uint64_t vertex, std::vector<Vec3>& edges) const {
  for (std::uint32_t k = fan_start_[vertex]; k < fan_start_[vertex + 1]; ++k) {
    const auto& triangle = mesh_.triangles[fan_[k]];
    for (int i = 0; i < 3; ++i)
      if (static_cast<std::uint64_t>(triangle[i]) == vertex)
        edges.push_back(mesh_.vertices[triangle[Facet::next(i)]] - mesh_.vertices[vertex]);
  }
  return fan_start_[vertex] < fan_start_[vertex + 1];
}

}  // namespace flyrock
