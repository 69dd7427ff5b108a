#include <catch2/catch.hpp>
#include <random>
#include <set>

#include "collision/broad_phase.h"
#include "collision/ground/terrain_3d.h"
#include "collision/manifold_reduction.h"
#include "collision/pairs.h"
#include "geometry/hull.h"
#include "indexed.h"
#include "samples.h"
#include "scratch.h"

using namespace flyrock;

namespace {

const Terrain3 level{Plane{}};
const Contactor3 cube = Contactor3::box({1, 1, 1});

Contacts<3> between(const Placed3& a, const Placed3& b, double reach) {
  Contacts<3> contacts;
  body_contacts(scratch(), indexed(a, 1), indexed(b, 2), reach, contacts);
  for (const auto& c : contacts) {
    CHECK(c.normal.norm() == Approx(1).epsilon(1e-14));
    CHECK(contactor_of(c.feature) == 1);
    CHECK(contactor_of(c.against) == 2);
    // Of faces that lean against each other, as deep overlap makes them, the edges have a normal of their
    // own.
    if (c.gap > -0.011)
      CHECK(feature_gap(scratch(), a, c.feature, b, c.against) == Approx(c.gap).margin(1e-9));
  }
  return contacts;
}

std::set<std::pair<FeatureId, FeatureId>> ids(const Contacts<3>& contacts) {
  std::set<std::pair<FeatureId, FeatureId>> set;
  for (const auto& c : contacts) set.insert({c.feature, c.against});
  return set;
}

}  // namespace

TEST_CASE("a sphere and a box on a plane") {
  const Plane slope{{0, 0, 1}, Vec3(0, 1, 2).normalized(), {""}};
  const Terrain3 ground{slope};
  const Contactor3 ball = Contactor3::sphere(0.5);
  Contacts<3> contacts;
  terrain_contacts<3>(scratch(), {ball, {Vec3(3, 0, 1) + 0.4 * slope.normal, {}}}, ground, 0, 0, contacts);
  REQUIRE(contacts.size() == 1);
  CHECK(contacts[0].gap == Approx(-0.1));
  CHECK((contacts[0].point - (Vec3(3, 0, 1) - 0.05 * slope.normal)).norm() < 1e-15);

  contacts.clear();
  const Placed3 box{cube, {Vec3(0, 0, 0.5 + 1e-7), {}}};
  terrain_contacts(scratch(), indexed(box, 3), level, 1e-6, 0, contacts);
  REQUIRE(contacts.size() == 4);
  for (const auto& c : contacts) {
    CHECK(c.gap == Approx(1e-7).epsilon(1e-6));
    CHECK(feature_gap(scratch(), box, c.feature, level, c.against) == c.gap);
    CHECK(contactor_of(c.feature) == 3);
  }
  contacts.clear();
  terrain_contacts(scratch(), indexed(box, 3), level, 1e-8, 0, contacts);
  CHECK(contacts.empty());
}

TEST_CASE(
    "an edge in a notch of a ridge touches both of its legs, also when it has moved along one of them") {
  Mesh mesh;
  mesh.parts = {""};
  for (const double y : {-1, 0, 1})
    for (const double x : {-1, 0, 1}) mesh.vertices.push_back({x, y, 0.5 * std::abs(x) - 0.8 * std::abs(y)});
  for (const int i : {0, 1, 3, 4}) {
    mesh.triangles.push_back({i, i + 1, i + 3});
    mesh.triangles.push_back({i + 1, i + 4, i + 3});
  }
  mesh.part.assign(mesh.triangles.size(), 0);
  const Terrain3 saddle{mesh};
  const Rotation3 on_edge = Rotation3::from_vector({0, pi / 4, 0});
  for (const double moved : {0.0, 1e-9, -3e-7, 5e-7}) {
    const Placed3 box{cube, {Vec3(moved, 0, std::sqrt(0.5) + 0.5 * std::abs(moved)), on_edge}};
    Contacts<3> contacts;
    terrain_contacts(scratch(), indexed(box, 3), saddle, 1e-6, 0, contacts);
    INFO("moved by " << moved);
    REQUIRE(contacts.size() == 2);
    CHECK(contacts[0].normal.dot(contacts[1].normal) == Approx(0.6));
    for (const auto& c : contacts) {
      const bool is_left = c.normal.x() > 0;
      CHECK(c.gap == Approx(std::max(0.0, is_left ? moved : -moved) * c.normal.z()).margin(1e-15));
    }
  }
}

