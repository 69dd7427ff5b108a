#pragma once
// Contacts of a sphere or a pill with any contactor.

#include <vector>

#include "collision/contact.h"
#include "collision/placed.h"

namespace flyrock {

/// A pill lies flush on an edge or a face, and gets two contacts, if the angle between them is less than this
/// [rad].
inline constexpr double flush_angle = 1e-4;

/// Appends the contacts whose gap is at most `reach` [m]; see body_contacts. The candidate, the antagonist or
/// both have no faces.
void core_contacts(const Placed3& candidate, int candidate_index, const Placed3& antagonist,
                   int antagonist_index, double reach, std::vector<ContactPoint<3>>& out);

}  // namespace flyrock
