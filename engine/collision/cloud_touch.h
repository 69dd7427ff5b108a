#pragma once
// Time of impact of points without extent with a facet of the ground.

#include "collision/advancement3.h"

namespace flyrock {

/// The first time in the window at which a point of the cloud reaches the facet from above and approaches
/// it; see time_of_contact. A point that is below the plane of the facet, but beside the facet or deeper than
/// a contact can be, comes from another side of the solid and does not touch this facet.
std::optional<double> advance_cloud_to_facet(const MovingContactor& cloud, const Facet& facet,
                                             const TimeWindow& window, const TouchSearch& search);

}  // namespace flyrock