TEST_CASE("of many contacts the deepest and the widest four are kept, and share the area") {
  Contacts<3> contacts;
  for (int i = 0; i < 12; ++i) {
    const double angle = 2 * pi * i / 12;
    contacts.push_back({{std::cos(angle), std::sin(angle), 0},
                        Vec3::UnitZ(),
                        i == 5 ? -1e-3 : 0,
                        static_cast<FeatureId>(i),
                        0});
  }
  keep_four(contacts, 0);
  CHECK(ids(contacts) == std::set<std::pair<FeatureId, FeatureId>>{{2, 0}, {5, 0}, {8, 0}, {11, 0}});
  // The dodecagon has 3 m2, the square that is left 2 m2; a second place at each corner changes nothing.
  for (const ContactPoint<3>& contact : contacts) CHECK(contact.dropped_area == Approx(0.25));
  for (std::size_t i = 0; i < 4; ++i) contacts.push_back(contacts[i]);
  keep_four(contacts, 0);
  for (const ContactPoint<3>& contact : contacts) CHECK(contact.dropped_area == Approx(0).margin(1e-15));

  const std::vector<Vec3> rectangle{{0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {0, 2, 0}, {1, 1, 0}};
  for (std::size_t i = 0; i < 4; ++i) CHECK(tributary_area(rectangle, i, Vec3::UnitZ()) == Approx(1.5));
  CHECK(tributary_area(rectangle, 4, Vec3::UnitZ()) == 0);
  const std::vector<Vec3> triangle{{0, 0, 0}, {3, 0, 0}, {0, 2, 0}};
  for (std::size_t i = 0; i < 3; ++i) CHECK(tributary_area(triangle, i, Vec3::UnitZ()) == Approx(1));
  CHECK(tributary_area(std::span(triangle).first(2), 0, Vec3::UnitZ()) == 0);
}

TEST_CASE("a sphere meets the face, edge, vertex and inside of a box") {
  const Contactor3 ball = Contactor3::sphere(0.5);
  struct Case {
    Vec3 centre, normal;
    double gap;
    FeatureKind kind;
  };
  const double d = 0.25 / std::sqrt(2.0), e = 0.25 / std::sqrt(3.0);
  for (const Case& c : {Case{{0, 0, 0.9}, {0, 0, 1}, -0.1, FeatureKind::face},
                        Case{{0.5 + d, 0.1, 0.5 + d}, {1, 0, 1}, -0.25, FeatureKind::edge},
                        Case{{-0.5 - e, 0.5 + e, 0.5 + e}, {-1, 1, 1}, -0.25, FeatureKind::vertex},
                        Case{{0, 0.4, 0.1}, {0, 1, 0}, -0.6, FeatureKind::face}}) {
    const Rotation3 turn = Rotation3::from_vector({0.2, 0.5, -1});
    const Placed3 sphere{ball, {turn * c.centre, {}}}, box{cube, {Vec3::Zero(), turn}};
    const Contacts<3> there = between(sphere, box, 0), back = between(box, sphere, 0);
    REQUIRE(there.size() == 1);
    REQUIRE(back.size() == 1);
    CHECK(there[0].gap == Approx(c.gap));
    CHECK((there[0].normal - turn * c.normal.normalized()).norm() < 1e-14);
    CHECK((back[0].normal + there[0].normal).norm() < 1e-14);
    CHECK(kind_of(there[0].against) == c.kind);
  }
}

TEST_CASE("a box on a box: four contacts that keep their ids while it slides and turns a little") {
  const Placed3 below{cube, {Vec3::Zero(), {}}};
  for (const double angle : {0.0, 0.3, 0.785}) {
    const Rotation3 turn = Rotation3::from_vector({0, 0, angle});
    const auto at = [&](double shift, const Vec3& tilt) {
      return between({cube, {Vec3(0.3 + shift, 0.2, 1 - 1e-8), Rotation3::from_vector(tilt) * turn}}, below,
                     1e-6);
    };
    const Contacts<3> contacts = at(0, Vec3::Zero());
    REQUIRE(contacts.size() == 4);
    for (const auto& c : contacts) {
      CHECK(c.gap == Approx(-1e-8));
      CHECK((c.normal - Vec3::UnitZ()).norm() < 1e-12);
    }
    CHECK(ids(at(1e-6, {0, 0, 1e-7})) == ids(contacts));
    CHECK(ids(at(-1e-6, {1e-8, -1e-8, 0})) == ids(contacts));
  }
}

TEST_CASE(
    "boxes with flush sides that lean on each other are as deep as their separation, and nowhere deeper") {
  const Contactor3 slab = Contactor3::box({0.1, 0.5, 1});
  std::mt19937 generator(1);
  const auto uniform = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(generator);
  };
  const auto tiny = [&] { return (uniform(0, 1) < 0.5 ? -1 : 1) * std::pow(10, uniform(-13, -6)); };
  for (int k = 0; k < samples(2000); ++k) {
    const double lean = uniform(0.01, 1.5);
    const Rotation3 turn = Rotation3::from_vector({tiny(), 0, tiny()}) * Rotation3::from_vector({0, lean, 0});
    // The upper front edge of the one that leans touches the other's face x = -0.05.
    const Vec3 edge = turn * Vec3(0.05, 0, 0.5);
    const Placed3 leans{slab, {Vec3(-0.05, tiny(), uniform(-0.4, 0.4)) - edge, turn}}, stands{slab, {}};
    Contacts<3> contacts;
    body_contacts(scratch(), indexed(leans, 1), indexed(stands, 2), 5e-7, contacts);
    double deepest = 1;
    for (const auto& c : contacts) deepest = std::min(deepest, c.gap);
    double highest = 1;  // of the vertices of the edge over the face
    for (const double side : {-0.25, 0.25})
      highest = std::min(highest, -0.05 - (leans.pose * Vec3(0.05, side, 0.5)).x());
    CHECK(contacts.size() <= 4);
    CHECK(deepest == Approx(highest).margin(1e-8));
  }
}

