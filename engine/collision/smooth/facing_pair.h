#pragma once
// The parts with which two contactors face each other, and the normal between them.

#include <optional>

#include "collision/smooth/gjk.h"
#include "collision/smooth/support_feature.h"

namespace flyrock {

/// The separation of two cores with the parts that face each other. If one of the parts is plane, contacts
/// have the normal of the plane; if both are, that of b. What lies flush on a plane may end below it, but
/// beside the face or cap: the cores are then farther apart along another normal, that of `apart`. Newton's
/// method makes the normal n of separation() exact: n must point along the line between the two nearest
/// places. A place of a rim of radius R moves by
///   -R/s t (t . dn)
/// if n changes by dn, with the tangent t of the rim and the sine s of the angle between n and the axis. A
/// line that touches stays perpendicular to n.
struct FacingPair {
  Separation apart;
  Patch of_a, of_b;
  Vec3 normal;  ///< of contacts
};
FacingPair facing_pair(const Placed3& a, const Placed3& b);

/// The distance of two known features [m], by the same Newton steps from a normal near theirs: nothing where
/// these do not end near it, where a feature is plane, or where `near` is zero: not known.
std::optional<double> distance_of_features(const Placed3& a, FeatureId feature, const Placed3& b,
                                           FeatureId against, const Vec3& near);

}  // namespace flyrock
