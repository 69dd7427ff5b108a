#include "geometry/ground.h"

#include <algorithm>
#include <cmath>

#include "geometry/grid_ground.h"
#include "geometry/mesh_ground.h"

namespace flyrock {

namespace {

/// A plane: one facet without rims.
class PlaneGround final : public Ground3 {
 public:
  explicit PlaneGround(const Plane& plane) : Ground3(plane.parts) {
    facet_.unbounded = true;
    facet_.corner.fill(plane.point);
    facet_.normal = plane.normal;
  }

  void facets(const Box3&, std::vector<Facet>& out) const override { out.push_back(facet_); }
  void triangles(const Box3&, std::vector<Facet>& out) const override { out.push_back(facet_); }
  int count(const Box3&, int) const override { return 1; }
  void triangles_under(const Vec2&, const Vec2&, std::vector<Facet>& out) const override {
    out.push_back(facet_);
  }
  Facet facet(std::uint32_t) const override { return facet_; }
  Vec3 vertex(std::uint64_t) const override { return facet_.corner[0]; }
  bool peak(std::uint64_t, std::vector<Vec3>&) const override { return false; }
  std::uint32_t facet_at(std::uint64_t) const override { return 0; }
  int part(std::uint32_t) const override { return 0; }
  const Box3& extent() const override { return extent_; }

 private:
  Facet facet_;
  Box3 extent_{Vec3::Constant(-infinite), Vec3::Constant(infinite)};
};

/// On which side of the line from a to b the point lies, in plan. Two facets give exactly opposite answers
/// for their common edge, because the order of its vertices decides how it is computed. No place falls
/// between them.
double side(const Facet& f, int i, const Vec2& p) {
  const int j = Facet::next(i);
  const bool swapped = f.vertex[i] > f.vertex[j];
  const Vec2 a = f.corner[swapped ? j : i].head<2>(), b = f.corner[swapped ? i : j].head<2>();
  const double left = cross(b - a, p - a);
  return swapped ? -left : left;
}

/// Where the vertical line through p meets a facet.
std::optional<double> height_on(const Facet& f, const Vec2& p) {
  if (!f.unbounded) {
    const double a = side(f, 0, p), b = side(f, 1, p), c = side(f, 2, p);
    const bool over = (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
    if (!over) return std::nullopt;
  }
  if (f.normal.z() == 0) return std::nullopt;  // upright; its upper end belongs to a neighbour
  const Vec2 away = p - f.corner[0].head<2>();
  const double z = f.corner[0].z() - (f.normal.x() * away.x() + f.normal.y() * away.y()) / f.normal.z();
  if (f.unbounded) return z;
  const auto [low, high] = std::minmax({f.corner[0].z(), f.corner[1].z(), f.corner[2].z()});
  return std::clamp(z, low, high);
}

}  // namespace

Rim rim_between(const Vec3& normal, const Vec3& own_corner, const Vec3& other_normal,
                const Vec3& other_corner, const Vec3& on_edge, double noise) {
  constexpr double flat_angle = 1e-9;
  const double other_side = normal.dot(other_corner - on_edge),
               own_side = other_normal.dot(own_corner - on_edge);
  const bool flat = std::abs(other_side) <= flat_angle * (other_corner - on_edge).norm() + noise ||
                    std::abs(own_side) <= flat_angle * (own_corner - on_edge).norm() + noise;
  if (flat && normal.dot(other_normal) > 0) return Rim::flat;
  return other_side < 0 ? Rim::convex : Rim::concave;
}

std::uint32_t Ground3::facet_of(FeatureId feature) const {
  const std::uint64_t index = ground_index(feature);
  switch (kind_of(feature)) {
    case FeatureKind::vertex:
      return facet_at(index);
    case FeatureKind::edge:
      return static_cast<std::uint32_t>(index / 3);
    case FeatureKind::face:
      break;
  }
  return static_cast<std::uint32_t>(index);
}

Vec3 nearest_on(const Facet& f, const Vec3& p) {
  Vec3 nearest = p - f.distance(p) * f.normal;
  double least = -1;  // squared distance to a rim; -1: over the facet
  for (int i = 0; i < 3; ++i) {
    if (f.rim[i] == Rim::open || f.inside(i, p) >= 0) continue;
    const Vec3 along = f.along(i);
    const double share = std::clamp((p - f.corner[i]).dot(along) / along.squaredNorm(), 0.0, 1.0);
    const Vec3 place = f.corner[i] + share * along;
    if (const double distance = (place - p).squaredNorm(); least < 0 || distance < least)
      least = distance, nearest = place;
  }
  return nearest;
}

std::optional<Ground3::Nearest> Ground3::nearest(const Vec3& at, double reach) const {
  thread_local std::vector<Facet> around;  // keeps its memory between queries
  around.clear();
  facets({at - Vec3::Constant(reach), at + Vec3::Constant(reach)}, around);
  std::optional<Nearest> nearest;
  for (const Facet& f : around) {
    const double distance = (nearest_on(f, at) - at).norm();
    if (distance <= reach && (!nearest || distance < nearest->distance)) nearest = Nearest{distance, f.id};
  }
  return nearest;
}

std::optional<Ground3::Crossing> Ground3::crossing(const Vec3& at, bool above) const {
  thread_local std::vector<Facet> under;  // keeps its memory between queries
  under.clear();
  triangles_under(at.head<2>(), at.head<2>(), under);
  std::optional<Crossing> found;
  for (const Facet& facet : under) {
    const std::optional<double> z = height_on(facet, at.head<2>());
    if (!z || (above ? *z < at.z() : *z > at.z())) continue;
    if (!found || (above ? *z < found->z : *z > found->z))
      found = Crossing{*z, facet.normal.z() > 0, facet.id};
  }
  return found;
}

std::optional<Ground3::Crossing> Ground3::top(double x, double y) const {
  return crossing(Vec3(x, y, infinite), false);
}

std::optional<double> Ground3::height(double x, double y) const {
  const auto found = top(x, y);
  return found ? std::optional(found->z) : std::nullopt;
}

double Ground3::depth(const Vec3& at) const {
  const auto over = crossing(at, true);
  return over && over->upward ? over->z - at.z() : 0;
}

std::unique_ptr<const Ground3> make_ground(TerrainShape3 shape) {
  if (auto* mesh = std::get_if<Mesh>(&shape)) return std::make_unique<MeshGround>(std::move(*mesh));
  if (auto* grid = std::get_if<HeightGrid>(&shape)) return std::make_unique<GridGround>(std::move(*grid));
  return std::make_unique<PlaneGround>(std::get<Plane>(shape));
}

}  // namespace flyrock
