#include <array>

#include "collision/advancement3.h"
#include "collision/round_path.h"
#include "collision/time_of_contact.h"
#include "math/polynomial.h"

namespace flyrock {

namespace {

/// Whether the contactor is a sphere centred at the body's centre of mass.
bool rolls(const Contactor3& contactor) { return contactor.round() && contactor.points[0].isZero(); }

/// The first root of a distance polynomial, for a pair with a single contact point.
template <std::size_t N>
std::optional<double> first_touch(const std::array<double, N>& gap, double t_max, const TouchSearch& search) {
  if (search.iterations) ++*search.iterations;
  return first_approach(gap, 0, t_max);
}

}  // namespace

std::optional<double> time_of_contact(const Contactor3& contactor, int contactor_index, const Motion3& motion,
                                      const Terrain3& terrain, double t_max, const TouchSearch& search) {
  const Plane& plane = terrain.plane();
  if (!rolls(contactor)) return advance_to_plane({contactor, motion, contactor_index}, plane, t_max, search);
  const bool held =
      search.holds(feature_id(contactor_index, FeatureKind::vertex, 0), feature_id(0, FeatureKind::face, 0));
  if (held && search.held_are_solved) return std::nullopt;
  const std::array<double, 3> gap{search.start_gap(plane.distance(motion.x) - contactor.radius, held),
                                  plane.normal.dot(motion.v), 0.5 * plane.normal.dot(motion.a)};
  return first_touch(gap, t_max, search);
}

std::optional<double> time_of_contact(const Contactor3& a, int a_index, const Motion3& a_motion,
                                      const Contactor3& b, int b_index, const Motion3& b_motion, double t_max,
                                      const TouchSearch& search) {
  if (!rolls(a) || !rolls(b))
    return advance_to_contact({a, a_motion, a_index}, {b, b_motion, b_index}, t_max, search);
  const bool held =
      search.holds(feature_id(a_index, FeatureKind::vertex, 0), feature_id(b_index, FeatureKind::vertex, 0));
  if (held && search.held_are_solved) return std::nullopt;
  const Path<3> relative{a_motion.x - b_motion.x, a_motion.v - b_motion.v, a_motion.a - b_motion.a};
  const double radii = a.radius + b.radius;
  return first_touch(ball_gap(relative, radii, search.start_gap(relative.x.norm() - radii, held)), t_max,
                     search);
}

}  // namespace flyrock
