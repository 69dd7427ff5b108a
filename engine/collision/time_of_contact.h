#pragma once
// When two contactors first touch.

#include <optional>
#include <span>

#include "collision/contact.h"
#include "collision/motion.h"
#include "collision/terrain.h"
#include "collision/terrain3.h"
#include "geometry/contactor.h"
#include "geometry/contactor3.h"

namespace flyrock {

/// A contact that exists when the search begins, by its feature ids.
struct HeldContact {
  std::uint32_t feature = 0;
  std::uint32_t against = 0;
};

/// What is known at the start. In a flight the held contacts are those that have just opened: they may close
/// again, and their gap counts from where it was. In a contact step they are the solver's, and are passed
/// over; `slack` [m] is then the overlap below which a touch is not counted as new.
struct TouchSearch {
  std::span<const HeldContact> held;
  bool held_are_solved = false;
  double slack = 0;
  double size = 1;  ///< m, of the body: a time is exact to a gap of 1e-12 of it
  std::uint64_t* iterations = nullptr;

  bool holds(std::uint32_t feature, std::uint32_t against) const;
  /// The gap at the start as a distance polynomial takes it: a contact that has just opened counts from 0, so
  /// that a bounce on the same place takes 2 v / g to the last bit.
  double start_gap(double gap, bool just_opened) const;
};

/// The first time in [0, t_max] at which the moving contactor touches the terrain and approaches it; the
/// answer lies on the side where the gap is not negative.
///
/// A disk about the centre of mass: the exact root of the distance polynomial along the parabola, degree 2
/// for a segment, 4 for a corner. Others: directed conservative advancement. For an edge normal n of either
/// side, gap(t) of every point of the other side is bounded from below by gap + gap' t - M t^2 / 2, with M a
/// bound of -gap''; the least of their roots is a time before which n still separates the two. The direction
/// that lasts longest is followed. Near contact this is Newton's method from the safe side, and a pair that
/// has just separated (gap 0, gap' > 0) advances by 2 gap' / M.
std::optional<double> time_of_contact(const Contactor2& contactor, int contactor_index, const Motion2& motion,
                                      const Terrain2& terrain, double t_max, const TouchSearch& search);

/// The same for two moving contactors.
std::optional<double> time_of_contact(const Contactor2& a, int a_index, const Motion2& a_motion,
                                      const Contactor2& b, int b_index, const Motion2& b_motion, double t_max,
                                      const TouchSearch& search);

/// In 3D. A sphere about the centre of mass and a plane or another such sphere: the exact root, degree 2
/// and 4. Others: directed conservative advancement, as above; the directions are the normals of faces, the
/// line from the nearest place of a contactor to the centre of a sphere, turning with it, and the products of
/// two edges.
std::optional<double> time_of_contact(const Contactor3& contactor, int contactor_index, const Motion3& motion,
                                      const Terrain3& terrain, double t_max, const TouchSearch& search);
std::optional<double> time_of_contact(const Contactor3& a, int a_index, const Motion3& a_motion,
                                      const Contactor3& b, int b_index, const Motion3& b_motion, double t_max,
                                      const TouchSearch& search);

}  // namespace flyrock
