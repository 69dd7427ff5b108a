#pragma once
// The part of a contactor that faces a direction, and the features of contactors with circles.

#include <boost/container/static_vector.hpp>
#include <optional>

#include "collision/placed.h"
#include "geometry/ground.h"

namespace flyrock {

/// The features of a contactor with circles. Edge 16 k + s is a place of the rim k: s = 0 is the farthest one
/// along a direction, and walks around the rim as the contactor rolls; s = 1 to 7 are turned from it by s
/// eighths of a turn; s = 8, 9 are where the rim crosses something. Face k is the cap k, face side_face the
/// side between the circles or between circle and point.
inline constexpr int rim_places = 8, side_face = 16;
inline int rim_index(int circle, int place) { return 16 * circle + place; }
inline int circle_of_rim(int index) { return index / 16; }
inline int place_of_rim(int index) { return index % 16; }

/// A place of a rim; see above. `direction` points out of the contactor, world frame.
Vec3 rim_place(const Placed3& shape, int index, const Vec3& direction);

/// The pieces of a core are its points, then its circles. Whether a feature contains a piece.
bool contains_piece(const Contactor3& shape, const ShapeFeature& feature, int piece);
inline int pieces_of(const Contactor3& shape) {
  return static_cast<int>(shape.points.size() + shape.circles.size());
}

/// A place, a line, a plane polygon or a cap of a core, in the world.
struct Patch {
  enum class Kind { point, segment, polygon, disc } kind = Kind::point;
  struct Place {
    Vec3 at;
    ShapeFeature feature;
    ShapeFeature side;  ///< of the line to the next place
  };
  boost::container::static_vector<Place, Contactor3::most_face_vertices> places;  ///< of a disc: none
  ShapeFeature feature;                                                           ///< of its inside
  Vec3 normal = Vec3::Zero();  ///< unit, outward: of a polygon or disc
  int circle = 0;              ///< of a disc
  Vec3 centre = Vec3::Zero();
  double radius = 0;  ///< of a disc; a polygon: of the contactor

  bool is_plane() const { return kind == Kind::polygon || kind == Kind::disc; }
};

/// The part of the core that faces a direction, up to `flush_angle`: a face or cap, an edge or the line of a
/// side, a vertex or a place of a rim. `without` planes: no face or cap.
enum class Planes { with, without };
Patch support_feature(const Placed3& shape, const Vec3& direction, Planes planes = Planes::with);

/// The part that a feature names, of which a rim and a side are as they face a direction: nothing for a face
/// or cap, and for the places where a rim crosses something.
std::optional<Patch> known_feature(const Placed3& shape, FeatureId feature, const Vec3& direction);

/// A place on a patch: its first one, or the centre of a disc.
Vec3 place_on(const Patch& patch);

/// The line with which a feature touches: an edge, the tangent of a rim, or the line of a side. A vertex
/// gives the zero vector, a face none. Of any length, world frame; `direction` points out of the contactor
/// along the normal of the contact.
std::optional<Vec3> touching_line(const Placed3& shape, FeatureId feature, const Vec3& direction);
std::optional<Vec3> touching_line(const Ground3& ground, FeatureId feature);

/// The rate at which the lever of a contact changes [m/s]. `lever` leads from the centre of mass to the
/// contact on the surface, `direction` out of the body. It turns with the body, but on a face, or along an
/// edge, the place of a rim that is farthest along the direction walks around the rim. `other` is the line
/// with which the other body touches; where a rim crosses it, the place does not walk.
Vec3 lever_rate(const Placed3& shape, FeatureId feature, const Vec3& direction, const Vec3& spin,
                const Vec3& lever, const std::optional<Vec3>& other);

}  // namespace flyrock
