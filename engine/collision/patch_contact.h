#pragma once
// Contacts of a contactor with circles with any other one.

#include <vector>

#include "collision/contact.h"
#include "collision/placed.h"

namespace flyrock {

/// Appends the contacts whose gap is at most `reach` [m], at most four; see body_contacts. The normal is that
/// of the separation of the cores (gjk.h), or of a face or cap that it differs from by `flush_angle` at most.
/// Where it has the two parts that face each other (facing.h) lie flush, contacts are at the ends of what is
/// common to them: two on a line, and on a plane those that span the greatest area.
void patch_contacts(const Placed3& candidate, int candidate_index, const Placed3& antagonist,
                    int antagonist_index, double reach, std::vector<ContactPoint<3>>& out);

}  // namespace flyrock
