#include <catch2/catch.hpp>
#include <random>

#include "collision/ground/terrain_3d.h"
#include "collision/hull/separating_axis.h"
#include "collision/pairs.h"
#include "geometry/hull.h"
#include "samples.h"
#include "scratch.h"

using namespace flyrock;

namespace time_of_contact3_test {

namespace {

const Terrain3 level{Plane{}};
const Contactor3 cube = Contactor3::box({1, 1, 1});
const Contactor3 ball = Contactor3::sphere(0.5);
const Vec3 cube_moments = Vec3::Ones();

Motion3 thrown(const Vec3& x, const Vec3& v) {
  Motion3 motion;
  motion.x = x;
  motion.v = v;
  motion.a = {0, 0, -9.81};
  return motion;
}

Motion3 tumbling(const Vec3& x, const Vec3& v, const Vec3& moments, const Rotation3& rotation,
                 const Vec3& spin) {
  Motion3 motion = thrown(x, v);
  motion.rotation = FreeRotation(moments, rotation, spin);
  return motion;
}

double lowest(const Contactor3& shape, const Motion3& motion, double t) {
  const Turn turn = motion.turn(t);
  double low = 1e300;
  for (const Vec3& p : shape.points) low = std::min(low, (motion.position(t) + turn.rotation * p).z());
  return low;
}

/// The greatest separation of two polyhedra over all axes that can separate them.
double separation(const Contactor3& a, const Motion3& ma, const Contactor3& b, const Motion3& mb, double t) {
  const Placed3 pa{a, {ma.position(t), ma.turn(t).rotation}}, pb{b, {mb.position(t), mb.turn(t).rotation}};
  return std::max({best_face_axis(pa, pb).separation, best_face_axis(pb, pa).separation,
                   best_edge_axis(pa, pb).separation});
}

}  // namespace

TEST_CASE(
    "in space a pair released at gap 0 returns if it has a speed away, else it touches at once or never") {
  const FeatureId ground = feature_id(0, FeatureKind::face, 0);
  std::vector<HeldContact> held;
  for (int i = 0; i < 8; ++i) held.push_back({feature_id(0, FeatureKind::vertex, i), ground});
  TouchSearch search;
  search.held.list = held;
  for (const Contactor3* shape : {&ball, &cube}) {
    CHECK(
        time_of_contact<3>(scratch(), {*shape, thrown({0, 0, 0.5}, {1, 2, 3})}, level, 10, search).value() ==
        Approx(6 / 9.81).epsilon(shape == &ball ? 1e-15 : 1e-11));
    CHECK(
        time_of_contact<3>(scratch(), {*shape, thrown({0, 0, 0.5}, {1, 0, 0})}, level, 10, search).value() ==
        0);
    Motion3 weightless = thrown({0, 0, 0.5}, {1, 0, 0});
    weightless.a.setZero();
    CHECK_FALSE(time_of_contact<3>(scratch(), {*shape, weightless}, level, 10, search));
    TouchSearch solved = search;
    solved.held.are_solved = true;
    CHECK_FALSE(time_of_contact<3>(scratch(), {*shape, thrown({0, 0, 0.5}, {0, 0, -1})}, level, 10, solved));
  }
  // On a body that stays below.
  Motion3 below;
  below.x = {0, 0, -0.5};
  held.clear();
  int top = 0;
  while (cube.faces[top].normal.z() != 1) ++top;
  for (int i = 0; i < 8; ++i)
    held.push_back({feature_id(0, FeatureKind::vertex, i), feature_id(0, FeatureKind::face, top)});
  search.held.list = held;
  for (const Contactor3* shape : {&ball, &cube}) {
    const auto t =
        time_of_contact<3>(scratch(), {*shape, thrown({0.1, 0, 0.5}, {0, 0, 3})}, {cube, below}, 10, search);
    CHECK(t.value() == Approx(6 / 9.81).epsilon(1e-11));
    CHECK(time_of_contact<3>(scratch(), {*shape, thrown({0.1, 0, 0.5}, {0, 0, 0})}, {cube, below}, 10, search)
              .value() == 0);
  }
}

TEST_CASE("a tumbling box touches a plane with a gap of at most 1e-12 of its size, and not before") {
  const Vec3 size(1, 0.6, 0.4), moments(0.52, 1.16, 1.36);
  const Contactor3 box = Contactor3::box(size);
  TouchSearch search;
  search.size = box.bound;
  std::uint64_t iterations = 0;
  search.iterations = &iterations;
  const double spin = GENERATE(0.0, 0.7, 3.0, 40.0, 500.0);
  for (int k = 0; k < 20; ++k) {
    const Vec3 axis = Vec3(std::sin(k), 1, std::cos(2.0 * k)).normalized();
    const Motion3 motion = tumbling({0, 0, 3 + 0.1 * k}, {0.3 * k, 1, 2.0 - 0.2 * k}, moments,
                                    Rotation3::from_vector({0.1 * k, 0.2, 0.3}), spin * axis);
    iterations = 0;
    const auto t = time_of_contact<3>(scratch(), {box, motion}, level, 10, search);
    REQUIRE(t);
    CHECK(lowest(box, motion, *t) <= 2e-12);
    CHECK(lowest(box, motion, *t) >= -2e-13);
    for (int i = 1; i < 500; ++i) REQUIRE(lowest(box, motion, *t * i / 500.0) > 0);
    CHECK(iterations < 400);
  }
}

TEST_CASE("in space a grazing approach of 1e-6 rad is found") {
  const double angle = 1e-6;
  Motion3 motion;
  motion.v = {std::cos(angle), 0, -std::sin(angle)};
  motion.x = {-10, 0, 0.5 + 5e-6};
  const double expected = 5e-6 / std::sin(angle);
  CHECK(time_of_contact<3>(scratch(), {ball, motion}, level, 100, {}).value() ==
        Approx(expected).epsilon(1e-9));
  CHECK(time_of_contact<3>(scratch(), {cube, motion}, level, 100, {}).value() ==
        Approx(expected).epsilon(1e-6));
  const Contactor3 slab = Contactor3::box({100, 1, 1});
  Motion3 below;
  below.x = {0, 0, -0.5};
  CHECK(time_of_contact<3>(scratch(), {ball, motion}, {slab, below}, 100, {}).value() ==
        Approx(expected).epsilon(1e-6));
  CHECK(time_of_contact<3>(scratch(), {cube, motion}, {slab, below}, 100, {}).value() ==
        Approx(expected).epsilon(1e-6));
}

TEST_CASE("a ball and a cube of 1 cm at 300 m/s do not pass a plate of 1 mm") {
  const Contactor3 plate = Contactor3::box({1e-3, 2, 2});
  const Contactor3 pebble = Contactor3::sphere(0.005), die = Contactor3::box({0.01, 0.01, 0.01});
  Motion3 shot, still;
  shot.v = {300, 0, 0};
  for (int k = 0; k < 100; ++k) {
    shot.x = {-0.1 - 0.01 * k, 0.1, 0};
    TouchSearch search;
    search.size = 0.005;
    for (const Contactor3* shape : {&pebble, &die}) {
      const auto t = time_of_contact<3>(scratch(), {*shape, shot}, {plate, still}, 1, search);
      REQUIRE(t);
      CHECK(shot.position(*t).x() == Approx(-0.0055).margin(1e-13));
    }
  }
}

TEST_CASE("two balls meet on the exact root, a ball meets a box as the distance says") {
  const Motion3 a = thrown({-3, 0, 1}, {4, 0.1, 5}), b = thrown({3, 0.2, 1.5}, {-2, 0, 5});
  const double t = time_of_contact<3>(scratch(), {ball, a}, {ball, b}, 10, {}).value();
  CHECK((a.position(t) - b.position(t)).norm() == Approx(1).epsilon(1e-14));
  CHECK_FALSE(time_of_contact<3>(scratch(), {ball, a}, {ball, thrown({3, 1.9, 1.5}, {-2, 0, 5})}, 10, {}));
}

TEST_CASE("tumbling polyhedra touch with a gap of at most 1e-11, and not before") {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> draw(-1, 1);
  const auto any = [&] { return Vec3(draw(generator), draw(generator), draw(generator)); };
  const Vec3 moments(0.52, 1.16, 1.36);
  std::vector<Vec3> points;
  for (int i = 0; i < 12; ++i) points.push_back(0.6 * any().normalized());
  const Contactor3 box = GENERATE(true, false) ? Contactor3::box({1, 0.6, 0.4}) : convex_hull(points);
  TouchSearch search;
  std::uint64_t iterations = 0, most = 0;
  search.iterations = &iterations;
  const double spin = GENERATE(0.0, 3.0, 50.0);
  int met = 0, edges = 0;
  for (int k = 0; k < samples(200); ++k) {
    const Motion3 a = tumbling({-3, 0, 0}, Vec3(4, 0, 0) + 0.5 * any(), moments,
                               Rotation3::from_vector(3 * any()), spin * any());
    const Motion3 b = tumbling({3, 0, 0}, Vec3(-2, 0, 0) + 0.5 * any(), cube_moments,
                               Rotation3::from_vector(3 * any()), spin * any());
    iterations = 0;
    const auto t = time_of_contact<3>(scratch(), {box, a}, {cube, b}, 2, search);
    most = std::max(most, iterations);
    const double end = t.value_or(2);
    for (int i = 1; i < 200; ++i) REQUIRE(separation(box, a, cube, b, end * i / 200.0) > 0);
    if (!t) continue;
    ++met;
    const double gap = separation(box, a, cube, b, *t);
    CHECK(gap <= 1e-11);
    CHECK(gap >= -1e-12);
    const Placed3 pa{box, {a.position(*t), a.turn(*t).rotation}},
        pb{cube, {b.position(*t), b.turn(*t).rotation}};
    edges += best_edge_axis(pa, pb).separation >
             std::max(best_face_axis(pa, pb).separation, best_face_axis(pb, pa).separation);
  }
  CHECK(met > samples(70));
  CHECK(edges > samples(20));
  CHECK(most < 300);
}

TEST_CASE(
    "a box that slides over the edge of another is held by the solver's contacts and touches nothing new") {
  const double overhang = GENERATE(0.0, 0.3, 0.45), yaw = GENERATE(0.0, 0.4), spin = GENERATE(0.0, 1e-7, 2.0);
  Motion3 below, above;
  below.x = {0, 0, -0.5};
  above.x = {overhang, 0.1, 0.5};
  above.v = {1, 0.5, 0};
  above.rotation = GivenRotation{Rotation3::from_vector({0, 0, yaw}), {0, 0, spin}, Vec3::Zero()};
  std::vector<ContactPoint<3>> contacts;
  body_contacts<3>(scratch(), {cube, {above.x, above.turn(0).rotation}}, {cube, {below.x, {}}}, 1e-6,
                   contacts);
  REQUIRE(contacts.size() == 4);
  std::vector<HeldContact> held;
  for (const auto& c : contacts) held.push_back({c.feature, c.against});
  std::uint64_t iterations = 0;
  const TouchSearch search{{held, true}, 0.5e-9, 1, &iterations};
  CHECK_FALSE(time_of_contact<3>(scratch(), {cube, above}, {cube, below}, 1e-3, search));
  CHECK(iterations < 100);
  // The other way round, and a third that comes down on it.
  for (auto& h : held) std::swap(h.feature, h.against);
  CHECK_FALSE(time_of_contact<3>(scratch(), {cube, below}, {cube, above}, 1e-3,
                                 {{held, true}, 0.5e-9, 1, &iterations}));
  Motion3 third = above;
  third.x.z() += 1 + 5e-4;
  third.v.z() = -1;
  CHECK(time_of_contact<3>(scratch(), {cube, third}, {cube, above}, 1e-3, {{{}, true}, 0, 1, &iterations})
            .value() == Approx(5e-4).epsilon(1e-9));
}

TEST_CASE("a given rotation ends where it should, and its spin is its derivative") {
  const Rotation3 start = Rotation3::from_vector({0.3, -0.2, 1}),
                  end = Rotation3::from_vector({0.31, -0.17, 1.02});
  const GivenRotation path = GivenRotation::between(start, {1, 2, -3}, end, 0.01);
  CHECK((path.at(0.01).rotation.matrix() - end.matrix()).norm() < 1e-15);
  CHECK((path.at(0).spin - Vec3(1, 2, -3)).norm() < 1e-15);
  for (const double t : {0.0, 0.002, 0.01, 0.3}) {
    const double h = 1e-6;
    const Vec3 spin = (path.at(t + h).rotation * path.at(t - h).rotation.inverse()).vector() / (2 * h);
    CHECK((spin - path.at(t).spin).norm() < 1e-8 * (1 + spin.norm()));
    CHECK(path.at(t).spin.norm() <= path.greatest_spin(t) * (1 + 1e-12));
    CHECK((path.at(t + h).spin - path.at(t - h).spin).norm() / (2 * h) <=
          path.greatest_spin_rate(t + h) * (1 + 1e-6));
  }
}

}  // namespace time_of_contact3_test
