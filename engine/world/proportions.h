#pragma once
// How long, flat and angular a body is.

#include "plugin/contact_law.h"
#include "world/body.h"

namespace flyrock {

/// Of the ellipsoid (2D: ellipse) with the same moments of inertia, the intermediate axis over the longest
/// (2D: the shorter over the longer), and in 3D the shortest over the intermediate one. An ellipsoid with the
/// semi-axes a, b, c has I_a = m (b^2 + c^2) / 5, therefore a^2 ~ I_b + I_c - I_a. A point counts as round.
/// `corners`: those of the contactors, rounded ones too; 0 of a disk, a sphere, a pill or a body with rims.
template <int D>
Proportions proportions_of(const Body<D>& body);

/// Writes the shape of a body with these proportions into the state that a law reads.
template <int D>
void put_shape(const Body<D>& body, const Proportions& proportions, ContactState& state) {
  state.shape_type = body.shape_type;
  state.shape_elongation = proportions.elongation;
  state.shape_flatness = proportions.flatness;
  state.shape_corners = proportions.corners;
}

}  // namespace flyrock
