#pragma once
// The forms of contactors, each of which touches by rules of its own (collision/pairs.h).

namespace flyrock {

/// A contactor is the hull of points, in 3D also of circles, grown by a radius, or is hollow, an
/// outline, a half space or a cloud. The
/// functions that make contactors set its form.
enum class Form {
  ball,        ///< one point: a disk, a sphere; a mass point if the radius is 0
  pill,        ///< a segment: a pill, in 2D a wall
  hull,        ///< a convex polygon, whose corners may be round, or a convex polyhedron
  hollow,      ///< solid outside of a circle or a cylinder, touched from inside: a drum
  outline,     ///< a solid bounded by segments or triangles, in general not convex: a ground of its own
  smooth,      ///< the hull of circles and points: a cylinder, a cone; as the next ones in 3D only
  half_space,  ///< solid below a plane
  cloud        ///< points without extent, the vertices of a closed surface
};
template <int D>
inline constexpr int form_count = D == 2 ? 5 : 8;

/// Whether it is solid outside of a convex region and has no outside that could touch.
constexpr bool is_hollow(Form form) { return form == Form::hollow || form == Form::half_space; }

}  // namespace flyrock
