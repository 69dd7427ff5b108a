#include <catch2/catch.hpp>

#include "math/space.h"

using namespace flyrock;

TEST_CASE("the exponential map and its inverse") {
  const Vec3 turns[] = {{0, 0, 0}, {1e-9, 0, 0}, {0, 3e-5, 0}, {0.1, -0.2, 0.3}, {0, 0, 3.1}, {-2, 1, 1}};
  for (const Vec3& v : turns) {
    const Rotation3 r = Rotation3::from_vector(v);
    CHECK((r.vector() - v).norm() <= 4e-16 * (1 + 10 * v.norm()));
    CHECK((r.matrix() * r.matrix().transpose() - Eigen::Matrix3d::Identity()).norm() < 2e-15);
    const double angle = v.norm();
    if (angle == 0) continue;
    const Eigen::Matrix3d expected = Eigen::AngleAxisd(angle, v / angle).toRotationMatrix();
    CHECK((r.matrix() - expected).norm() < 1e-15 * (1 + angle));
  }
  // More than half a turn comes back as the shorter one.
  CHECK((Rotation3::from_vector({0, 0, 4}).vector() - Vec3(0, 0, 4 - 2 * pi)).norm() < 1e-15);
}

TEST_CASE("the frame of a contact is right-handed as n, t, s with s x t = n, and +x on level ground") {
  CHECK(contact_frame(Vec3(0, 0, 1)).col(1) == Vec3(1, 0, 0));
  CHECK(contact_frame(Vec2(0, 1)).col(1) == Vec2(1, 0));
  for (int i = 0; i <= 40; ++i)
    for (int j = 0; j < 40; ++j) {
      const double z = -1 + i / 20.0, r = std::sqrt(1 - z * z), angle = 2 * pi * j / 40;
      const Vec3 n(r * std::cos(angle), r * std::sin(angle), z);
      const Eigen::Matrix3d frame = contact_frame(n);
      CHECK((frame.transpose() * frame - Eigen::Matrix3d::Identity()).norm() < 1e-14);
      CHECK((frame.col(2).cross(frame.col(1)) - n).norm() < 1e-14);
    }
  // Continuous through upright and hanging faces.
  for (const Vec3& n : {Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, -1)})
    for (const Vec3& nudge : {Vec3(1e-9, 0, 0), Vec3(0, 1e-9, 0), Vec3(0, 0, 1e-9), Vec3(0, 0, -1e-9)})
      CHECK((contact_frame(Vec3((n + nudge).normalized())) - contact_frame(n)).norm() < 1e-8);
}

TEST_CASE("a turn in 2D by a series is that by sine and cosine, to rounding") {
  double worst = 0;
  for (int i = -4000; i <= 4000; ++i) {
    const double start = 0.7 * i, by = i * 1.5e-4 + (i % 7 == 0 ? 3.0 : 0.0);
    const Rotation2 turned = Rotation2::from_angle(start).turned(by);
    const double sine = std::sin(start) * std::cos(by) + std::cos(start) * std::sin(by);
    const double cosine = std::cos(start) * std::cos(by) - std::sin(start) * std::sin(by);
    worst = std::max({worst, std::abs(turned.s - sine), std::abs(turned.c - cosine)});
  }
  CHECK(worst < 4e-16);
}
