#pragma once
// One facet of the ground in 3D, with what is known of its neighbours, and the ids of the ground's features.

#include <array>
#include <cstdint>

#include "math/space.h"

namespace flyrock {

/// The id of a feature of a body or of the ground. 64 bits, because a raster of 10,000 x 10,000 cells has
/// 6e8 edges.
using FeatureId = std::uint64_t;

/// In 3D a feature is a vertex, an edge or a face; the ids of bodies are in collision/contact.h. A face of
/// the ground is a facet.
enum class FeatureKind : FeatureId { vertex, edge, face };
inline FeatureKind kind_of(FeatureId feature) { return static_cast<FeatureKind>(feature & 3); }

/// The id of a feature of the ground. An edge has the index 3 f + i: it is rim i of the facet f, which has
/// the lower id of its two facets.
inline FeatureId ground_id(FeatureKind kind, std::uint64_t index) {
  return index << 2 | static_cast<FeatureId>(kind);
}
inline std::uint64_t ground_index(FeatureId feature) { return feature >> 2; }

/// How the ground bends at a rim towards the neighbouring facet. At a flat rim the two facets lie in one
/// plane to 1e-9. Beyond an open rim, at the border of the ground, the facet continues; it has no neighbour
/// there.
enum class Rim : std::uint8_t { open, flat, concave, convex };

/// A triangle of the ground, which lies behind it. Rim i leads from corner i to corner i + 1.
struct Facet {
  std::uint32_t id = 0;
  bool unbounded = false;                 ///< a whole plane; its corners are one point of it
  std::array<Vec3, 3> corner;             ///< counter-clockwise as seen from outside [m]
  Vec3 normal = Vec3::UnitZ();            ///< unit, out of the ground
  std::array<Rim, 3> rim{};               ///< open by default
  std::array<Vec3, 3> beyond;             ///< normal of the neighbour at a convex rim
  std::array<std::uint64_t, 3> edge{};    ///< indices of the rims among the edges of the ground
  std::array<std::uint64_t, 3> vertex{};  ///< indices of the corners among the vertices of the ground

  static constexpr int next(int i) { return i == 2 ? 0 : i + 1; }
  double distance(const Vec3& p) const { return normal.dot(p - corner[0]); }
  Vec3 along(int i) const { return corner[next(i)] - corner[i]; }
  /// How far p lies inside the line of rim i [m], measured in the plane of the facet.
  double inside(int i, const Vec3& p) const {
    const Vec3 inward = normal.cross(along(i));  // as long as the rim
    return inward.dot(p - corner[i]) / inward.norm();
  }
  FeatureId face_feature() const { return ground_id(FeatureKind::face, id); }
  FeatureId edge_feature(int i) const { return ground_id(FeatureKind::edge, edge[i]); }
  FeatureId vertex_feature(int i) const { return ground_id(FeatureKind::vertex, vertex[i]); }
  /// Whether this facet is the one that names its edge i.
  bool names_edge(int i) const { return edge[i] / 3 == id; }
};

/// The place of a facet that is nearest to p. At an open rim the facet continues.
Vec3 nearest_on(const Facet& facet, const Vec3& p);

/// How two facets bend at their common edge, from the planes of both and the corner of each that is off the
/// edge. `noise` [m] is what rounding of the coordinates moves a corner by.
Rim rim_between(const Vec3& normal, const Vec3& own_corner, const Vec3& other_normal,
                const Vec3& other_corner, const Vec3& on_edge, double noise);

}  // namespace flyrock
