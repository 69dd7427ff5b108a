#pragma once
// Which contacts hold two contactors apart when a search for their time of impact begins. In a step the
// solver holds their points, and the search passes over them; in flight they have just opened, and count from
// gap 0.
//
// World::held_in_step and World::held fill TouchSearch::held. Here are the questions of pairs of cores (Held)
// and of contactors with circles (HeldPair) in 3D. Balls, the plane, clouds and hollow walls have few
// features that may touch: they ask TouchSearch::holds by their ids.

#include <boost/container/small_vector.hpp>

#include "collision/advance_3d.h"
#include "collision/pair_search.h"

namespace flyrock {

/// How a contact holds two points, or pieces of cores, apart along a direction. `exactly`: the direction is
/// the normal of the contact while the bodies move, because it belongs to the same face or the same two
/// edges. `for_now`: it is now, but it drifts from it.
enum class Hold { no, for_now, exactly };

/// Whether a contact with a facet of the ground is in the plane of another facet.
bool is_in_plane(const HeldOnGround& held, const Facet& facet, double size);

/// The contacts of TouchSearch::held that concern the pair a, b, as points of the two.
class Held {
 public:
  /// The features to which a direction belongs, and with which it turns: a face or another feature of one of
  /// the two, or an edge of each, whose cross product it is.
  struct Features {
    std::optional<FeatureId> of_a, of_b;
  };

  /// A ball has only one contact with a convex contactor, and so has the end of a pill: the feature there
  /// does not matter.
  Held(const Moving3& a, const Moving3& b, CoreSearch by, const TouchSearch& search)
      : a_(a), b_(b), by_(by), search_(search) {}

  /// Whether a contact keeps the point i of a and the point j of b apart along a direction from b to a.
  Hold hold(const Vec3& direction, const Features& of, int i, int j, const MovingState& state_of_a,
            const MovingState& state_of_b) const;
  /// Whether one holds the points exactly along a direction of one of the two; `point`: of the other.
  bool holds_on(const Features& of, int point) const;
  /// Whether a's face has a contact with the ground.
  bool is_on_ground(int face) const;

 private:
  /// Where a feature is: on a face, on the line of an edge, or at a point. World frame, metres.
  struct Place {
    FeatureKind kind;
    Vec3 at, along, normal;
  };
  static Place place_of(const Moving3& c, FeatureId feature, const MovingState& s);
  static Vec3 normal_of(const Place& a, const Place& b);
  bool agrees(const Vec3& direction, const Place& a, const Place& b) const;
  bool holds(FeatureId feature, FeatureId against) const;
  bool holds_edges(const Features& of, int i, int j) const;
  bool over(FeatureId face, int i) const;
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

/// What holds two contactors of which one has circles, as a whole: contacts of the two bodies, or of a with
/// the feature of the ground that b belongs to.
class HeldPair {
 public:
  HeldPair(const Moving3& a, const Moving3& b, const TouchSearch& search);

  bool any() const { return any_; }
  /// A contact is in the plane of b, a facet.
  bool in_plane() const { return in_plane_; }
  /// The contacts are solved in the step: none has just opened.
  bool are_solved() const { return are_solved_; }
  /// A contact is a spring.
  bool yields() const { return yields_; }
  const HeldPieces& of_a() const { return of_a_; }
  const HeldPieces& of_b() const { return of_b_; }
  /// Whether a face or cap has a contact. That of a facet has one if a contact is in its plane.
  bool has_face_of_a(int face) const;
  bool has_face_of_b(int face) const;

 private:
  template <class Contact>
  void add(const Contact& contact);

  const Moving3& a_;
  const Moving3& b_;
  const TouchSearch& search_;
  HeldPieces of_a_, of_b_;
  bool any_ = false, in_plane_ = false, are_solved_, yields_ = false;
};

}  // namespace flyrock