TEST_CASE("two edges meet in one contact, a vertex and a face in one") {
  const Placed3 roof{cube, {Vec3::Zero(), Rotation3::from_vector({pi / 4, 0, 0})}};  // an edge along x on top
  const double top = std::sqrt(0.5);
  const Placed3 keel{cube, {Vec3(0, 0, 2 * top - 0.01), Rotation3::from_vector({0, pi / 4, 0})}};
  const Contacts<3> crossed = between(keel, roof, 0);
  REQUIRE(crossed.size() == 1);
  CHECK(crossed[0].gap == Approx(-0.01));
  CHECK((crossed[0].normal - Vec3::UnitZ()).norm() < 1e-12);
  CHECK((crossed[0].point - Vec3(0, 0, top - 0.005)).norm() < 1e-12);
  CHECK(kind_of(crossed[0].feature) == FeatureKind::edge);

  const Rotation3 on_tip =
      Rotation3::from_vector(std::acos(std::sqrt(1.0 / 3)) * Vec3(1, -1, 0).normalized());
  const Contacts<3> tip =
      between({cube, {Vec3(0.1, 0.1, 0.5 + std::sqrt(0.75) + 0.001), on_tip}}, {cube, {}}, 0.01);
  REQUIRE(tip.size() == 1);
  CHECK(tip[0].gap == Approx(0.001));
  CHECK(kind_of(tip[0].feature) == FeatureKind::vertex);
  CHECK(kind_of(tip[0].against) == FeatureKind::face);
}

