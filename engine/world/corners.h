#pragma once
// Bodies that touch with corners, edges or rims: several of them can touch at one instant.

#include <algorithm>
#include <string>

#include "world/body.h"

namespace flyrock {

/// Whether a contactor has corners. Rounded ends of a wall or a pill are none, and neither is a single point;
/// a hollow one is touched from inside.
template <class Contactor>
bool has_corners(const Contactor& contactor) {
  if (contactor.form == Form::pill) return contactor.radius == 0;
  return contactor.form != Form::ball && !is_hollow(contactor.form);
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
