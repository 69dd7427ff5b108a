#pragma once
// The time of impact of two contactors.

#include <optional>
#include <span>

#include "collision/contact.h"
#include "collision/motion.h"
#include "geometry/contactor.h"
#include "geometry/contactor3.h"
#include "geometry/ground.h"
#include "geometry/ground2.h"

namespace flyrock {

/// A contact that exists when the search begins, by its feature ids.
struct HeldContact {
  FeatureId feature = 0;
  FeatureId against = 0;
  bool opened = false;  ///< in a step: the last impact opened it, and the step holds no contact of the pair
  bool yields = false;  ///< a spring: its bodies sink into each other
};

/// What is known at the start of a search. In free flight, the held contacts are those that have just opened.
/// They may close again, and their gap counts from 0. In a contact step, the solver handles the held contacts
/// and the search skips them (`held_are_solved`). `slack` [m] is then the penetration below which a touch
/// does not count as new.
struct TouchSearch {
  std::span<const HeldContact> held;
  bool held_are_solved = false;
  double slack = 0;
  double size = 1;  ///< m, of the body; the time of impact is exact up to a gap of 1e-12 of it
  std::uint64_t* iterations = nullptr;

  bool holds(FeatureId feature, FeatureId against) const {
    for (const HeldContact& h : held)
      if (h.feature == feature && h.against == against) return true;
    return false;
  }
  /// The gap at the start for a distance polynomial [m]. A contact that has just opened counts from 0,
  /// because a bounce on the same point must then take 2 v / g to the last bit.
  double start_gap(double gap, bool just_opened) const;
};

/// How deep a point may lie in the ground at time t of a motion [m], before it meets the segment or facet
/// beyond a concave corner or rim. In a step that passes the corner, the contact on this side is not found in
/// the middle of the step, and the point falls until the step is cut at the other side.
template <int D>
double point_sinks(const Path<D>& motion, double t, const TouchSearch& search) {
  constexpr double rounding = 1e-3;  // of the size
  return rounding * search.size + (search.held_are_solved ? 0.5 * motion.a.norm() * t * t : 0);
}

/// The first time in [0, t_max] at which the moving contactor touches the terrain and approaches it [s]. The
/// answer lies on the side on which the gap is not negative.
///
/// For a disk about the centre of mass it is the exact root of the distance polynomial along the parabola:
/// degree 2 for a segment, 4 for a corner. Other contactors use directed conservative advancement. For an
/// edge normal n of either contactor, every point of the other one has the lower bound
///   gap(t) >= gap + gap' t - M t^2 / 2,   M >= -gap''.
/// Until the smallest root of these bounds, n still separates the two. The search follows the direction that
/// separates longest. Near contact this is Newton's method from the safe side. A pair that has just separated
/// (gap 0, gap' > 0) advances by 2 gap' / M. For times up to T, M is the smaller of a bound over the whole
/// search and of J T - gap''(0), where J >= -gap'''.
std::optional<double> time_of_contact(const Contactor2& contactor, int contactor_index, const Motion2& motion,
                                      const Ground2& ground, double t_max, const TouchSearch& search);

/// The same for two moving contactors.
std::optional<double> time_of_contact(const Contactor2& a, int a_index, const Motion2& a_motion,
                                      const Contactor2& b, int b_index, const Motion2& b_motion, double t_max,
                                      const TouchSearch& search);

/// The same in 3D. For a sphere about the centre of mass it is the exact root of a polynomial: of degree 2
/// with a plane, of degree 4 with another such sphere. Other contactors use directed conservative
/// advancement, as above. The directions that may separate are:
///   - the face normals of both contactors;
///   - the cross products of an edge of one and an edge of the other;
///   - with a sphere or a pill, the line between the nearest places of the two cores. It turns with one of
///     the contactors.
std::optional<double> time_of_contact(const Contactor3& contactor, int contactor_index, const Motion3& motion,
                                      const Ground3& ground, double t_max, const TouchSearch& search);
std::optional<double> time_of_contact(const Contactor3& a, int a_index, const Motion3& a_motion,
                                      const Contactor3& b, int b_index, const Motion3& b_motion, double t_max,
                                      const TouchSearch& search);

}  // namespace flyrock
