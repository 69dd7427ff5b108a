#pragma once
// What pictures of a motion show: the surfaces of rocks, and the fixed and driven bodies of a trial.

#include <array>
#include <string>

#include "record/link_type.h"
#include "record/observe.h"

namespace flyrock {

/// A corner of a face of a contactor, in the body's frame: the origin is the centre of mass. In 3D a face is
/// a polygon, counter-clockwise as seen from outside; in 2D a contactor is one face. A disk or a sphere is
/// one corner, its centre, with a radius; a wall or a pill is the two ends of its axis with a radius. The
/// wall of a hollow disk or cylinder is cut into pieces, each a face; of a mesh each triangle is one. A
/// square of 1 m stands for a half space.
struct SurfaceCorner {
  int contactor = 0, face = 0;  ///< from 0; corners of a face follow each other
  Vec3 place = Vec3::Zero();    ///< m
  double radius = 0;            ///< m
};

/// A body whose motion is prescribed: at rest, or, at the time t after the start,
///   x = x_0 + v t + a t^2 / 2,  R = exp(t w) R_0
/// in the frame of the world, with the velocity v and the spin w of `start`. A body whose velocity changes
/// over time is several of them, each from its start until that of the next one.
struct Fixture {
  std::string body;
  BodyState start;
  std::array<double, 4> turn = {1, 0, 0, 0};  ///< 3D: attitude R_0, as in TrajectoryPoint
  Vec3 acceleration = Vec3::Zero();           ///< m/s2, a
};

/// A corner of the surface of a fixture, in the frame of the body.
struct FixtureCorner {
  std::string body;
  SurfaceCorner corner;
};

/// A link, and where it holds two bodies: in their frames, or in the world where `rock` is -1 and no body is
/// named.
struct DrawnLink {
  struct End {
    int rock = -1;              ///< of the trial; -1: a body whose motion is prescribed, or the terrain
    std::string body;           ///< `terrain` for the terrain
    Vec3 place = Vec3::Zero();  ///< m
  };
  std::string link;
  LinkType type = LinkType::rod;
  End a, b;
};

}  // namespace flyrock
