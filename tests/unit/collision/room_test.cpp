// Hollow disks, hollow cylinders and half spaces against all shapes: gaps against dense sampling, and times
// of impact against the gap along the path.

#include <catch2/catch.hpp>
#include <random>

#include "collision/pairs.h"
#include "geometry/cone.h"
#include "geometry/hull.h"
#include "indexed.h"
#include "math/farthest_on_ellipse.h"
#include "nearest_contact.h"
#include "samples.h"
#include "scratch.h"

using namespace flyrock;

namespace room_test {

namespace {

struct RoomDice {
  std::mt19937 rng{23};
  double operator()(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(rng);
  }
  Vec3 direction() {
    std::normal_distribution<double> normal;
    return Vec3(normal(rng), normal(rng), normal(rng)).normalized();
  }
  Vec2 direction_2d() {
    const double angle = (*this)(0, 2 * pi);
    return {std::cos(angle), std::sin(angle)};
  }
  /// A third of the attitudes is along the axes.
  Rotation3 rotation() {
    const double kind = (*this)(0, 3);
    if (kind < 0.5) return {};
    if (kind < 1) return Rotation3::from_vector(0.5 * pi * Vec3::Unit(static_cast<int>((*this)(0, 2.999))));
    return Rotation3::from_vector((*this)(0, pi) * direction());
  }
};

std::vector<Contactor2> solids_2d(double size) {
  return {Contactor2::disk(0.4 * size), Contactor2::disk(0.3 * size, Vec2(0.2, 0.1) * size),
          Contactor2::wall({-0.5 * size, 0}, {0.5 * size, 0.1 * size}, 0.1 * size),
          Contactor2::polygon({Vec2(-0.5, -0.4) * size, Vec2(0.6, -0.3) * size, Vec2(0.2, 0.5) * size})};
}

std::vector<Contactor3> solids_3d(RoomDice& dice, double size) {
  std::vector<Vec3> points;
  for (int i = 0; i < 9; ++i) points.push_back(size * dice(0.3, 0.5) * dice.direction());
  Contactor3 part = Contactor3::cylinder(0.3 * size, 0.4 * size);  // of a compound
  part.change_frame(Vec3(0.1, -0.2, 0.1) * size, dice.rotation());
  return {Contactor3::sphere(0.4 * size),
          Contactor3::pill({0, 0, -0.4 * size}, {0, 0, 0.4 * size}, 0.15 * size),
          Contactor3::box(Vec3(0.8, 0.5, 0.6) * size),
          convex_hull(points),
          Contactor3::cylinder(0.45 * size, 0.3 * size),
          Contactor3::cylinder(0.4 * size, 0.01 * size),
          cone(0.4 * size, 0.6 * size),
          part};
}

/// The places of a shape that may be nearest to a wall: its points, and many of each rim.
std::vector<Vec3> sampled(const Contactor3& shape, int of_rim) {
  std::vector<Vec3> places = shape.points;
  for (const Contactor3::Circle& circle : shape.circles) {
    const Vec3 first = circle.axis.unitOrthogonal(), second = circle.axis.cross(first);
    for (int i = 0; i < of_rim; ++i) {
      const double angle = 2 * pi * i / of_rim;
      places.push_back(circle.centre + circle.radius * (std::cos(angle) * first + std::sin(angle) * second));
    }
  }
  return places;
}

/// The gap of one place, written once more in the frame of the room.
double gap_of(const Placed3& room, const Vec3& place) {
  const Vec3 local = room.pose.r.inverse(place - room.pose.x);
  return room.shape.form == Form::half_space ? local.z()
                                             : room.shape.circles[0].radius - local.head<2>().norm();
}

double sampled_gap(const Placed3& room, const Placed3& other, const std::vector<Vec3>& places) {
  double least = 1e300;
  for (const Vec3& place : places) least = std::min(least, gap_of(room, other.pose * place));
  return least - other.shape.radius;
}
double sampled_gap(const Placed2& room, const Placed2& other) {
  double farthest = 0;
  for (const Vec2& point : other.shape.points)
    farthest = std::max(farthest, (other.pose * point - room.pose.x).norm());
  return room.shape.radius - farthest - other.shape.radius;
}

}  // namespace

TEST_CASE("the farthest places of an ellipse are local maxima, and the first one is the greatest") {
  RoomDice dice;
  for (int i = 0; i < 3000; ++i) {
    const double flat = i % 3 == 0 ? 0 : dice(0, 1);
    const Vec2 axis = dice.direction_2d(), centre = (i % 5 == 0 ? 0 : dice(0, 2)) * dice.direction_2d();
    const double turn = dice(0, 2 * pi);
    const Vec2 b0 = flat * perpendicular(axis);
    const Vec2 a = std::cos(turn) * axis + std::sin(turn) * b0,
               b = -std::sin(turn) * axis + std::cos(turn) * b0;
    const auto at = [&](double angle) { return (centre + std::cos(angle) * a + std::sin(angle) * b).norm(); };
    const auto found = farthest_on_ellipse(centre, a, b);
    double most = 0;
    int maxima = 0;
    constexpr int places = 720;
    for (int k = 0; k < places; ++k) {
      const double step = 2 * pi / places, value = at(k * step);
      most = std::max(most, value);
      maxima += value > at((k - 1) * step) + 1e-12 && value > at((k + 1) * step) + 1e-12;
    }
    CHECK(at(found[0]) >= most - 1e-12);
    CHECK(at(found[0]) < most + 1e-4);
    for (const double angle : found) CHECK(at(angle) >= std::max(at(angle - 1e-4), at(angle + 1e-4)) - 1e-12);
    if (maxima == 2) CHECK(found.size() == 2);
  }
}

namespace {

void try_placements(int placements) {
  RoomDice dice;
  for (const Contactor3& room_shape : {Contactor3::hollow_cylinder(1, 1.1, 2), Contactor3::half_space()})
    for (const Contactor3& other_shape : solids_3d(dice, 1)) {
      const std::vector<Vec3> places = sampled(other_shape, 2000);
      int wrong = 0;
      for (int i = 0; i < placements; ++i) {
        const Placed3 room{room_shape, {dice(0, 2) * dice.direction(), dice.rotation()}};
        const Placed3 other{other_shape, {room.pose * (dice(0, 0.4) * dice.direction()), dice.rotation()}};
        std::vector<ContactPoint<3>> contacts;
        const bool turned = i % 2;
        if (turned)
          body_contacts(scratch(), room, indexed(other, 3), 10, contacts);
        else
          body_contacts(scratch(), indexed(other, 3), room, 10, contacts);
        REQUIRE_FALSE(contacts.empty());
        const ContactPoint<3>& c = nearest_of(contacts);
        const Vec3 inward = turned ? -c.normal : c.normal;
        const double sampled = sampled_gap(room, other, places);
        bool good = std::abs(c.gap - sampled) < 1e-5 && c.gap <= sampled + 1e-12;
        for (const ContactPoint<3>& each : contacts) {
          const Vec3 in = turned ? -each.normal : each.normal;
          good = good && std::abs(in.norm() - 1) < 1e-12;
          good = good && std::abs(gap_of(room, each.point + 0.5 * each.gap * in) - each.gap) < 1e-12;
          const double again = turned ? feature_gap(scratch(), room, each.feature, other, each.against)
                                      : feature_gap(scratch(), other, each.feature, room, each.against);
          good = good && std::abs(again - each.gap) < 1e-12;
        }
        // Against the normal the gap opens as fast as the shape moves, or more slowly if another place is as
        // near.
        const Placed3 moved{other_shape, {other.pose.x + 1e-6 * inward, other.pose.r}};
        const double opens = sampled_gap(room, moved, places) - sampled;
        const auto is_near = [&](const ContactPoint<3>& each) { return each.gap < c.gap + 2e-6; };
        const bool is_alone = std::count_if(contacts.begin(), contacts.end(), is_near) == 1;
        good = good && opens < 1e-6 + 2e-9 && (opens > 0 || !is_alone);
        wrong += !good;
      }
      CHECK(wrong == 0);
    }
  for (const Contactor2& other_shape : solids_2d(1)) {
    const Contactor2 room_shape = Contactor2::hollow_disk(1, 1.1);
    int wrong = 0;
    for (int i = 0; i < placements; ++i) {
      const Placed2 room{room_shape, {dice(0, 2) * dice.direction_2d(), Rotation2::from_angle(dice(0, 6))}};
      const Placed2 other{
          other_shape, {room.pose.x + dice(0, 0.4) * dice.direction_2d(), Rotation2::from_angle(dice(0, 6))}};
      std::vector<ContactPoint<2>> contacts;
      body_contacts(scratch(), indexed(other, 3), room, 10, contacts);
      REQUIRE_FALSE(contacts.empty());
      const ContactPoint<2>& c = nearest_of(contacts);
      wrong += std::abs(c.gap - sampled_gap(room, other)) > 1e-12 ||
               std::abs(feature_gap(scratch(), other, c.feature, room, c.against) - c.gap) > 1e-12;
    }
    CHECK(wrong == 0);
  }
}

}  // namespace

TEST_CASE("rooms at random placements have the gap, the normal and the places of dense sampling") {
  try_placements(samples(400));
}

TEST_CASE("rooms at 10,000 placements of each shape have them too", "[heavy]") { try_placements(10000); }

TEST_CASE("nothing that is shot in a room passes through its wall, and it touches at gap 0") {
  RoomDice dice;
  constexpr double end = 0.05;
  int touches = 0;
  std::uint64_t iterations = 0;
  for (const double size : {0.02, 0.5})
    for (const Contactor3& room_shape : {Contactor3::hollow_cylinder(1, 1.1, 400), Contactor3::half_space()})
      for (const Contactor3& other_shape : solids_3d(dice, size)) {
        const std::vector<Vec3> places = sampled(other_shape, 100);
        int wrong = 0;
        for (int i = 0; i < 25; ++i) {
          Motion3 still, shot;
          still.rotation = i % 3 ? FreeRotation({1, 1, 0.7}, dice.rotation(), dice(0, 20) * dice.direction())
                                 : FreeRotation({1, 1, 0.7}, {}, dice(0, 500) * Vec3::UnitZ());
          const Rotation3 start = still.turn(0).rotation;
          shot.x = start * Vec3(0.1, -0.05, 0.3);
          if (room_shape.form == Form::half_space) shot.x = start * Vec3(0, 0, dice(0.5, 2));
          shot.v = (i % 4 ? dice(0, 300) : dice(0, 3)) * dice.direction();
          shot.a = {0, 0, -9.81};
          shot.rotation = FreeRotation({1, 1.2, 1.5}, dice.rotation(), dice(0, 500) * dice.direction());
          TouchSearch search;
          search.size = other_shape.bound;
          search.iterations = &iterations;
          const auto touch =
              i % 2 ? time_of_contact<3>(scratch(), {room_shape, still}, {other_shape, shot}, end, search)
                    : time_of_contact<3>(scratch(), {other_shape, shot}, {room_shape, still}, end, search);
          touches += touch.has_value();
          const auto gap = [&](double t) {
            return sampled_gap({room_shape, {still.position(t), still.turn(t).rotation}},
                               {other_shape, {shot.position(t), shot.turn(t).rotation}}, places);
          };
          bool good = true;
          for (int k = 0; k < 40; ++k) good = good && gap(touch.value_or(end) * k / 40) > -1e-9;
          if (touch)
            good = good && std::abs(gap(*touch)) < (!other_shape.circles.empty() ? 2e-3 * size : 1e-9);
          wrong += !good;
        }
        CHECK(wrong == 0);
      }
  CHECK(touches > 300);
  CHECK(iterations < 800 * 60);
  for (const double size : {0.02, 0.5})
    for (const Contactor2& other_shape : solids_2d(size)) {
      const Contactor2 room_shape = Contactor2::hollow_disk(1, 1.1);
      int wrong = 0;
      for (int i = 0; i < 50; ++i) {
        Motion2 still, shot;
        still.w = dice(-500, 500);
        shot.x = 0.3 * dice.direction_2d();
        shot.v = dice(0, 300) * dice.direction_2d();
        shot.a = {0, -9.81};
        shot.angle = dice(0, 6);
        shot.w = dice(-500, 500);
        TouchSearch search;
        search.size = other_shape.bound;
        const auto touch =
            i % 2 ? time_of_contact<2>(scratch(), {room_shape, still}, {other_shape, shot}, end, search)
                  : time_of_contact<2>(scratch(), {other_shape, shot}, {room_shape, still}, end, search);
        const auto gap = [&](double t) {
          return sampled_gap({room_shape, {}},
                             {other_shape, {shot.position(t), Rotation2::from_angle(shot.angle_at(t))}});
        };
        bool good = true;
        for (int k = 0; k < 40; ++k) good = good && gap(touch.value_or(end) * k / 40) > -1e-9;
        if (touch) good = good && std::abs(gap(*touch)) < 1e-9;
        wrong += !good;
      }
      CHECK(wrong == 0);
    }
}

TEST_CASE("a room does not touch the ground, another room, or what is outside") {
  const Contactor2 room = Contactor2::hollow_disk(1, 1.05);
  const Contactor2 disk = Contactor2::disk(0.3);
  std::vector<ContactPoint<2>> contacts;
  body_contacts<2>(scratch(), {room, {}}, {room, {{0.5, 0}, {}}}, 1, contacts);
  body_contacts<2>(scratch(), {disk, {{1.2, 0}, {}}}, {room, {}}, 1, contacts);
  CHECK(contacts.empty());
  Motion2 motion, still;
  motion.x = {5, 0};
  motion.v = {-10, 0};
  const auto touch = time_of_contact<2>(scratch(), {disk, motion}, {room, still}, 1, {});
  REQUIRE(touch);  // it comes in through the wall, and touches from inside on the far side
  CHECK(*touch == Approx((5 + 0.7) / 10));
  const Contactor3 tube = Contactor3::hollow_cylinder(1, 1.05, 2), ball = Contactor3::sphere(0.3);
  std::vector<ContactPoint<3>> in_space;
  body_contacts<3>(scratch(), {ball, {{0.7, 0, 1.1}, {}}}, {tube, {}}, 1, in_space);
  CHECK(in_space.empty());  // beyond the end
  body_contacts<3>(scratch(), {ball, {{0.7, 0, 0.9}, {}}}, {tube, {}}, 1, in_space);
  REQUIRE(in_space.size() == 1);
  CHECK(in_space[0].gap == Approx(0).margin(1e-15));
  Motion3 through, rest;
  through.x = {0.5, 0, -5};
  through.v = {0.05, 0, 10};  // through the tube within 0.4 to 0.6 s, and out of it
  CHECK_FALSE(time_of_contact<3>(scratch(), {ball, through}, {tube, rest}, 3, {}));
}

}  // namespace room_test
