// What a contactor is, and that the table of pairs has the same answer in either order.
#include <catch2/catch.hpp>

#include "collision/pairs.h"
#include "dice.h"
#include "geometry/cone.h"
#include "geometry/mesh.h"
#include "scratch.h"

using namespace flyrock;

namespace form_test {

Mesh tetrahedron() {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  mesh.part = {0, 0, 0, 0};
  mesh.parts = {""};
  return mesh;
}

double least_gap(const Contacts<3>& contacts) {
  double least = 1e300;
  for (const ContactPoint<3>& c : contacts) least = std::min(least, c.gap);
  return least;
}

}  // namespace form_test

using namespace form_test;

TEST_CASE("the function that makes a contactor says what it is") {
  CHECK(Contactor2::disk(1).form == Form::ball);
  CHECK(Contactor2::wall({0, 0}, {1, 0}, 0.1).form == Form::pill);
  CHECK(Contactor2::polygon({{0, 0}, {1, 0}, {0, 1}}).form == Form::hull);
  CHECK(Contactor2::hollow_disk(1, 2).form == Form::hollow);
  CHECK(Contactor2::outline({{0, 0}, {0, 1}, {1, 0}}).form == Form::outline);
  CHECK(Contactor3::sphere(1).form == Form::ball);
  CHECK(Contactor3::pill({0, 0, 0}, {1, 0, 0}, 0.1).form == Form::pill);
  CHECK(Contactor3::box({1, 1, 1}).form == Form::hull);
  CHECK(Contactor3::cylinder(1, 1).form == Form::smooth);
  CHECK(cone(1, 1).form == Form::smooth);
  CHECK(Contactor3::hollow_cylinder(1, 2, 1).form == Form::hollow);
  CHECK(Contactor3::half_space().form == Form::half_space);
  CHECK(Contactor3::solid(tetrahedron()).form == Form::outline);
  CHECK(Contactor3::cloud(tetrahedron()).form == Form::cloud);
}

TEST_CASE("two contactors that touch do so in either order, by contacts, gaps and times of impact") {
  const std::vector<Contactor3> shapes = {
      Contactor3::sphere(0.4),          Contactor3::pill({-0.2, 0, 0}, {0.2, 0, 0}, 0.3),
      Contactor3::box({0.6, 0.6, 0.6}), Contactor3::hollow_cylinder(5, 6, 20),
      Contactor3::solid(tetrahedron()), Contactor3::cylinder(0.3, 0.5),
      Contactor3::half_space(),         Contactor3::cloud(tetrahedron())};
  REQUIRE(shapes.size() == form_count<3>);
  const Pose3 below, above{{0.1, 0.15, 1.6}, Rotation3::from_vector({0.1, 0.2, 0.3})};
  Motion3 rests, falls;
  rests.rotation = GivenRotation{};
  falls.rotation = GivenRotation{.start = above.r};
  falls.x = above.x;
  falls.v = {0, 0, -1};
  for (const Contactor3& upper : shapes)
    for (const Contactor3& lower : shapes) {
      INFO(static_cast<int>(upper.form) << " above " << static_cast<int>(lower.form));
      const bool touch = can_touch(upper.form, lower.form);
      CHECK(touch == can_touch(lower.form, upper.form));
      const Placed3 a{upper, above, 1}, b{lower, below, 2};
      Contacts<3> one, other;
      body_contacts(scratch(), a, b, 20, one);
      body_contacts(scratch(), b, a, 20, other);
      if (!touch) CHECK((one.empty() && other.empty()));
      CHECK(one.size() == other.size());
      if (!one.empty()) CHECK(least_gap(one) == Approx(least_gap(other)).margin(1e-9));
      for (const ContactPoint<3>& c : one)
        CHECK(feature_gap(scratch(), a, c.feature, b, c.against, c.normal) ==
              Approx(feature_gap(scratch(), b, c.against, a, c.feature, Vec3(-c.normal))).margin(1e-9));
      const TouchSearch search{.held = {}};
      const auto first = time_of_contact<3>(scratch(), {upper, falls, 1}, {lower, rests, 2}, 3, search);
      const auto mirrored = time_of_contact<3>(scratch(), {lower, rests, 2}, {upper, falls, 1}, 3, search);
      CHECK(first.has_value() == mirrored.has_value());
      if (!touch) CHECK_FALSE(first);
      if (first && mirrored) CHECK(*first == Approx(*mirrored).margin(1e-9));
    }
}

TEST_CASE("a contactor with others in its body has the same gaps to an outline as alone") {
  const Contactor3 cylinder = Contactor3::cylinder(0.3, 0.1), solid = Contactor3::solid(tetrahedron());
  const Pose3 turned{{0.2, -0.1, 0.3}, Rotation3::from_vector({0.4, -0.7, 1.1})};
  Dice dice(5);
  int rims = 0;
  for (int n = 0; n < 400; ++n) {
    const Pose3 pose{turned * Vec3(dice(-0.2, 0.8), dice(-0.2, 0.8), dice(-0.2, 0.8)),
                     Rotation3::from_vector({dice(-3, 3), dice(-3, 3), dice(-3, 3)})};
    Contacts<3> alone, second;
    body_contacts(scratch(), {cylinder, pose}, {solid, turned}, 0.05, alone);
    body_contacts(scratch(), {cylinder, pose, 1}, {solid, turned}, 0.05, second);
    REQUIRE(alone.size() == second.size());
    for (std::size_t i = 0; i < alone.size(); ++i) {
      const auto gap = [&](int index, const ContactPoint<3>& c) {
        return feature_gap<3>(scratch(), Placed3{cylinder, pose, index}, c.feature, Placed3{solid, turned},
                              c.against, c.normal);
      };
      CHECK(gap(1, second[i]) == gap(0, alone[i]));
      rims +=
          kind_of(alone[i].feature) == FeatureKind::edge && kind_of(alone[i].against) != FeatureKind::face;
    }
  }
  CHECK(rims > 20);
}
