#include "trial/table_rock.h"

#include <algorithm>
#include <cmath>

#include "geometry/hull.h"
#include "geometry/volume_properties.h"

namespace flyrock {

namespace {

/// The corners of a regular dodecahedron: those of a cube and of three rectangles in the golden ratio.
std::vector<Vec3> dodecahedron() {
  const double golden = (1 + std::sqrt(5.0)) / 2;
  std::vector<Vec3> corners;
  for (int corner = 0; corner < 8; ++corner)
    corners.emplace_back(corner & 1 ? -1 : 1, corner & 2 ? -1 : 1, corner & 4 ? -1 : 1);
  for (int axis = 0; axis < 3; ++axis)
    for (int corner = 0; corner < 4; ++corner) {
      Vec3 p = Vec3::Zero();
      p[axis] = (corner & 1 ? -1 : 1) / golden;
      p[(axis + 1) % 3] = (corner & 2 ? -1 : 1) * golden;
      corners.push_back(p);
    }
  return corners;
}

/// A polyhedron with the volume of the ellipsoid.
Contactor3 ellipsoid(const Vec3& lengths) {
  std::vector<Vec3> corners = dodecahedron();
  for (Vec3& corner : corners) corner = corner.cwiseProduct(lengths);
  Contactor3 body = convex_hull(corners);
  const double volume = volume_properties(std::vector{body}).volume;
  body.scale(std::cbrt(volume_of(RockForm::ellipsoid, lengths) / volume));
  return body;
}

/// The shorter two lengths, the longer one first.
Vec2 cross_section(Vec3 lengths) {
  std::sort(lengths.begin(), lengths.end());
  return {lengths[1], lengths[0]};
}

Contactor2 section_of_form(RockForm form, const Vec3& lengths) {
  if (form == RockForm::sphere) return Contactor2::disk(std::cbrt(lengths.prod()) / 2);
  const Vec2 half = cross_section(lengths) / 2;
  std::vector<Vec2> corners;
  if (form == RockForm::box) corners = {{1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
  if (form == RockForm::cut)
    corners = {{1, -0.5}, {1, 0.5}, {0.5, 1}, {-0.5, 1}, {-1, 0.5}, {-1, -0.5}, {-0.5, -1}, {0.5, -1}};
  if (form == RockForm::ellipsoid) {
    constexpr int sides = 20;
    // The polygon has the area of the ellipse.
    const double grow = std::sqrt(2 * pi / (sides * std::sin(2 * pi / sides)));
    for (int i = 0; i < sides; ++i) {
      const double angle = 2 * pi * i / sides;
      corners.emplace_back(grow * std::cos(angle), grow * std::sin(angle));
    }
  }
  for (Vec2& corner : corners) corner = corner.cwiseProduct(half);
  return Contactor2::polygon(std::move(corners));
}

}  // namespace

template <>
ShapeAnswer<2> shape_of<2>(RockForm form, const Vec3& lengths) {
  return {{section_of_form(form, lengths)}};
}

template <>
ShapeAnswer<3> shape_of<3>(RockForm form, const Vec3& lengths) {
  if (form == RockForm::box) return {{Contactor3::box(lengths)}};
  if (form == RockForm::cut) return {{norm_block(lengths)}};
  if (form == RockForm::ellipsoid) return {{ellipsoid(lengths)}};
  return {{Contactor3::sphere(std::cbrt(lengths.prod()) / 2)}};
}

double thickness_of(RockForm form, const Vec3& lengths) {
  return volume_of(form, lengths) / area_properties({section_of_form(form, lengths)}).area;
}

template <>
RockPlan<2> plan_of<2>(const TableRock& rock) {
  RockPlan<2> plan;
  if (rock.place) plan.position = Vec2(rock.place->x(), rock.place->z());
  if (rock.velocity) plan.velocity = Vec2(rock.velocity->x(), rock.velocity->z());
  return plan;
}

template <>
RockPlan<3> plan_of<3>(const TableRock& rock) {
  RockPlan<3> plan;
  if (rock.place && !rock.on_ground) plan.position = *rock.place;
  plan.velocity = rock.velocity;
  return plan;
}

}  // namespace flyrock
