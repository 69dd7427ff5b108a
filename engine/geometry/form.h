#pragma once
// The forms of contactors, each of which touches by rules of its own (collision/pairs.h).

namespace flyrock {

/// A contactor is the hull of points, in 3D also of circles, grown by a radius, or is hollow, an outline, a
/// half space or a cloud. The functions that make contactors set its form. After each form, shapes of
/// scenarios that have it.
enum class Form {
  ball,        ///< one point: disk, pneumatic_disk, sphere; with a radius of 0, point
  pill,        ///< a segment: pill; in 2D wall
  hull,        ///< a convex polygon, whose corners may be round, or polyhedron: polygon, box, polyhedron
  hollow,      ///< solid outside of a circle or a cylinder: hollow_disk, hollow_cylinder
  outline,     ///< a solid, in general not convex, a ground of its own: polyline, mesh_patch
  smooth,      ///< the hull of circles and points: cylinder, cone; this and the next two in 3D only
  half_space,  ///< solid below a plane: plane
  cloud        ///< points without extent, the vertices of a closed surface: mesh_point
};
template <int D>
inline constexpr int form_count = D == 2 ? 5 : 8;

/// What is promised of the contacts of a form (docs/numerics.md, Tiers of shapes). Scenarios of quarries need
/// tier a only. Tiers b and c get no rules or constants of their own for single scenes.
enum class Tier {
  a,  ///< all promises, among moving bodies too
  b,  ///< all promises while it is alone on the terrain; to `loose_share` of its size against moving bodies
  c   ///< to `loose_share` of its size. Pneumatic shapes too, whatever their form
};
inline constexpr double loose_share = 1e-3;

template <int D>
constexpr Tier tier_of(Form form) {
  switch (form) {
    case Form::ball:
    case Form::hull:
      return Tier::a;
    case Form::pill:
      return D == 2 ? Tier::a : Tier::b;
    case Form::hollow:
      return Tier::c;
    case Form::outline:
    case Form::smooth:
    case Form::half_space:
    case Form::cloud:
      return Tier::b;
  }
  return Tier::c;
}

constexpr char name_of(Tier tier) { return tier == Tier::a ? 'A' : tier == Tier::b ? 'B' : 'C'; }

/// Whether it is solid outside of a convex region and has no outside that could touch.
constexpr bool is_hollow(Form form) { return form == Form::hollow || form == Form::half_space; }

}  // namespace flyrock
