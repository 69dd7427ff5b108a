#pragma once
// Bodies that touch with corners, edges or rims: several of them can touch at one instant.

#include <algorithm>
#include <string>

#include "world/body.h"

namespace flyrock {

/// Whether a contactor has corners. Rounded ends of a wall or a pill are none, and neither is a single point;
/// a room is touched from inside.
inline bool has_corners(const Contactor2& contactor) {
  return contactor.points.size() > 2 || (contactor.points.size() > 1 && contactor.radius == 0);
}
inline bool has_corners(const Contactor3& contactor) {
  const std::size_t points = contactor.points.size();
  return !contactor.is_room() && (contactor.has_faces() || contactor.has_circles() || points > 2 ||
                                  (points > 1 && contactor.radius == 0));
}
template <int D>
bool has_corners(const Body<D>& body) {
  return std::any_of(body.contactors.begin(), body.contactors.end(),
                     [](const auto& contactor) { return has_corners(contactor); });
}

/// Why a restitution law of form `velocity` does not serve a body with corners.
inline std::string corners_text(const std::string& body) {
  return "`" + body +
         "` has corners, of which several can touch at once, but a law of form `velocity` gives the whole "
         "velocity "
         "after the impact of one contact; expected a round shape, `method: lumped_mass` or a law of another "
         "form";
}

}  // namespace flyrock
