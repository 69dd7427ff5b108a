// Walls and rounded polygons against all shapes in 2D and the profile: contacts, gaps and times of impact
// against a search over the outlines of the cores.

#include <catch2/catch.hpp>

#include "collision/ground/terrain_2d.h"
#include "collision/pairs.h"
#include "indexed.h"
#include "nearest_contact.h"
#include "scratch.h"
#include "unit/collision/shots.h"

using namespace flyrock;

namespace grown_hull_test {

namespace {

double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double s =
      along.squaredNorm() > 0 ? std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0) : 0;
  return (p - a - s * along).norm();
}

double distance_of_segments(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const bool cross_ab = cross(Vec2(b - a), Vec2(c - a)) * cross(Vec2(b - a), Vec2(d - a)) < 0;
  const bool cross_cd = cross(Vec2(d - c), Vec2(a - c)) * cross(Vec2(d - c), Vec2(b - c)) < 0;
  if (cross_ab && cross_cd) return 0;
  return std::min({distance_to_segment(a, c, d), distance_to_segment(b, c, d), distance_to_segment(c, a, b),
                   distance_to_segment(d, a, b)});
}

/// The distance of a place from the outline of a core.
double distance_to(const Placed2& placed, const Vec2& p) {
  double least = 1e300;
  for (int i = 0; i < placed.count(); ++i)
    least = std::min(least, distance_to_segment(p, placed.point(i), placed.point((i + 1) % placed.count())));
  return least;
}

/// The gap of two hulls whose cores do not overlap: the least of all pairs of segments of their outlines.
double searched_gap(const Placed2& one, const Placed2& other) {
  double least = 1e300;
  for (int k = 0; k < one.count(); ++k)
    for (int i = 0; i < other.count(); ++i)
      least = std::min(least, distance_of_segments(one.point(k), one.point((k + 1) % one.count()),
                                                   other.point(i), other.point((i + 1) % other.count())));
  return least - one.shape.radius - other.shape.radius;
}

bool is_inside(const Placed2& polygon, const Vec2& p) {
  if (polygon.count() < 3) return false;
  for (int e = 0; e < polygon.count(); ++e)
    if (polygon.outside(e, p) > 0) return false;
  return true;
}

Contactor2 wall_of(double length, double radius) {
  return Contactor2::wall({-length / 2, 0}, {length / 2, 0}, radius);
}

Contactor2 rounded_polygon() {
  return Contactor2::hull({{-0.4, -0.2}, {0.3, -0.3}, {0.45, 0.15}, {-0.1, 0.3}}, 0.15);
}

std::vector<Contactor2> grown() { return {wall_of(0.9, 0.2), rounded_polygon()}; }

std::vector<Contactor2> others() {
  return {Contactor2::disk(0.3), wall_of(1.1, 0.15), rounded_polygon(),
          Contactor2::polygon({{-0.4, -0.3}, {0.5, -0.2}, {0.1, 0.4}}),
          Contactor2::polygon({{-0.4, -0.3}, {0.4, -0.3}, {0.4, 0.3}, {-0.4, 0.3}})};
}

}  // namespace

