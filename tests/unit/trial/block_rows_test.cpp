#include "trial/block_rows.h"

#include <catch2/catch.hpp>
#include <cmath>

using namespace flyrock;

namespace block_rows_test {

constexpr double deg = pi / 180, gravity = 9.81;

Vec3 pole(double dip, double direction) {
  return {std::sin(dip * deg) * std::sin(direction * deg), std::sin(dip * deg) * std::cos(direction * deg),
          std::cos(dip * deg)};
}

/// A block on two joints, with a free face.
BlockPlan<3> on_two(const Vec3& first, const Vec3& second) {
  JointedRegion region;
  region.joints = {"bedding", "j2"};
  BlockPlan<3> plan;
  plan.faces = {{0, -first, 3}, {1, -second, 2}, {BlockPlan<3>::free, Vec3::UnitX(), 5}};
  plan.volume = 2;
  plan.region = std::make_shared<const JointedRegion>(region);
  return plan;
}

Body<3> body_of(double volume, double density) {
  Body<3> body;
  body.volume = volume;
  body.mass = density * volume;
  return body;
}

TEST_CASE("the row of a wedge has its mode, its joints, its direction and the factor of Hoek and Bray") {
  const BlockPlan<3> plan = on_two(pole(40, 130), pole(60, 220));
  const BlockRow row = block_row(plan, body_of(2, 2600), gravity, {.mu = std::tan(35 * deg)});
  CHECK(row.mode == BlockMode::wedge);
  CHECK(row.removable);
  CHECK(row.joints == "bedding, j2");
  CHECK(row.factor == Approx(1.063648).epsilon(1e-6));
  CHECK(row.trend / deg == Approx(155.848072).epsilon(1e-7));
  CHECK(row.plunge / deg == Approx(37.058295).epsilon(1e-7));
  CHECK(row.faces == 3);
  CHECK(row.free_area == 5);
  CHECK(row.joint_area == 5);
  const BlockRow unknown = block_row(plan, body_of(2, 2600), gravity, {.reason = "no factor with that law"});
  CHECK(std::isnan(unknown.factor));
  CHECK(unknown.reason == "no factor with that law");
}

TEST_CASE("cohesion, water, a push and a bolt enter the factor as by hand") {
  BlockPlan<3> plan = on_two(pole(40, 130), pole(60, 220));
  const double weight = 2 * 2600 * gravity, plunge = 37.058295 * deg;
  const double first = 0.673312 * weight, second = 0.242106 * weight, mu = std::tan(35 * deg);
  const JointStrength strength{.mu = mu, .cohesion = 1000};
  CHECK(block_row(plan, body_of(2, 2600), gravity, strength).factor ==
        Approx((1000 * 5 + mu * (first + second)) / (weight * std::sin(plunge))).epsilon(1e-5));
  plan.pressure = 500;
  CHECK(block_row(plan, body_of(2, 2600), gravity, strength).factor ==
        Approx((1000 * 5 + mu * (first - 1500 + second - 1000)) / (weight * std::sin(plunge))).epsilon(1e-5));
  plan.pressure = 0;
  plan.pull = -2000 * Vec3(std::cos(plunge) * std::sin(155.848072 * deg),
                           std::cos(plunge) * std::cos(155.848072 * deg), -std::sin(plunge));
  CHECK(block_row(plan, body_of(2, 2600), gravity, strength).factor ==
        Approx((1000 * 5 + mu * (first + second)) / (weight * std::sin(plunge) - 2000)).epsilon(1e-5));
  // In 2D a plane with a horizontal force, of a body that is 3 m thick.
  BlockPlan<2> slab;
  slab.faces = {{0, -Vec2(std::sin(35 * deg), std::cos(35 * deg)), 20.921},
                {BlockPlan<2>::free, Vec2::UnitX(), 5}};
  slab.volume = 76.6208;
  slab.push = Vec2(0.05, 0);
  slab.region = plan.region;
  Body<2> body;
  body.volume = 3 * slab.volume;
  body.mass = 26e3 / gravity * body.volume;
  const BlockRow row = block_row(slab, body, gravity, {.mu = std::tan(38 * deg)});
  CHECK(row.mode == BlockMode::plane);
  CHECK(row.factor == Approx(1.004965).epsilon(1e-6));
  CHECK(row.joint_area == Approx(3 * 20.921));
  CHECK(std::isnan(row.trend));
}

TEST_CASE("blocks that fall have the factor 0, and `only` fixes those that hold") {
  BlockPlan<3> plan = on_two(Vec3::UnitZ(), Vec3::UnitY());
  plan.moving = MovingBlocks::factor_below_1;
  const JointStrength strength{.mu = 0.6};
  const BlockRow held = block_row(plan, body_of(2, 2600), gravity, strength);
  CHECK(held.mode == BlockMode::held);
  CHECK(held.removable);
  CHECK(std::isnan(held.factor));
  CHECK_FALSE(moves(plan, held));
  plan.moving = MovingBlocks::removable;
  CHECK(moves(plan, held));
  BlockPlan<3> roof = on_two(-Vec3::UnitZ(), Vec3::UnitY());
  roof.moving = MovingBlocks::factor_below_1;
  const BlockRow falls = block_row(roof, body_of(2, 2600), gravity, strength);
  CHECK(falls.mode == BlockMode::falls);
  CHECK(falls.factor == 0);
  CHECK(falls.joints.empty());
  CHECK(falls.plunge / deg == Approx(90));
  CHECK(moves(roof, falls));
  roof.faces.push_back({BlockPlan<3>::ground, -Vec3::UnitZ(), 1});
  for (const Vec3& side : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0)}) roof.faces.push_back({0, side, 1});
  const BlockRow locked = block_row(roof, body_of(2, 2600), gravity, strength);
  CHECK(locked.mode == BlockMode::locked);
  CHECK_FALSE(locked.removable);
}

}  // namespace block_rows_test
