#include "geometry/cone.h"

#include <algorithm>
#include <cmath>

namespace flyrock {

Contactor3 cone(double radius, double height) {
  Contactor3 shape;
  shape.form = Form::smooth;
  shape.circles = {{{0, 0, -0.25 * height}, {0, 0, -1}, radius}};
  shape.points = {{0, 0, 0.75 * height}};
  shape.bound = std::max(0.75 * height, std::hypot(0.25 * height, radius));
  return shape;
}

}  // namespace flyrock
