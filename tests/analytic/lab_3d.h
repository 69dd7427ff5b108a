#pragma once
// Bodies and grounds in 3D for tests with closed forms.

#include "analytic/lab.h"

namespace flyrock::lab {

/// A plane through the origin that falls by the angle `slope` towards +x turned by `azimuth` about the
/// vertical.
inline Plane plane(double slope = 0, double azimuth = 0) {
  Plane ground;
  ground.normal = {std::sin(slope) * std::cos(azimuth), std::sin(slope) * std::sin(azimuth), std::cos(slope)};
  return ground;
}

/// The direction of steepest descent of plane(slope, azimuth).
inline Vec3 down(double slope, double azimuth = 0) {
  return {std::cos(slope) * std::cos(azimuth), std::cos(slope) * std::sin(azimuth), -std::sin(slope)};
}

inline Body<3> sphere(double radius, double mass, const Vec3& at, const Vec3& velocity = Vec3::Zero(),
                      const Vec3& spin = Vec3::Zero()) {
  Body<3> body = make_body({Contactor3::sphere(radius)}, 0, mass);
  body.x = at;
  body.v = velocity;
  body.w = spin;
  return body;
}

/// A box whose own axes point along `along`, across and `up`.
inline Body<3> box(const Vec3& size, double mass, const Vec3& at, const Vec3& along = Vec3::UnitX(),
                   const Vec3& up = Vec3::UnitZ()) {
  Body<3> body = make_body({Contactor3::box(size)}, 0, mass);
  Eigen::Matrix3d axes;
  axes << along, up.cross(along), up;
  body.x = at;
  body.attitude = Rotation3(axes) * body.attitude.rotation;
  return body;
}

struct Bench3 : BenchOf<3> {
  Bench3(TerrainShape3 ground, Material& material, const WorldSettings& settings = {},
         const Vec3& gravity = {0, 0, -9.81})
      : BenchOf<3>(Terrain3(std::move(ground)), material, settings, gravity) {}
};

}  // namespace flyrock::lab
