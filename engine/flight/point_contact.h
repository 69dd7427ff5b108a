#pragma once
// The contacts of a point with the ground: the laws of the material are those of bodies.

#include <span>

#include "flight/face.h"
#include "record/observe.h"
#include "world/body.h"
#include "world/pair_laws.h"

namespace flyrock {

/// The contacts of one point. Laws are given for each part of the terrain; a part without one has neither
/// restitution nor friction.
template <int D>
class PointContact {
 public:
  PointContact(const Body<D>& body, const typename Geometry<D>::Terrain& terrain, const Vec<D>& origin,
               std::span<PairLaws* const> laws)
      : body_(body), terrain_(terrain), origin_(origin), laws_(laws) {}

  /// The face as an impact meets it: tilted by the roughness of its material.
  struct Tilted {
    Vec<D> normal;
    std::array<double, 2> angle = {};  ///< rad, as Impact::tilt
  };
  /// An impact: the velocities [m/s] along the tilted normal, which the laws act on, and along the face.
  struct Bounce {
    Tilted face;
    Vec<D> before, after;
  };
  /// The point at `at` strikes a face with the velocity v [m/s], which the impact changes.
  Bounce strike(const Face<D>& face, double time, const Vec<D>& at, Vec<D>& v);
  /// The energy [J] that it gives the point.
  double energy_change(const Bounce& bounce) const {
    return 0.5 * body_.mass * (bounce.after.squaredNorm() - bounce.before.squaredNorm());
  }
  /// The last impact as results describe it.
  Impact record(const Face<D>& face, double time, const Vec<D>& at, const Bounce& bounce) const;

  /// The friction of a point on a face [m/s2] that is pressed to it by `press` [m/s2]. Where the material
  /// has a rolling law, mu is at most mu_r/R; `rolls` tells whether this is the smaller one.
  struct Grip {
    double slides = 0, holds = 0;
    bool rolls = false;
    bool constant = true;  ///< false: the laws may answer otherwise as the state changes
  };
  Grip grip(const Face<D>& face, double time, const Vec<D>& at, const Vec<D>& v, double press) {
    return grip(face, time, at, v, press, body_.mass * press);
  }
  /// The same at a touch without restitution, where `press` is the approach [m/s] and a force is not known.
  Grip grip_at_touch(const Face<D>& face, double time, const Vec<D>& at, const Vec<D>& v, double press) {
    slipped_ = {};
    return grip(face, time, at, v, press, ContactState::none);
  }

  int impacts() const { return impacts_; }

 private:
  Grip grip(const Face<D>& face, double time, const Vec<D>& at, const Vec<D>& v, double press, double force);
  void set_read_fields(ContactState& state, const ContactReads& reads) const;
  ContactState state_of(const Face<D>& face, const PairLaws& laws, const Vec<D>& normal, double time,
                        const Vec<D>& at, const Vec<D>& v) const;
  /// Counts the impact and draws what is drawn at each.
  Tilted begin_impact(const Face<D>& face, PairLaws* laws, const Vec<D>& v);
  Tilted tilted(const Face<D>& face, const PairLaws& laws, const Vec<D>& v) const;

  const Body<D>& body_;
  const typename Geometry<D>::Terrain& terrain_;
  Vec<D> origin_;
  std::span<PairLaws* const> laws_;
  ContactState state_;  ///< of the last impact whose laws read it
  ContactHistory memory_{};
  int memory_part_ = -1;
  int impacts_ = 0;
  double age_ = 0, since_ = 0;  ///< s
  /// The way slipped since the contact closed, by the trapezoidal rule over the calls of grip.
  struct Slipped {
    double length = 0;  ///< m
    double time = 0;    ///< s, of the last call
    double speed = 0;   ///< m/s, at that time
  } slipped_;
};

}  // namespace flyrock
