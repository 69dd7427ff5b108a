#pragma once
// Contactors, the shapes that touch, in 3D.

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/form.h"
#include "math/space.h"

namespace flyrock {

class Ground3;
struct Mesh;

/// A contactor in 3D: the convex hull of `points` and `circles`, grown by `radius`. One point with a radius
/// is a sphere, two points with a radius are a pill, which has one edge and no face. Points with faces,
/// without a radius, are a convex polyhedron. Two circles are a cylinder. Coordinates in the body's frame,
/// metres.
///
/// A hollow cylinder has the two circles at the ends of its inside, and is solid outside up to the radius
/// `outer`. A half space is solid below the plane z = 0. Other contactors touch both from inside
/// (collision/hollow/hollow_wall.h).
///
/// Two forms are not convex. An outline is a solid bounded by triangles, its `ground`, as in 2D. A cloud
/// touches with its points only, which are the vertices of a closed surface (`skin`).
struct Contactor3 {
  /// A circle about an axis. The disk in it is a flat cap of the contactor, which lies behind it.
  struct Circle {
    Vec3 centre = Vec3::Zero();
    Vec3 axis = Vec3::UnitZ();  ///< unit, out of the cap
    double radius = 0;          ///< m
    /// The part of a vector across the axis. Of a vector nearly along the axis, rounding would leave a part
    /// along it that is as great.
    Vec3 across(const Vec3& v) const {
      const Vec3 once = v - axis.dot(v) * axis;
      return once - axis.dot(once) * axis;
    }
    /// Unit, towards the farthest place along a direction; a fixed one if the cap is level.
    Vec3 towards(const Vec3& direction) const;
  };
  /// A plane face with `count` vertices loop[first], ..., loop[first + count - 1], counter-clockwise as seen
  /// from outside.
  struct Face {
    Vec3 normal = Vec3::Zero();  ///< unit, outward
    int first = 0;
    int count = 0;
  };
  /// An edge from points[start] to points[end]. The loop of the face `left` passes it in this direction, the
  /// loop of the face `right` in the opposite direction. The edge of a pill has no faces (-1).
  struct Edge {
    int start = 0, end = 0;
    int left = 0, right = 0;
  };
  static constexpr int most_face_vertices = 32;  ///< size of the buffers of the narrow phase
  static constexpr int most_edges =
      1 << 14;  ///< limit of a feature id (collision/contact.h); vertices and faces are fewer

  Form form = Form::ball;
  std::vector<Vec3> points;
  std::vector<int> loop;       ///< indices into points, face after face
  std::vector<int> loop_edge;  ///< the edge from a loop's vertex to the next
  std::vector<Face> faces;     ///< none for a sphere or a pill
  std::vector<Edge> edges;
  std::vector<Circle> circles;  ///< about one axis
  double radius = 0;
  double bound = 0;  ///< radius of the smallest sphere about the frame's origin that contains the contactor
  double outer = 0;  ///< m, of a hollow cylinder; 0 for others
  std::shared_ptr<const Ground3> ground = nullptr;  ///< of an outline; closed
  std::vector<std::array<int, 3>> skin =
      {};  ///< of a cloud: triangles, indices into points, seen from outside

  static Contactor3 sphere(double radius, const Vec3& centre = Vec3::Zero());
  /// The segment from `start` to `end`, grown by a radius.
  static Contactor3 pill(const Vec3& start, const Vec3& end, double radius);
  /// A box about the origin with sides along the axes.
  static Contactor3 box(const Vec3& size);
  /// About the origin, with the axis z.
  static Contactor3 cylinder(double radius, double height);
  /// About the origin, with the axis z.
  static Contactor3 hollow_cylinder(double radius, double outer, double height);
  static Contactor3 half_space();
  /// The solid in a closed mesh without faults (geometry/mesh_fault.h).
  static Contactor3 solid(Mesh mesh);
  /// The vertices of such a mesh, as a cloud. Throws std::invalid_argument if they are too many.
  static Contactor3 cloud(const Mesh& mesh);
  /// A convex polyhedron given by its faces. Each face is a loop of indices into `points`, counter-clockwise
  /// as seen from outside. Throws std::invalid_argument if the faces do not form a closed convex surface or
  /// are too many.
  static Contactor3 polyhedron(std::vector<Vec3> points, const std::vector<std::vector<int>>& faces);

  int vertex(const Face& face, int i) const { return loop[face.first + i]; }
  /// The place of the core, the hull without its radius, that is farthest along a direction.
  Vec3 support(const Vec3& direction) const;
  /// The axis (unit) of a contactor with circles about which it may turn without a change of its places: it
  /// is one of revolution, and goes through the frame's origin.
  std::optional<Vec3> axis_of_revolution() const;
  /// Expresses the contactor in another frame: p becomes r^-1 (p - origin).
  void change_frame(const Vec3& origin, const Rotation3& r);
  /// Scales all lengths by a factor about the origin.
  void scale(double factor);
};

}  // namespace flyrock
