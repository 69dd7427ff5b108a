#pragma once
// The bodies of rocks that a table describes.

#include "plugin/models.h"
#include "scenario/rock_table.h"

namespace flyrock {

/// A form with the lengths of its bounding box [m]. In 2D the rock turns about its longest length: the shape
/// is its cross-section.
template <int D>
ShapeAnswer<D> shape_of(RockForm form, const Vec3& lengths);

/// The thickness with which the cross-section has the volume of the form [m].
double thickness_of(RockForm form, const Vec3& lengths);

/// Where a rock of a table starts and how fast, in the coordinates of the scenario.
template <int D>
RockPlan<D> plan_of(const TableRock& rock);

}  // namespace flyrock
