// Where paths first touch stems, against closed forms, fine sampling and a search of all stems.
#include "geometry/forest.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "math/polynomial.h"
#include "random/stream.h"
#include "samples.h"

using namespace flyrock;

namespace {

const Stem stem_at_10{.place = {10, 0}, .radius = 0.2, .height = 20};

SpacePath straight(const Vec3& from, const Vec3& v) {
  return {.plan = {.x = {from.x(), v.x()}, .y = {from.y(), v.y()}}, .z = {from.z(), v.z()}};
}

std::vector<Stem> wood(std::uint64_t seed, std::size_t count, double side) {
  RandomStream rng(seed, "wood", {});
  std::vector<Stem> stems;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = rng.uniform(0, side), y = rng.uniform(0, side);
    stems.push_back({.place = {x, y}, .radius = rng.uniform(0.05, 0.3), .height = rng.uniform(5, 30)});
  }
  return stems;
}

const auto flat = [](const Vec2&) { return std::optional<double>(0); };
const auto none = [](int) { return false; };

bool is_inside(const SpacePath& path, double t, double radius, const Stem& stem) {
  return (path.plan.position(t) - stem.place).norm() <= radius + stem.radius &&
         evaluate(path.z, t) <= stem.height;
}

}  // namespace

TEST_CASE("a sphere touches a stem where its distance from the axis is the sum of the radii") {
  for (const double aside : {0.0, 0.3, -0.69}) {
    const auto t = first_touch(straight({0, aside, 1}, {4, 0, 0}), 10, 0.5, stem_at_10, 20);
    REQUIRE(t);
    CHECK(*t == Approx((10 - std::sqrt(0.49 - aside * aside)) / 4).epsilon(1e-14));
  }
  CHECK_FALSE(first_touch(straight({0, 0.7001, 1}, {4, 0, 0}), 10, 0.5, stem_at_10, 20));
  CHECK_FALSE(first_touch(straight({0, 0, 1}, {4, 0, 0}), 2.3, 0.5, stem_at_10, 20));
}

TEST_CASE("a rock flies over a stem, and comes down on its top") {
  CHECK_FALSE(first_touch(straight({0, 0, 20.001}, {4, 0, 0}), 10, 0.5, stem_at_10, 20));
  const auto top = first_touch(straight({0, 0, 22.5}, {4, 0, -1}), 10, 0.5, stem_at_10, 20);
  REQUIRE(top);
  CHECK(*top == Approx(2.5).epsilon(1e-14));
  const auto side = first_touch(straight({0, 0, 21}, {4, 0, -1}), 10, 0.5, stem_at_10, 20);
  REQUIRE(side);
  CHECK(*side == Approx(9.3 / 4).epsilon(1e-14));
}

TEST_CASE("a sphere that starts within reach touches the stem only if it approaches the axis") {
  CHECK(first_touch(straight({9.6, 0, 1}, {1, 0, 0}), 10, 0.5, stem_at_10, 20) == 0.0);
  CHECK_FALSE(first_touch(straight({9.6, 0, 1}, {-1, 0, 0}), 10, 0.5, stem_at_10, 20));
}

TEST_CASE("curved paths touch stems where fine samples first do") {
  RandomStream rng(11, "curves", {});
  int touched = 0;
  for (int n = 0; n < 2000; ++n) {
    SpacePath path;
    for (std::size_t k = 0; k < 6; ++k) {
      const double scale = k == 0 ? 8 : 8 / static_cast<double>(k * k);
      path.plan.x[k] = rng.uniform(-scale, scale);
      path.plan.y[k] = rng.uniform(-scale, scale);
      path.z[k] = rng.uniform(-scale, scale);
    }
    const Stem stem{.place = {rng.uniform(-4, 4), rng.uniform(-4, 4)}, .radius = 0.3, .height = 1};
    if (is_inside(path, 0, 0.5, stem)) continue;
    const auto t = first_touch(path, 1, 0.5, stem, 1);
    double sampled = 2;
    for (int i = 0; i <= 20000 && sampled > 1; ++i)
      if (is_inside(path, i / 20000.0, 0.5, stem)) sampled = i / 20000.0;
    if (sampled <= 1) {
      ++touched;
      REQUIRE(t);
      CHECK(*t <= sampled + 1e-12);
      CHECK(*t >= sampled - 1 / 20000.0 - 1e-12);
    } else if (t) {  // shorter than a sample
      CHECK(is_inside(path, *t + 1e-9, 0.5 + 1e-6, {stem.place, stem.radius, 1 + 1e-6}));
    }
  }
  CHECK(touched > 40);
}