TEST_CASE(
    "grown hulls and other shapes at 10,000 random placements have the gap, normal and places of a search") {
  Dice dice(7);
  const Contactor2 hull = grown()[static_cast<std::size_t>(GENERATE(0, 1))];
  for (const Contactor2& other : others()) {
    int wrong = 0;
    for (int tested = 0; tested < 10000;) {
      const Placed2 a{hull, {dice(0.1, 1.4) * dice.direction<2>(), dice.rotation<2>()}};
      const Placed2 b{other, {Vec2::Zero(), dice.rotation<2>()}};
      const double gap = searched_gap(a, b);
      if (gap <= 1e-6 - hull.radius - other.radius || is_inside(b, a.point(0)) || is_inside(a, b.point(0)))
        continue;
      const bool turned = ++tested % 2;
      Contacts<2> contacts;
      if (turned)
        body_contacts(scratch(), b, indexed(a, 1), 10, contacts);
      else
        body_contacts(scratch(), a, indexed(b, 1), 10, contacts);
      REQUIRE_FALSE(contacts.empty());
      const ContactPoint<2>& c = nearest_of(contacts);
      const Vec2 on_a = c.point + (turned ? -0.5 : 0.5) * c.gap * c.normal, on_b = 2 * c.point - on_a;
      const double known = turned ? feature_gap(scratch(), b, c.feature, a, c.against)
                                  : feature_gap(scratch(), a, c.feature, b, c.against);
      wrong += std::abs(c.gap - gap) > 1e-12 || std::abs(known - gap) > 1e-12 ||
               std::abs(distance_to(a, on_a) - hull.radius) > 1e-12 ||
               std::abs(distance_to(b, on_b) - other.radius) > 1e-12;
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("a wall that lies flush on a wall or a polygon has two contacts, and one where they stand askew") {
  const Contactor2 wall = wall_of(1, 0.2),
                   box = Contactor2::polygon({{-0.5, -1}, {0.5, -1}, {0.5, 0.2}, {-0.5, 0.2}});
  for (const Contactor2* below : {&wall, &box}) {
    const double height = 0.4;
    for (const double x : {0.0, 0.3}) {
      Contacts<2> contacts;
      body_contacts<2>(scratch(), {wall, {{x, height}, {}}}, {*below, {}, 1}, 1e-6, contacts);
      REQUIRE(contacts.size() == 2);
      std::sort(contacts.begin(), contacts.end(),
                [](const auto& a, const auto& b) { return a.point.x() < b.point.x(); });
      CHECK((contacts[0].point - Vec2(x - 0.5, 0.2)).norm() < 1e-12);
      CHECK((contacts[1].point - Vec2(0.5, 0.2)).norm() < 1e-12);
      for (const auto& c : contacts) CHECK((c.normal - Vec2::UnitY()).norm() < 1e-12);
    }
    Contacts<2> contacts;
    body_contacts<2>(scratch(), {wall, {{0, height + 0.5 * std::sin(0.1)}, Rotation2::from_angle(0.1)}},
                     {*below, {}, 1}, 1e-3, contacts);
    REQUIRE(contacts.size() == 1);
    CHECK(std::abs(contacts[0].gap) < 1e-12);
  }
  // End to end
  Contacts<2> contacts;
  body_contacts<2>(scratch(), {wall, {{1.5, 0}, {}}}, {wall, {}, 1}, 1, contacts);
  REQUIRE(contacts.size() == 1);
  CHECK(contacts[0].gap == Approx(0.1).epsilon(1e-12));
  CHECK((contacts[0].normal - Vec2::UnitX()).norm() < 1e-12);
}

namespace {

Profile rugged() {
  Profile profile;
  profile.points = {{-9, 1},     {-4, 1},   {-1, 0},    {-0.6, 0.8}, {0, 0.9},
                    {0.3, -0.5}, {1, -0.5}, {1.2, 0.1}, {4, -0.4},   {9, -0.4}};
  profile.part.assign(profile.points.size() - 1, 0);
  profile.parts = {""};
  return profile;
}

/// The gap to the profile; the core must be above it.
double searched_gap(const Placed2& hull, const Terrain2& terrain) {
  double least = 1e300;
  for (int k = 0; k < hull.count(); ++k)
    for (int i = 0; i < terrain.segments(); ++i)
      least = std::min(least, distance_of_segments(hull.point(k), hull.point((k + 1) % hull.count()),
                                                   terrain.start(i), terrain.end(i)));
  return least - hull.shape.radius;
}

bool is_below(const Placed2& hull, const Terrain2& terrain) {
  return searched_gap(hull, terrain) <= 1e-6 - hull.shape.radius ||
         hull.point(0).y() < terrain.height(hull.point(0).x());
}

}  // namespace

TEST_CASE("grown hulls at 10,000 random places over a profile have the gap of a search") {
  Dice dice(7);
  const Contactor2 hull = grown()[static_cast<std::size_t>(GENERATE(0, 1))];
  const Terrain2 terrain{rugged()};
  int wrong = 0;
  for (int tested = 0; tested < 10000;) {
    const Placed2 placed{hull, {{dice(-5, 5), dice(-0.5, 2)}, dice.rotation<2>()}};
    if (is_below(placed, terrain)) continue;
    const double gap = searched_gap(placed, terrain);
    if (gap > 0.4) continue;
    ++tested;
    Contacts<2> contacts;
    terrain_contacts(scratch(), placed, terrain, 0.4, 0, contacts);
    if (contacts.empty()) {
      ++wrong;
      continue;
    }
    const ContactPoint<2>& c = nearest_of(contacts);
    const Vec2 on_hull = c.point + 0.5 * c.gap * c.normal;
    wrong += std::abs(c.gap - gap) > 1e-12 ||
             std::abs(feature_gap(scratch(), placed, c.feature, terrain, c.against) - gap) > 1e-12 ||
             std::abs(distance_to(placed, on_hull) - hull.radius) > 1e-12;
  }
  CHECK(wrong == 0);
}

TEST_CASE("no shot hull passes through another shape or the profile, and it touches at gap 0") {
  Dice dice(7);
  const Contactor2 hull = grown()[static_cast<std::size_t>(GENERATE(0, 1))];
  constexpr double end = 0.03;
  TouchSearch search;
  search.size = hull.bound;
  std::uint64_t iterations = 0;
  search.iterations = &iterations;
  int wrong = 0, touches = 0;
  for (const Contactor2& other : others())
    for (int i = 0; i < 300; ++i) {
      const Motion2 motion = shot(dice);
      Motion2 spinning;
      spinning.w = dice(-500, 500);
      if (i % 2) spinning.v = dice(0, 100) * dice.direction<2>();
      const auto touch = i % 3
                             ? time_of_contact<2>(scratch(), {hull, motion}, {other, spinning}, end, search)
                             : time_of_contact<2>(scratch(), {other, spinning}, {hull, motion}, end, search);
      touches += touch.has_value();
      wrong += !agrees(touch, end, 1e-10, 1e-10,
                       [&](double t) { return searched_gap(at(hull, motion, t), at(other, spinning, t)); });
    }
  const Terrain2 terrain{rugged()};
  for (int i = 0; i < 1000; ++i) {
    Motion2 motion = shot(dice);
    motion.x.y() = std::abs(motion.x.y()) + 2;
    const auto touch = time_of_contact<2>(scratch(), {hull, motion}, terrain, end, search);
    touches += touch.has_value();
    wrong += !agrees(touch, end, 1e-10, 1e-10,
                     [&](double t) { return searched_gap(at(hull, motion, t), terrain); });
  }
  CHECK(wrong == 0);
  CHECK(touches > 500);
  CHECK(iterations < 30 * 2200);
}

namespace {

/// A place at a height `over` ground that falls by `fall` [rad] beyond a corner at x = 0, `along` it from
/// there.
Vec2 over_fall(double fall, double over, double along) {
  return {along * std::cos(fall) + over * std::sin(fall), -along * std::sin(fall) + over * std::cos(fall)};
}

}  // namespace

TEST_CASE("a disk past a convex corner has the gap to the segment that it is over") {
  constexpr double radius = 0.5, fall = 0.1;
  Profile profile;
  profile.points = {{-10, 0}, {0, 0}, {10, -10 * std::tan(fall)}};
  profile.part = {0, 0};
  profile.parts = {""};
  const Terrain2 terrain(profile);
  const Contactor2 disk = Contactor2::disk(radius);
  const FeatureId corner = corner_id(2);  // the first point is the end of the level ground before the profile
  const auto gap = [&](const Vec2& centre) {
    return feature_gap(scratch(), Placed2{disk, {centre, {}}}, vertex_id(0, 0), terrain, corner);
  };
  CHECK(gap({-0.2, radius + 0.01}) == Approx(0.01).epsilon(1e-12));
  CHECK(gap(over_fall(fall, radius + 0.01, 0.2)) == Approx(0.01).epsilon(1e-12));
  CHECK(gap((radius + 0.01) * Vec2(std::sin(fall / 2), std::cos(fall / 2))) == Approx(0.01).epsilon(1e-12));
}

}  // namespace grown_hull_test
