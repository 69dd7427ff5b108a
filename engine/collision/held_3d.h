#pragma once
// What contacts with the ground hold in 3D (held.h): points along a direction.

#include "collision/advance_3d.h"
#include "collision/pair_search.h"

namespace flyrock {

/// A direction is held as long as the normal of its contact is within this angle of it [rad].
inline constexpr double drift_angle = 1e-3;

/// The contacts with the ground that exist at the start of a search. Valid until the next call.
std::span<const HeldOnGround> held_on(Workspace& work, const Ground3& ground, const HeldContacts& held);

/// A search without the contacts of a pill whose gap is above 1e-4 of the size: it may leave an edge and come
/// back to it elsewhere, which is a new touch. Valid until the next call.
TouchSearch without_distant(Workspace& work, const Moving3& c, const Ground3& ground,
                            const TouchSearch& search);

/// Whether a contact with a facet of the ground is in the plane of another facet.
bool is_in_plane(const HeldOnGround& held, const Facet& facet, double size);

/// The contacts of a contactor with a facet and its rim, as points of the two. Of two bodies: none.
class HeldPoints {
 public:
  /// The features to which a direction belongs, and with which it turns: a face or another feature of one of
  /// the two, or an edge of each, whose cross product it is.
  struct Features {
    std::optional<FeatureId> of_a, of_b;
  };

  HeldPoints(const Moving3& a, const Moving3& b, CoreSearch by, const TouchSearch& search)
      : a_(a), b_(b), by_(by), search_(search) {}

  /// Whether a contact keeps the point i of a and the point j of b apart along a direction from b to a.
  Hold hold(const Vec3& direction, const Features& of, int i, int j, const MovingState& state_of_a) const;
  /// Whether a's face has a contact with the ground.
  bool is_on_ground(int face) const;
  /// Calls use(edge of a, edge of the facet) for each contact of two edges.
  template <class Use>
  void for_edges(const Use& use) const {
    const auto is_edge = [](FeatureId feature) { return kind_of(feature) == FeatureKind::edge; };
    for (const HeldOnGround& h : b_.held_on_ground)
      for (int i = 0; i < 3; ++i)
        if (contactor_of(h.feature) == a_.index && is_edge(h.feature) &&
            h.against == b_.facet->edge_feature(i))
          use(index_of(h.feature), i);
  }

 private:
  /// Where a feature is: on a face, on the line of an edge, or at a point. World frame, metres.
  struct Place {
    FeatureKind kind;
    Vec3 at, along, normal;
  };
  static Place place_of(const Moving3& c, FeatureId feature, const MovingState& s);
  static Vec3 normal_of(const Place& a, const Place& b);
  bool agrees(const Vec3& direction, const Place& a, const Place& b) const;
  /// Whether the two features have a contact.
  bool has(FeatureId feature, FeatureId against) const;
  /// Whether one holds the points exactly along a direction of one of the two; `point`: of the other.
  bool holds_on(const Features& of, int point) const;
  /// Whether two edges have a contact, and have these points.
  bool holds_edges(const Features& of, int i, int j) const;
  /// Whether a's point i has a contact in the plane of b, the facet of this face.
  bool over(FeatureId face, int i) const;
  /// Whether a contact with an edge or a vertex of the ground holds the points along its normal.
  bool along_rim(const Vec3& direction, int i, int j, const MovingState& state_of_a) const;
  /// Whether one holds the points now, along a normal that drifts from the direction.
  Hold drifts_from(const Vec3& direction, int i, int j, const MovingState& state_of_a) const;
  bool of_b(FeatureId feature) const;

  const Moving3& a_;
  const Moving3& b_;
  CoreSearch by_;
  const TouchSearch& search_;
};

}  // namespace flyrock