TEST_CASE("the grid finds the same first stem as a search of all") {
  const Forest forest(wood(3, 5000, 300));
  RandomStream rng(5, "paths", {});
  int touched = 0;
  for (int n = 0; n < 500; ++n) {
    SpacePath path = straight({rng.uniform(-20, 320), rng.uniform(-20, 320), rng.uniform(0, 60)},
                              {rng.uniform(-30, 30), rng.uniform(-30, 30), rng.uniform(-5, 15)});
    path.z[2] = -4.905;
    if (n % 2) path.plan.x[2] = rng.uniform(-3, 3), path.plan.y[2] = rng.uniform(-3, 3);
    const double end = rng.uniform(0.1, 6), radius = rng.uniform(0.1, 2);
    std::optional<Forest::Touch> slow;
    for (std::size_t i = 0; i < forest.stems().size(); ++i) {
      const auto t = first_touch(path, end, radius, forest.stems()[i], forest.stems()[i].height);
      if (t && (!slow || *t < slow->time)) slow = Forest::Touch{*t, static_cast<int>(i)};
    }
    const auto fast = forest.first(path, end, radius, flat, none);
    REQUIRE(fast.has_value() == slow.has_value());
    if (!fast) continue;
    ++touched;
    CHECK(fast->time == slow->time);
    CHECK(fast->tree == slow->tree);
  }
  CHECK(touched > 100);
}

TEST_CASE("hits a metre of path are stems a m2 times the diameter of a stem and of the rock") {
  // 1e5 stems of 0.4 m on 1600 m x 1600 m, and rocks of 1 m on straight flat paths through all of it.
  constexpr double side = 1600, count = 1e5, radius = 0.5;
  std::vector<Stem> stems = wood(8, static_cast<std::size_t>(count), side);
  for (Stem& stem : stems) stem.radius = 0.2, stem.height = 20;
  const Forest forest(std::move(stems));
  RandomStream rng(9, "lines", {});
  int hits = 0;
  double length = 0;
  std::vector<int> hit;
  while (hits < samples(100'000)) {
    const double y = rng.uniform(1, side - 1), from = -2, to = side + 2;
    const SpacePath path = straight({from, y, 1}, {20, 0, 0});
    hit.clear();
    const auto known = [&](int tree) { return std::find(hit.begin(), hit.end(), tree) != hit.end(); };
    while (const auto touch = forest.first(path, (to - from) / 20, radius, flat, known))
      hit.push_back(touch->tree);
    hits += static_cast<int>(hit.size());
    length += side;
  }
  const double expected = count / (side * side) * (0.4 + 2 * radius);
  CHECK(hits / length == Approx(expected).epsilon(0.02));
}

TEST_CASE("polynomials of degree 10 fall where their factors say") {
  // (t - 0.1)(t - 0.2)...(t - 1) is positive at 0, and falls at 0.1, 0.3, ...
  std::array<double, 11> c{1};
  for (int root = 1; root <= 10; ++root) {
    std::array<double, 11> next{};
    for (std::size_t k = 0; k < 10; ++k) {
      next[k] -= 0.1 * root * c[k];
      next[k + 1] += c[k];
    }
    c = next;
  }
  CHECK(first_fall(c, 0, 1).value() == Approx(0.1).epsilon(1e-10));
  CHECK(first_fall(c, 0.15, 1).value() == Approx(0.3).epsilon(1e-9));
  CHECK(first_fall(c, 0.85, 1).value() == Approx(0.9).epsilon(1e-8));
}