TEST_CASE("polyhedra thrown together: overlap gives contacts, their push along the normal parts them") {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> draw(-1, 1);
  const auto any = [&] { return Vec3(draw(generator), draw(generator), draw(generator)); };
  const bool boxes = GENERATE(true, false);
  std::vector<Vec3> points;
  for (int i = 0; i < 14; ++i) points.push_back(0.7 * any().normalized());
  const Contactor3 first = boxes ? Contactor3::box({1, 0.8, 0.3}) : convex_hull(points);
  for (Vec3& p : points) p = 0.5 * any();
  const Contactor3 second = boxes ? cube : convex_hull(points);
  const auto along = [](const Placed3& shape, const Contactor3::Edge& e) {
    return Vec3(shape.point(e.end) - shape.point(e.start));
  };
  int met = 0;
  for (int k = 0; k < samples(3000); ++k) {
    const Placed3 a{first, {0.8 * any(), Rotation3::from_vector(3 * any())}};
    const Placed3 b{second, {Vec3::Zero(), Rotation3::from_vector(3 * any())}};
    Contacts<3> contacts;
    body_contacts(scratch(), indexed(a, 1), indexed(b, 2), 0, contacts);
    // By brute force: the greatest gap over all axes of faces and of pairs of edges, in both senses.
    std::vector<Vec3> axes;
    for (int f = 0; f < a.faces(); ++f) axes.push_back(a.normal(f));
    for (int f = 0; f < b.faces(); ++f) axes.push_back(b.normal(f));
    for (const auto& e : first.edges)
      for (const auto& f : second.edges) axes.push_back(along(a, e).cross(along(b, f)));
    std::vector<Vec3> a_points, b_points;
    for (int i = 0; i < a.count(); ++i) a_points.push_back(a.point(i));
    for (int i = 0; i < b.count(); ++i) b_points.push_back(b.point(i));
    double separation = -1e300;
    for (const Vec3& axis : axes) {
      const double length = axis.norm();
      if (length < 1e-6) continue;
      double a_low = 1e300, a_high = -1e300, b_low = 1e300, b_high = -1e300;
      for (const Vec3& point : a_points) {
        const double s = axis.dot(point) / length;
        a_low = std::min(a_low, s), a_high = std::max(a_high, s);
      }
      for (const Vec3& point : b_points) {
        const double s = axis.dot(point) / length;
        b_low = std::min(b_low, s), b_high = std::max(b_high, s);
      }
      separation = std::max({separation, a_low - b_high, b_low - a_high});
    }
    REQUIRE(contacts.empty() == (separation > 0));
    if (contacts.empty()) continue;
    ++met;
    double deepest = 0;
    for (const auto& c : contacts) deepest = std::min(deepest, c.gap);
    CHECK(deepest == Approx(separation).margin(1e-4));
    const Placed3 pushed{first, {a.pose.x + (-separation + 1e-3) * contacts[0].normal, a.pose.r}};
    contacts.clear();
    body_contacts(scratch(), indexed(pushed, 1), indexed(b, 2), 0, contacts);
    CHECK(contacts.empty());
  }
  CHECK(met > samples(200));
}

TEST_CASE("sort and sweep in 3D finds the pairs that brute force finds") {
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> draw(0, 1);
  SortAndSweep sweep;
  for (int round = 0; round < 5; ++round) {
    std::vector<Box3> boxes;
    for (int i = 0; i < 60; ++i) {
      const Vec3 low(draw(generator), draw(generator), draw(generator));
      boxes.push_back({low, low + 0.3 * Vec3(draw(generator), draw(generator), draw(generator))});
    }
    std::vector<std::pair<int, int>> expected;
    for (int i = 0; i < 60; ++i)
      for (int j = i + 1; j < 60; ++j)
        if (boxes[i].overlaps(boxes[j])) expected.push_back({i, j});
    CHECK(sweep.pairs(boxes) == expected);
  }
}

TEST_CASE(
    "a peak of the ground below a face of a cube is a contact, and none beside it, where it faces an edge") {
  Mesh pyramid;
  pyramid.parts = {""};
  pyramid.vertices = {{0, 0, 0}, {4, 0, -1}, {0, 4, -1}, {-4, 0, -1}, {0, -4, -1}};
  pyramid.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}};
  pyramid.part.assign(4, 0);
  const Terrain3 terrain{TerrainShape3(pyramid)};
  const double gap = 0.02;
  for (const double beside : {-0.002, 0.0, 0.002}) {
    std::vector<ContactPoint<3>> contacts;
    terrain_contacts(scratch(), Placed3{cube, {Vec3(0.5 + beside, 0, 0.5 + gap), {}}}, terrain, 0.1, 0,
                     contacts);
    const auto at_peak = std::count_if(contacts.begin(), contacts.end(), [](const ContactPoint<3>& c) {
      return c.point.head<2>().norm() < 1e-9;
    });
    CHECK(at_peak == (beside <= 0));
    for (const ContactPoint<3>& c : contacts) CHECK(c.gap == Approx(gap));
  }
}
