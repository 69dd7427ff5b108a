#pragma once
// Which contacts hold a pair of contactors apart when a search for their time of impact begins.

#include "collision/advance3.h"

namespace flyrock {

/// The contacts of TouchSearch::held that concern the pair a, b. The solver holds their points apart, so that
/// the search must not stop at them.
class HeldPair {
 public:
  HeldPair(const MovingContactor& a, const MovingContactor& b, const TouchSearch& search)
      : a_(a), b_(b), search_(search) {}

  /// A contact of these two features. A sphere has only one contact with a convex contactor, so its feature
  /// does not matter.
  bool holds(FeatureId feature, FeatureId against) const;

  /// A contact that holds the point i of a over another facet of the plane of the facet b. The point may then
  /// be beside b, and the plane still separates the other points from it.
  bool over(FeatureId face, int i) const;

  /// A contact that holds the point i of a and the corner j of the facet b apart along a direction: the
  /// features that touch contain them, and its normal is this direction. A face of a that lies on an edge of
  /// the ground touches it with several edges. Each of them gives a direction in which the ends of the others
  /// have no gap.
  bool along(const Vec3& direction, int i, int j, const MovingState& state_of_a) const;

  /// How a contact holds the point i of a and the point j of b apart along a direction. For pairs in which a
  /// pill touches. `exactly`: the direction is the normal of the contact while the bodies move, because it
  /// belongs to the same face or the same two edges. `for_now`: it is now, but it drifts from it. The end of
  /// a pill has one contact with a convex contactor, as a sphere; so the feature there does not matter.
  enum class Hold { no, for_now, exactly };
  /// The direction is the normal of a face, or of another feature that turns with a contactor.
  Hold along_normal(const Vec3& direction, FeatureId feature, int i, int j, const MovingState& state_of_a,
                    const MovingState& state_of_b) const;
  /// The direction is the cross product of these edges.
  Hold along_edges(const Vec3& direction, FeatureId edge_a, FeatureId edge_b, int i, int j,
                   const MovingState& state_of_a, const MovingState& state_of_b) const;

  /// A contact of a's face with the ground.
  bool touches(int face) const;

 private:
  /// Where a feature is: on a face, on the line of an edge, or at a point. World frame, metres.
  struct Place {
    FeatureKind kind;
    Vec3 at, along, normal;
  };
  static Place place_of(const MovingContactor& c, FeatureId feature, const MovingState& s);
  static Vec3 normal_of(const Place& a, const Place& b);
  static bool contains(const MovingContactor& c, FeatureId feature, int point);
  bool agrees(const Vec3& direction, const Place& a, const Place& b) const;
  Hold for_now(const Vec3& direction, int i, int j, const MovingState& sa, const MovingState& sb) const;
  bool of_b(FeatureId feature) const;
  /// Whether a contact with a facet is in the plane of the facet b.
  bool in_plane(const HeldOnGround& h) const;

  const MovingContactor& a_;
  const MovingContactor& b_;
  const TouchSearch& search_;
};

}  // namespace flyrock
