#pragma once
// Contactors, the shapes that touch, in 2D.

#include <memory>
#include <string>
#include <vector>

#include "geometry/form.h"
#include "geometry/ground2.h"
#include "math/space.h"

namespace flyrock {

/// A contactor in 2D: the convex hull of `points`, grown by `radius`. One point is a disk, two are a wall
/// with rounded ends, three or more are a convex polygon, whose corners are round if it has a radius.
/// Coordinates in the body's frame, metres.
///
/// A hollow disk is solid outside of the circle of `radius` about the origin, up to the radius `outer`. Other
/// contactors touch it from inside only (collision/hollow/hollow_wall.h).
///
/// An outline is a `ground` of segments (collision/outline/outline.h). It is the only contactor of its body,
/// which does not move freely; `points` are the corners of its box.
struct Contactor2 {
  Form form = Form::ball;
  std::vector<Vec2> points;   ///< from three on, counter-clockwise
  std::vector<Vec2> normals;  ///< outward unit normal of the edge from points[i] to points[i + 1]; none for a
                              ///< disk, two for a wall
  double radius = 0;
  double bound = 0;  ///< radius of the smallest circle about the frame's origin that contains the contactor
  double outer = 0;  ///< m, of a hollow disk; 0 for others
  std::shared_ptr<const Ground2> ground = nullptr;  ///< of an outline; closed

  static constexpr std::size_t most_vertices = 1 << 15;  ///< limit of a feature id (collision/contact.h)

  static Contactor2 disk(double radius, const Vec2& centre = Vec2::Zero());
  static Contactor2 hollow_disk(double radius, double outer);
  /// The hull of a segment or of a counter-clockwise convex polygon, grown by a radius; the normals are
  /// computed.
  static Contactor2 hull(std::vector<Vec2> points, double radius);
  static Contactor2 wall(const Vec2& start, const Vec2& end, double radius) {
    return hull({start, end}, radius);
  }
  static Contactor2 polygon(std::vector<Vec2> vertices) { return hull(std::move(vertices), 0); }
  /// The closed line through the points: clockwise it is solid inside, counter-clockwise outside.
  static Contactor2 outline(const std::vector<Vec2>& points);

  void translate(const Vec2& by);
  /// Scales all lengths by a factor about the origin.
  void scale(double factor);
};

/// What is wrong with a list of vertices as a convex polygon (fewer than three or too many, not convex, no
/// area), or an empty text. Clockwise vertices are not an error: `vertices` is reversed to counter-clockwise
/// order.
std::string make_convex(std::vector<Vec2>& vertices);

/// Area [m2], centroid and second moments of area about the centroid [m4] of contactors that do not overlap;
/// 0 for an outline, which does not move freely.
struct AreaProperties {
  double area = 0;
  Vec2 centroid = Vec2::Zero();
  double polar_moment = 0;
  Eigen::Matrix2d second_moments = Eigen::Matrix2d::Zero();  ///< integral of x x^T; its trace is polar_moment
};
AreaProperties area_properties(const std::vector<Contactor2>& contactors);

/// The default thickness t [m] of a body in 2D with cross-section area A [m2]. Its volume A t then equals the
/// volume of the sphere with the same cross-section: t = 2/3 d with d = 2 sqrt(A/pi). Mass properties are
/// those of a prism:
///   m = rho A t,  I = rho t J   (J the polar second moment of area)
double default_thickness(double area);

}  // namespace flyrock
