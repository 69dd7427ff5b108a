#include "geometry/volume_properties.h"

#include <catch2/catch.hpp>

using namespace flyrock;

TEST_CASE("volume and inertia of a box, wherever it lies") {
  const Vec3 size(1, 0.6, 0.4);
  for (const Vec3& at : {Vec3(0, 0, 0), Vec3(1e3, -2e3, 5e2)}) {
    Contactor3 box = Contactor3::box(size);
    box.change_frame(-at, {});
    const VolumeProperties p = volume_properties({box});
    CHECK(p.volume == Approx(0.24).epsilon(1e-12));
    CHECK((p.centroid - at).norm() <= 1e-12 * (1 + at.norm()));
    CHECK((p.inertia - 0.24 / 12 * Eigen::Matrix3d(Vec3(0.52, 1.16, 1.36).asDiagonal())).norm() < 1e-12);
  }
}

TEST_CASE("a regular tetrahedron has the inertia of a ball") {
  const Contactor3 shape = Contactor3::polyhedron({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                                                  {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}});
  const VolumeProperties p = volume_properties({shape});
  const double edge = std::sqrt(8.0);
  CHECK(p.volume == Approx(edge * edge * edge / (6 * std::sqrt(2.0))).epsilon(1e-14));
  CHECK((p.inertia - p.volume * edge * edge / 20 * Eigen::Matrix3d::Identity()).norm() < 1e-13);
}

TEST_CASE("two balls on a rod: the theorem of parallel axes") {
  const double r = 0.1;
  const VolumeProperties p =
      volume_properties({Contactor3::sphere(r, {1, 0, 0}), Contactor3::sphere(r, {3, 0, 0})});
  const double volume = 4.0 / 3.0 * pi * r * r * r;
  CHECK(p.volume == Approx(2 * volume));
  CHECK((p.centroid - Vec3(2, 0, 0)).norm() < 1e-15);
  CHECK(p.inertia(0, 0) == Approx(2 * volume * 0.4 * r * r));
  CHECK(p.inertia(1, 1) == Approx(2 * volume * (0.4 * r * r + 1)));
}

TEST_CASE("a pill has the volume and inertia of a sum over small cubes, wherever it lies") {
  const double radius = 0.2, length = 0.5, cell = 0.004;
  double volume = 0;
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (double x = -radius + cell / 2; x < radius; x += cell)
    for (double y = -radius + cell / 2; y < radius; y += cell)
      for (double z = -radius - length / 2 + cell / 2; z < radius + length / 2; z += cell) {
        const double beyond = std::max(0.0, std::abs(z) - length / 2);
        if (x * x + y * y + beyond * beyond > radius * radius) continue;
        volume += cell * cell * cell;
        second += cell * cell * cell * Vec3(x, y, z) * Vec3(x, y, z).transpose();
      }
  const Rotation3 turn = Rotation3::from_vector({0.4, -0.3, 1.1});
  const Vec3 half = turn * Vec3(0, 0, length / 2);
  for (const Vec3& at : {Vec3(0, 0, 0), Vec3(1e3, -2e3, 5e2)}) {
    const VolumeProperties p = volume_properties({Contactor3::pill(at - half, at + half, radius)});
    CHECK(p.volume == Approx(pi * radius * radius * (length + 4.0 / 3 * radius)).epsilon(1e-9));
    CHECK(p.volume == Approx(volume).epsilon(2e-3));
    CHECK((p.centroid - at).norm() < 1e-12 * (1 + at.norm()));
    const Eigen::Matrix3d r = turn.matrix();
    const Eigen::Matrix3d inertia = second.trace() * Eigen::Matrix3d::Identity() - second;
    CHECK((p.inertia - r * inertia * r.transpose()).norm() < 3e-3 * inertia.norm());
  }
  // About the axis: half of m r^2 for the cylinder, two fifths for the half-spheres.
  const VolumeProperties p = volume_properties({Contactor3::pill({0, 0, 0}, {0, 0, length}, radius)});
  const double square = radius * radius;
  CHECK(p.inertia(2, 2) == Approx(pi * square * square * (length / 2 + 8.0 / 15 * radius)).epsilon(1e-12));
}

TEST_CASE("the principal frame of a turned box is that of the box") {
  const Rotation3 turn = Rotation3::from_vector({0.4, -0.3, 1.1});
  Contactor3 box = Contactor3::box({1, 0.6, 0.4});
  box.change_frame(Vec3::Zero(), turn.inverse());  // the box turned by `turn`
  const VolumeProperties p = volume_properties({box});
  const PrincipalFrame frame = principal_frame(p.inertia);
  CHECK((frame.moments - 0.24 / 12 * Vec3(0.52, 1.16, 1.36)).norm() < 1e-14);
  CHECK(frame.rotation.matrix().determinant() == Approx(1));
  box.change_frame(Vec3::Zero(), frame.rotation);
  const Eigen::Matrix3d off = volume_properties({box}).inertia - Eigen::Matrix3d(frame.moments.asDiagonal());
  CHECK(off.norm() < 1e-15);
  CHECK((principal_frame(volume_properties({Contactor3::box({1, 0.6, 0.4})}).inertia).rotation.matrix() -
         Eigen::Matrix3d::Identity())
            .norm() == 0);
}
