#pragma once
// What the engine asks about a contactor and its opponent, which is another contactor or the ground:
//   contacts    the contact points whose gap is at most `reach`
//   gap         the gap of one known contact
//   touch       the time of impact
// The two opponents have the same three functions, so that the benchmark needs only one loop.

#include <algorithm>
#include <optional>
#include <vector>

#include "collision/geometry.h"
#include "collision/pairs.h"
#include "scratch.h"

namespace flyrock {

/// A contactor near its opponent, how both move from there, and the deepest contact. The ground has no pose
/// and no motion.
template <int D>
struct Placement {
  typename Geometry<D>::Pose pose, pose_of_opponent;
  typename Geometry<D>::Motion motion, motion_of_opponent;
  ContactPoint<D> contact;
};

template <int D>
class OpponentBody {
 public:
  using Contactor = typename Geometry<D>::Contactor;

  explicit OpponentBody(Contactor contactor) : contactor_(std::move(contactor)) {}

  /// Whether the other contactor touches this one from inside.
  bool is_hollow() const { return flyrock::is_hollow(contactor_.form); }
  /// The size of the smaller body that moves [m]. The time of impact is exact up to a gap of 1e-12 of it.
  double size(const Contactor& of) const {
    return is_hollow() ? of.bound : std::min(of.bound, contactor_.bound);
  }

  void contacts(const Contactor& of, const Placement<D>& at, double reach,
                std::vector<ContactPoint<D>>& out) const {
    body_contacts(scratch(), Placed<D>{of, at.pose}, Placed<D>{contactor_, at.pose_of_opponent}, reach, out);
  }
  double gap(const Contactor& of, const Placement<D>& at) const {
    return feature_gap(scratch(), Placed<D>{of, at.pose}, at.contact.feature,
                       Placed<D>{contactor_, at.pose_of_opponent}, at.contact.against, at.contact.normal);
  }
  std::optional<double> touch(const Contactor& of, const Placement<D>& at, double end,
                              const TouchSearch& search) const {
    return time_of_contact<D>(scratch(), {of, at.motion}, {contactor_, at.motion_of_opponent}, end, search);
  }

 private:
  Contactor contactor_;
};

template <int D>
class OpponentGround {
 public:
  using Contactor = typename Geometry<D>::Contactor;
  using Terrain = typename Geometry<D>::Terrain;

  explicit OpponentGround(Terrain terrain) : terrain_(std::move(terrain)) {}

  bool is_hollow() const { return false; }
  double size(const Contactor& of) const { return of.bound; }

  void contacts(const Contactor& of, const Placement<D>& at, double reach,
                std::vector<ContactPoint<D>>& out) const {
    constexpr double no_turn = 0;
    terrain_contacts(scratch(), Placed<D>{of, at.pose}, terrain_, reach, no_turn, out);
  }
  double gap(const Contactor& of, const Placement<D>& at) const {
    return feature_gap(scratch(), Placed<D>{of, at.pose}, at.contact.feature, terrain_, at.contact.against,
                       at.contact.normal);
  }
  std::optional<double> touch(const Contactor& of, const Placement<D>& at, double end,
                              const TouchSearch& search) const {
    return time_of_contact<D>(scratch(), {of, at.motion}, terrain_, end, search);
  }

 private:
  Terrain terrain_;
};

}  // namespace flyrock
