#include "world/body.h"

#include <algorithm>
#include <cmath>

namespace flyrock {

Body<2> make_body(std::vector<Contactor2> contactors, double density, double mass, double thickness) {
  const AreaProperties properties = area_properties(contactors);
  Body<2> body;
  for (Contactor2& contactor : contactors) {
    contactor.translate(-properties.centroid);
    body.size = std::max(body.size, contactor.bounding_radius());
  }
  body.contactors = std::move(contactors);
  const double t = thickness > 0 ? thickness : default_thickness(properties.area);
  body.volume = properties.area * t;
  body.mass = density > 0 ? density * body.volume : mass;
  body.inertia = body.mass * properties.polar_moment / properties.area;
  body.radius = std::sqrt(properties.area / pi);
  return body;
}

}  // namespace flyrock
