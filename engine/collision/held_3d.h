#pragma once
// What contacts hold in 3D (held.h): of two cores, points along a direction; of contactors with circles,
// pieces of them; and of the ground, where its features are.

#include <boost/container/small_vector.hpp>

#include "collision/advance_3d.h"
#include "collision/pair_search.h"

namespace flyrock {

/// A direction is held as long as the normal of its contact is within this angle of it [rad].
inline constexpr double drift_angle = 1e-3;

/// The contacts with the ground that exist at the start of a search. Valid until the next call.
std::span<const HeldOnGround> held_on(Workspace& work, const Ground3& ground, const HeldContacts& held);

/// A search without the contacts of a pill or a contactor with circles whose gap is above 1e-4 of the size:
/// it may leave an edge and come back to it elsewhere, which is a new touch. Valid until the next call.
TouchSearch without_distant(Workspace& work, const Moving3& c, const Ground3& ground,
                            const TouchSearch& search);

/// Whether a contact with a facet of the ground is in the plane of another facet.
bool is_in_plane(const HeldOnGround& held, const Facet& facet, double size);

/// Whether a contact of two bodies is of the contactors a and b.
inline bool is_of_pair(const HeldContact& h, const Moving3& a, const Moving3& b) {
  return contactor_of(h.feature) == a.index && contactor_of(h.against) == b.index;
}

/// The contacts that concern the pair a, b, as points of the two.
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
  Hold hold(const Vec3& direction, const Features& of, int i, int j, const MovingState& state_of_a,
            const MovingState& state_of_b) const;
  /// Whether a's face has a contact with the ground.
  bool is_on_ground(int face) const;
  /// Calls use(edge of a, edge of b) for each contact of two edges.
  template <class Use>
  void for_edges(const Use& use) const {
    const auto is_edge = [](FeatureId feature) { return kind_of(feature) == FeatureKind::edge; };
    for (const HeldOnGround& h : b_.held_on_ground)
      for (int i = 0; i < 3; ++i)
        if (contactor_of(h.feature) == a_.index && is_edge(h.feature) &&
            h.against == b_.facet->edge_feature(i))
          use(index_of(h.feature), i);
    if (b_.facet) return;
    for (const HeldContact& h : search_.held.list)
      if (is_of_pair(h, a_, b_) && is_edge(h.feature) && is_edge(h.against))
        use(index_of(h.feature), index_of(h.against));
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
  /// Whether the two features have a contact; with a ball, any two.
  bool has(FeatureId feature, FeatureId against) const;
  /// Whether one holds the points exactly along a direction of one of the two; `point`: of the other.
  bool holds_on(const Features& of, int point) const;
  /// Whether a point of the other contactor lies beyond a side of a face of one of the two, and has an edge
  /// that crosses this side in a contact: the contact carries what the face cannot reach.
  bool holds_beyond(const Features& of, int point, const MovingState& sa, const MovingState& sb) const;
  /// Whether two edges have a contact, and have these points.
  bool holds_edges(const Features& of, int i, int j) const;
  /// Whether a's point i has a contact in the plane of b, the facet of this face.
  bool over(FeatureId face, int i) const;
  /// Whether a contact with an edge or a vertex of the ground holds the points along its normal.
  bool along_rim(const Vec3& direction, int i, int j, const MovingState& state_of_a) const;
  /// Whether one holds the points now, along a normal that drifts from the direction.
  Hold drifts_from(const Vec3& direction, int i, int j, const MovingState& sa, const MovingState& sb) const;
  bool of_b(FeatureId feature) const;

  const Moving3& a_;
  const Moving3& b_;
  CoreSearch by_;
  const TouchSearch& search_;
};

/// Which pieces of a core, its points and circles, contacts hold. Of a rim that is held at some places,
/// others may still touch; one that is held all round is held whole, because no half of it is without a
/// contact.
class HeldPieces {
 public:
  explicit HeldPieces(const Contactor3& shape);
  /// Adds a contact of a feature, or of one piece.
  void add(const ShapeFeature& feature);
  void add_piece(int piece);
  bool has(int piece) const { return pieces_[piece].contacts > 0; }
  bool has_in_part(int piece) const { return has(piece) && !pieces_[piece].whole; }
  int contacts_of(int piece) const { return pieces_[piece].contacts; }

 private:
  struct Piece {
    int contacts = 0;
    unsigned places = 0;  ///< that hold a rim, as bits
    bool whole = false;
  };
  const Contactor3& shape_;
  boost::container::small_vector<Piece, 8> pieces_;
};

/// What holds two contactors of which one has circles or is hollow, as a whole: contacts of the two bodies,
/// or of a with the feature of the ground that b belongs to.
class HeldPair {
 public:
  HeldPair(const Moving3& a, const Moving3& b, const TouchSearch& search);

  /// A face or cap, of a or of b, whose normal a direction is; index -1: it is none.
  struct Face {
    bool of_b = false;
    int index = -1;
  };
  /// Whether contacts hold the pair apart along a direction. `nearest`: the normal of all its contacts.
  /// `touches`: the two touch now. A contact with an edge or a vertex of the ground holds the facets about
  /// it; one of these may be nearest to another place of a: then they are apart, and the contact has another
  /// normal.
  Hold hold(const Vec3& direction, const Face& of, const Vec3& nearest, bool touches) const;
  /// How the gap of held pieces counts at time t.
  Counts counts(double t) const;
  /// A contact is a spring.
  bool yields() const { return yields_; }
  const HeldPieces& of_a() const { return of_a_; }
  const HeldPieces& of_b() const { return of_b_; }

 private:
  void add(const HeldContact& contact);
  bool has(const Face& face) const;

  const Moving3& a_;
  const Moving3& b_;
  const TouchSearch& search_;
  HeldPieces of_a_, of_b_;
  bool any_ = false;
  bool in_plane_ = false;  ///< a contact is in the plane of b, a facet
  bool opened_ = false;    ///< one has just opened
  bool yields_ = false;
};

}  // namespace flyrock
